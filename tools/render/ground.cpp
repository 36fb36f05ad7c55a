#include "render/ground.h"

#include "base/hair_runtime.h"
#include "render/gl_program.h"

#include <GLES3/gl3.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace coif::render {
namespace {

using Eigen::Vector3f;

constexpr char kGroundVertex[] = R"glsl(#version 300 es
uniform mat4 clip_from_world;
uniform vec4 square;  // middle, half a side
out vec2 uv;
void main() {
  vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));
  uv = corner;
  vec2 aside = square.w * (2.0 * corner - 1.0);
  gl_Position = clip_from_world * vec4(square.x + aside.x, square.y, square.z + aside.y, 1.0);
})glsl";

constexpr char kGroundFragment[] = R"glsl(#version 300 es
precision highp float;
uniform sampler2D shade;
in vec2 uv;
out vec4 fragment;
void main() { fragment = vec4(0.0, 0.0, 0.0, texture(shade, uv).r); }
)glsl";

constexpr float kDarkest = 0.72f;
constexpr float kReach =
    0.32f;  // Share of the body's height: the reach of its shade, and the largest height of casters.

/// A piece of surface above the ground.
struct Caster {
  Vector3f place;
  float area = 0;
};

std::vector<Caster> casters_of(std::span<const SolidMesh> meshes, const Eigen::Quaternionf& turn) {
  std::vector<Caster> casters;
  for (const SolidMesh& mesh : meshes) {
    for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
      std::array<Vector3f, 3> p;
      for (std::size_t k = 0; k < 3; ++k) p[k] = turn * mesh.vertices[mesh.triangles[i + k]].position;
      // From above: walls hide little of the sky.
      const float area = 0.5f * std::abs((p[1] - p[0]).cross(p[2] - p[0]).y());
      casters.push_back({(p[0] + p[1] + p[2]) / 3, area});
    }
  }
  return casters;
}

Eigen::AlignedBox3f box_of(std::span<const SolidMesh> meshes, const Eigen::Quaternionf& turn) {
  Eigen::AlignedBox3f box;
  for (const SolidMesh& mesh : meshes) {
    for (const SolidVertex& vertex : mesh.vertices) box.extend(turn * vertex.position);
  }
  return box;
}

/// Adds the part of the sky that a caster hides, spread as widely as it is high.
void spread(const Caster& caster, float height, float tall, const GroundShade& shade, std::vector<float>& hidden) {
  constexpr auto kSide = int(GroundShade::kSide);
  const float radius = 0.016f * tall + 0.75f * height, texel = 2 * shade.half / float(kSide);
  const float weight = caster.area / (3.14f * radius * radius) * (1 - height / (kReach * tall));
  const float x = (caster.place.x() - shade.middle.x() + shade.half) / texel;
  const float z = (caster.place.z() - shade.middle.z() + shade.half) / texel;
  const auto wide = int(std::ceil(2 * radius / texel));
  for (int row = std::max(int(z) - wide, 0); row <= std::min(int(z) + wide, kSide - 1); ++row) {
    for (int column = std::max(int(x) - wide, 0); column <= std::min(int(x) + wide, kSide - 1); ++column) {
      const float dx = (float(column) + 0.5f - x) * texel, dz = (float(row) + 0.5f - z) * texel;
      const float away = (dx * dx + dz * dz) / (radius * radius);
      if (away < 4) hidden[std::size_t(row) * kSide + std::size_t(column)] += weight * std::exp(-away);
    }
  }
}

/// 1 in the square's middle, 0 from its edges on.
float inside(std::size_t k) {
  const auto from_middle = [](std::size_t i) { return std::abs((float(i) + 0.5f) / GroundShade::kSide * 2 - 1); };
  const float away = std::hypot(from_middle(k % GroundShade::kSide), from_middle(k / GroundShade::kSide));
  const float t = std::clamp((1 - away) / 0.4f, 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

}  // namespace

GroundShade shade_below(std::span<const SolidMesh> meshes, const HeadPose& head) {
  const Eigen::Quaternionf turn(head.rotation.w, head.rotation.x, head.rotation.y, head.rotation.z);
  const Eigen::AlignedBox3f box = box_of(meshes, turn);
  GroundShade shade;
  if (box.isEmpty() || !(box.sizes().y() > 0)) return shade;
  const float tall = box.sizes().y(), ground = box.min().y();
  std::vector<Caster> casters = casters_of(meshes, turn);
  std::erase_if(casters, [&](const Caster& c) { return !(c.place.y() - ground < kReach * tall && c.area > 0); });
  Eigen::AlignedBox3f low;
  for (const Caster& caster : casters) low.extend(caster.place);
  if (low.isEmpty()) return shade;
  shade.middle = Vector3f(low.center().x(), ground, low.center().z());
  shade.half = 0.5f * low.sizes().maxCoeff() + kReach * tall;
  shade.head_height = -ground / std::max(box.max().y(), 1e-3f * tall);
  std::vector<float> hidden(std::size_t{GroundShade::kSide} * GroundShade::kSide, 0.0f);
  for (const Caster& caster : casters) spread(caster, caster.place.y() - ground, tall, shade, hidden);
  for (std::size_t k = 0; k < hidden.size(); ++k)
    shade.opacity.push_back(std::uint8_t(255 * kDarkest * inside(k) * (1 - std::exp(-2.2f * hidden[k])) + 0.5f));
  return shade;
}

bool shows_ground(GroundChoice choice, const GroundShade& shade, const Camera& camera, const Eigen::Vector3d& place) {
  // A bust's joint is some three heights of its upper part above where it is cut, a person's six.
  constexpr float kOfWholeBody = 4;
  if (choice == GroundChoice::kNever || shade.half == 0) return false;
  if (choice == GroundChoice::kAlways) return true;
  const Vector3f at = place.cast<float>() + shade.middle;
  const Eigen::Vector4f clip = camera.clip_from_world * at.homogeneous();
  return shade.head_height > kOfWholeBody && clip.w() > 0 && std::abs(clip.x()) < clip.w() &&
         std::abs(clip.y()) < clip.w();
}

tl::expected<GroundRenderer, ToolError> GroundRenderer::create(const GroundShade& shade) {
  const char* const fragment = kGroundFragment;
  const auto program = build_gl_program(kGroundVertex, {&fragment, 1});
  if (!program) return tl::unexpected(program.error());
  GroundRenderer ground;
  ground.middle_ = shade.middle;
  ground.half_ = shade.half;
  ground.program_ = *program;
  glGenVertexArrays(1, &ground.vertex_array_);
  glGenTextures(1, &ground.texture_);
  glBindTexture(GL_TEXTURE_2D, ground.texture_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, GLsizei(GroundShade::kSide), GLsizei(GroundShade::kSide), 0, GL_RED,
               GL_UNSIGNED_BYTE, shade.opacity.data());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    glTexParameteri(GL_TEXTURE_2D, axis, GL_CLAMP_TO_EDGE);
  glBindTexture(GL_TEXTURE_2D, 0);
  return ground;
}

void GroundRenderer::draw(const Camera& camera, const Eigen::Vector3d& place) const {
  const Vector3f at = place.cast<float>() + middle_;
  if (camera.eye.y() <= double(at.y())) return;
  glUseProgram(program_);
  glUniformMatrix4fv(glGetUniformLocation(program_, "clip_from_world"), 1, GL_FALSE, camera.clip_from_world.data());
  glUniform4f(glGetUniformLocation(program_, "square"), at.x(), at.y(), at.z(), half_);
  glUniform1i(glGetUniformLocation(program_, "shade"), 0);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glBindVertexArray(vertex_array_);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glBindVertexArray(0);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
  glBindTexture(GL_TEXTURE_2D, 0);
  glUseProgram(0);
}

}  // namespace coif::render
