#include "render/debug_overlay.h"

#include "render/gl_program.h"

#include <GLES3/gl3.h>

#include <Eigen/Core>

#include <string>

namespace coif::render {
namespace {

constexpr char kLineVertex[] = R"glsl(#version 300 es
layout(location = 0) in vec2 place;
layout(location = 1) in vec3 line_color;
out vec3 color;
void main() {
  color = line_color;
  gl_Position = vec4(place, 0.0, 1.0);
})glsl";

constexpr char kLineFragment[] = R"glsl(#version 300 es
precision highp float;
in vec3 color;
out vec4 fragment;
void main() { fragment = vec4(color, 1.0); }
)glsl";

struct LineVertex {
  Eigen::Vector2f place;
  Eigen::Vector3f color;
};
static_assert(sizeof(LineVertex) == 5 * sizeof(float));

constexpr float kNearestW = 1e-3f;  // metres before the eye, where lines are cut off

/// False for one that is behind the eye.
bool cut(Eigen::Vector4f& from, Eigen::Vector4f& to) {
  if (from.w() < kNearestW && to.w() < kNearestW) return false;
  const auto cut_first = [](Eigen::Vector4f& a, const Eigen::Vector4f& b) {
    if (a.w() < kNearestW) a += (kNearestW - a.w()) / (b.w() - a.w()) * (b - a);
  };
  cut_first(from, to);
  cut_first(to, from);
  return true;
}

/// A line as two triangles of its thickness: OpenGL ES promises lines of one pixel, which are too thin in fine
/// pictures.
void add_line(const Camera& camera, const DebugLine& line, const Eigen::Vector2f& pixel, float thickness,
              std::vector<LineVertex>& vertices) {
  const auto in_clip = [&](const double(&p)[3]) -> Eigen::Vector4f {
    return camera.clip_from_world * Eigen::Vector4f(float(p[0]), float(p[1]), float(p[2]), 1);
  };
  Eigen::Vector4f from = in_clip(line.from), to = in_clip(line.to);
  if (!cut(from, to)) return;
  const Eigen::Vector2f a = from.head<2>() / from.w(), b = to.head<2>() / to.w();
  Eigen::Vector2f along = (b - a).cwiseQuotient(pixel);
  along = along.norm() > 0 ? Eigen::Vector2f(along.normalized()) : Eigen::Vector2f(Eigen::Vector2f::UnitX());
  const Eigen::Vector2f aside = 0.5f * thickness * Eigen::Vector2f(-along.y(), along.x()).cwiseProduct(pixel);
  const Vec3 rgb = debug_color(line.kind);
  const Eigen::Vector3f color(rgb.x, rgb.y, rgb.z);
  for (const Eigen::Vector2f& corner :
       {Eigen::Vector2f(a - aside), Eigen::Vector2f(a + aside), Eigen::Vector2f(b + aside), Eigen::Vector2f(a - aside),
        Eigen::Vector2f(b + aside), Eigen::Vector2f(b - aside)}) {
    vertices.push_back({corner, color});
  }
}

/// Bodies in pictures do not move: they stand as modelled, upright beneath the head's joint.
Status draw_resting_body(const Asset& asset, const HeadPose& head, const DebugLines& sink) {
  std::vector<DebugCollider> colliders;
  for (const ColliderRecord& record : asset.body_colliders()) colliders.push_back(debug_collider(record));
  HeadPose upright = head;
  upright.rotation = {};
  return draw_collider_lines(colliders, upright, sink, std::uint32_t(asset.colliders().size()));
}

}  // namespace

tl::expected<std::vector<DebugLine>, ToolError> debug_lines_of(const Asset& asset, const HairInstance& head,
                                                               const DebugView& view) {
  std::vector<DebugLine> lines;
  const DebugLines sink{
      [](const DebugLine& line, void* user) { static_cast<std::vector<DebugLine>*>(user)->push_back(line); }, &lines};
  Status status = Status::kOk;
  if (view.colliders) {
    status = draw_collider_lines(asset, head.head, sink);
    if (status == Status::kOk) status = draw_resting_body(asset, head.head, sink);
  }
  if (status == Status::kOk && view.limits) status = draw_limit_lines(asset, head, sink);
  if (status == Status::kOk && view.bones) status = draw_bone_lines(asset, head, sink);
  if (status == Status::kOk && view.contacts) status = draw_contact_lines(asset, head, sink);
  if (status == Status::kOk) return lines;
  return failure(ToolError::Kind::kInternal, std::string("no lines of the hair: ") + describe(status));
}

tl::expected<LineOverlay, ToolError> LineOverlay::create() {
  const char* const fragment = kLineFragment;
  const auto program = build_gl_program(kLineVertex, {&fragment, 1});
  if (!program) return tl::unexpected(program.error());
  LineOverlay overlay;
  overlay.program_ = *program;
  glGenVertexArrays(1, &overlay.vertex_array_);
  glGenBuffers(1, &overlay.buffer_);
  glBindVertexArray(overlay.vertex_array_);
  glBindBuffer(GL_ARRAY_BUFFER, overlay.buffer_);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(LineVertex), nullptr);
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(LineVertex), reinterpret_cast<const void*>(2 * sizeof(float)));
  glEnableVertexAttribArray(0);
  glEnableVertexAttribArray(1);
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  return overlay;
}

void LineOverlay::draw(const Camera& camera, std::span<const DebugLine> lines, std::uint32_t width,
                       std::uint32_t height, float thickness) const {
  const Eigen::Vector2f pixel(2 / float(width), 2 / float(height));
  std::vector<LineVertex> vertices;
  for (const DebugLine& line : lines) add_line(camera, line, pixel, thickness, vertices);
  glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertices.size() * sizeof(LineVertex)), vertices.data(), GL_STREAM_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glUseProgram(program_);
  glBindVertexArray(vertex_array_);
  glDrawArrays(GL_TRIANGLES, 0, GLsizei(vertices.size()));
  glBindVertexArray(0);
  glUseProgram(0);
}

tl::expected<void, ToolError> draw_over(const Camera& camera, std::span<const DebugLine> lines, std::uint32_t width,
                                        std::uint32_t height, float thickness) {
  const auto overlay = LineOverlay::create();
  if (!overlay) return tl::unexpected(overlay.error());
  overlay->draw(camera, lines, width, height, thickness);
  return {};
}

}  // namespace coif::render
