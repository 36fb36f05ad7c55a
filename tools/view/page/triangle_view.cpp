#include "view/page/triangle_view.h"

#include "base/color_texels.h"
#include "base/geometry.h"
#include "render/gl_program.h"
#include "view/page/layer_count.h"

#include <GLES3/gl3.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace coif::view {
namespace {

constexpr char kVertex[] = R"glsl(#version 300 es
uniform mat4 clip_from_head;
layout(location = 0) in vec3 position;
layout(location = 1) in vec2 corner_uv;
layout(location = 2) in vec4 corner_color;
out vec2 uv;
flat out vec3 color;
vec3 linear(vec3 srgb) {
  vec3 bright = pow((srgb + 0.055) / 1.055, vec3(2.4));
  return mix(bright, srgb / 12.92, vec3(lessThanEqual(srgb, vec3(0.04045))));
}
void main() {
  uv = corner_uv;
  color = linear(corner_color.rgb);
  gl_Position = clip_from_head * vec4(position, 1.0);
})glsl";

constexpr char kFragment[] = R"glsl(#version 300 es
precision highp float;
uniform sampler2D base;  // without one: alpha 1
uniform vec2 alpha;      // the material's own, the least that is hair
uniform float count;     // 0: colours
in vec2 uv;
flat in vec3 color;
out vec4 fragment;
void main() {
  if (texture(base, uv).a * alpha.x < alpha.y) discard;
  fragment = count > 0.0 ? vec4(count) : vec4(color, 1.0);
})glsl";

Eigen::Matrix4f world_from_head(const HeadPose& pose) {
  const Quat& q = pose.rotation;
  Eigen::Affine3f world = Eigen::Affine3f::Identity();
  world.linear() = pose.scale * Eigen::Quaternionf(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
  world.translation() = Eigen::Map<const Eigen::Vector3d>(pose.position).cast<float>();
  return world.matrix();
}

/// Textures of strips that tile repeat; elsewhere that would blend the roots' row of texels into the tips.
GLint wrap_of(const Asset& asset) {
  constexpr float kSlack = 1e-3f;
  for (const VertexRecord& vertex : asset.vertices()) {
    for (const float place : vertex.uv) {
      if (place < -kSlack || place > 1 + kSlack) return GL_REPEAT;
    }
  }
  return GL_CLAMP_TO_EDGE;
}

void set_state(const TrianglePass& pass) {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);  // Among cards in one place the later one wins, as in HairRenderer.
  glDepthMask(pass.counts ? GL_FALSE : GL_TRUE);
  if (!pass.both_faces) glEnable(GL_CULL_FACE);
  if (!pass.counts) return;
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
}

void leave_state() {
  glDisable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ZERO);
  glDisable(GL_CULL_FACE);
  glDisable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glBindTexture(GL_TEXTURE_2D, 0);
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glUseProgram(0);
}

/// The asset's order in which HairRenderer draws this head; none where it leaves it out.
std::optional<std::uint32_t> order_of(const DrawnHair& hair, const HairInstance& head, const render::Camera& camera) {
  Eigen::Matrix4f clip_from_view = Eigen::Matrix4f::Identity();
  clip_from_view.topRightCorner<3, 1>() = camera.eye.cast<float>();
  clip_from_view = camera.clip_from_world * clip_from_view;
  float columns[16];
  std::copy_n(clip_from_view.data(), 16, columns);
  std::optional<std::uint32_t> order;
  const VisibleCrowd crowd(hair, {&head, 1}, to_vec3(camera.eye), columns);
  crowd.for_each_group([&](const VisibleCrowd::Group& group) {
    order = group.order;
    return false;
  });
  return order;
}

}  // namespace

tl::expected<std::unique_ptr<TriangleView>, ToolError> TriangleView::create(const Asset& asset) {
  std::unique_ptr<TriangleView> view(new TriangleView(asset));
  const char* const fragment = kFragment;
  const auto program = render::build_gl_program(kVertex, {&fragment, 1});
  if (!program) return tl::unexpected(program.error());
  view->program_ = *program;
  view->make_corners();
  view->upload_texture(asset);
  return view;
}

TriangleView::~TriangleView() {
  glDeleteProgram(program_);
  glDeleteVertexArrays(1, &vertex_array_);
  glDeleteBuffers(1, &buffer_);
  glDeleteTextures(1, &texture_);
}

void TriangleView::make_corners() {
  glGenVertexArrays(1, &vertex_array_);
  glGenBuffers(1, &buffer_);
  glBindVertexArray(vertex_array_);
  glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(corners_.most() * sizeof(TriangleCorner)), nullptr, GL_STREAM_DRAW);
  const auto attribute = [](GLuint place, GLint size, GLenum type, std::size_t offset) {
    glEnableVertexAttribArray(place);
    glVertexAttribPointer(place, size, type, type == GL_UNSIGNED_BYTE, sizeof(TriangleCorner),
                          reinterpret_cast<const void*>(offset));
  };
  attribute(0, 3, GL_FLOAT, offsetof(TriangleCorner, position));
  attribute(1, 2, GL_FLOAT, offsetof(TriangleCorner, uv));
  attribute(2, 4, GL_UNSIGNED_BYTE, offsetof(TriangleCorner, color));
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void TriangleView::upload_texture(const Asset& asset) {
  const TextureRecord* const record = asset.texture(TextureRole::kBaseColor);
  if (record == nullptr) return;
  glGenTextures(1, &texture_);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap_of(asset));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap_of(asset));
  glTexStorage2D(GL_TEXTURE_2D, GLsizei(record->mip_count), GL_RGBA8, GLsizei(record->width), GLsizei(record->height));
  for (std::uint32_t mip = 0; mip < record->mip_count; ++mip) {
    const auto size = [&](std::uint32_t whole) { return GLsizei(std::max(whole >> mip, 1u)); };
    glTexSubImage2D(GL_TEXTURE_2D, GLint(mip), 0, 0, size(record->width), size(record->height), GL_RGBA,
                    GL_UNSIGNED_BYTE, color_texels(asset, *record, mip).data());
  }
  glBindTexture(GL_TEXTURE_2D, 0);
}

void TriangleView::draw(const render::Camera& camera, std::span<const HairInstance> heads, const TrianglePass& pass) {
  set_state(pass);
  glUseProgram(program_);
  glUniform2f(glGetUniformLocation(program_, "alpha"), pass.alpha, pass.least_alpha);
  glUniform1f(glGetUniformLocation(program_, "count"), pass.counts ? LayerCount::kStep : 0);
  glUniform1i(glGetUniformLocation(program_, "base"), 0);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glBindVertexArray(vertex_array_);
  glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  for (const HairInstance& head : heads) {
    const auto order = order_of(corners_.hair(), head, camera);
    if (!order) continue;
    const std::span<const TriangleCorner> corners = corners_.of(pass.view, head, *order);
    const Eigen::Matrix4f clip_from_head = camera.clip_from_world * world_from_head(head.head);
    glUniformMatrix4fv(glGetUniformLocation(program_, "clip_from_head"), 1, GL_FALSE, clip_from_head.data());
    glBufferSubData(GL_ARRAY_BUFFER, 0, GLsizeiptr(corners.size_bytes()), corners.data());
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(corners.size()));
  }
  leave_state();
}

}  // namespace coif::view
