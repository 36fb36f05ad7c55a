#include "render/stage_renderer.h"

#include "base/geometry.h"
#include "render/gl_program.h"

#include <GLES3/gl3.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <string>

namespace coif {
namespace {

constexpr char kBackdropVertex[] = R"glsl(#version 300 es
out float height;
void main() {  // one triangle that covers the picture
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  height = 0.5 * corner.y + 0.5;
  gl_Position = vec4(corner, 0.0, 1.0);
})glsl";

constexpr char kBackdropFragment[] = R"glsl(#version 300 es
precision highp float;
uniform vec3 bottom;
uniform vec3 top;
in float height;
out vec4 fragment;
void main() { fragment = vec4(mix(bottom, top, smoothstep(0.0, 1.0, height)), 1.0); }
)glsl";

constexpr char kBodyVertex[] = R"glsl(#version 300 es
uniform mat4 clip_from_world;
uniform mat4 world_from_head;
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 head_normal;
out vec3 normal;
out vec3 place;
void main() {
  normal = mat3(world_from_head) * head_normal;
  vec4 world = world_from_head * vec4(position, 1.0);
  place = world.xyz;
  gl_Position = clip_from_world * world;
})glsl";

constexpr char kPreamble[] = "#version 300 es\nprecision highp float;\nprecision highp int;\n";

constexpr char kNoShadow[] = "float key_light(vec3 place, vec3 n, float cosine) { return 1.0; }\n";

// A surface is looked up a little above itself: light that grazes it would find it in shadow. Where it turns away it is its
// own shadow, whose edge in the map has the steps of texels: it fades before.
constexpr char kShadow[] = R"glsl(
uniform mat4 map_from_world;
uniform vec4 shadow_depth;
uniform vec4 shadow_map;
float key_light(vec3 place, vec3 n, float cosine) {
  vec4 on_map = map_from_world * vec4(place + n * shadow_map.w, 1.0);
  return smoothstep(0.0, 0.3, cosine) * hair_light(on_map, hair_slope(on_map), shadow_depth, shadow_map);
}
)glsl";

constexpr char kBodyFragment[] = R"glsl(
uniform vec3 color;
uniform vec3 light_direction[8];
uniform vec3 light_color[8];
uniform int light_count;
uniform vec2 clay;  // ambient, wrap
in vec3 normal;
in vec3 place;
out vec4 fragment;
void main() {
  vec3 n = normalize(gl_FrontFacing ? normal : -normal);
  vec3 light = vec3(clay.x);
  float key = key_light(place, n, dot(n, light_direction[0]));
  for (int i = 0; i < light_count; ++i) {
    light += (i == 0 ? key : 1.0) * light_color[i] * max((1.0 - clay.y) * dot(n, light_direction[i]) + clay.y, 0.0);
  }
  fragment = vec4(color * light, 1.0);
})glsl";

/// Returns the vertex array.
GLuint upload(const SolidMesh& mesh, std::uint32_t (&buffers)[2]) {
  GLuint array = 0;
  glGenVertexArrays(1, &array);
  glGenBuffers(2, buffers);
  glBindVertexArray(array);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(SolidVertex)),
               mesh.vertices.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.triangles.size() * sizeof(std::uint32_t)),
               mesh.triangles.data(), GL_STATIC_DRAW);
  static_assert(sizeof(SolidVertex) == 6 * sizeof(float));
  const GLsizei stride = sizeof(SolidVertex);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride, nullptr);
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, stride, reinterpret_cast<const void*>(3 * sizeof(float)));
  glEnableVertexAttribArray(0);
  glEnableVertexAttribArray(1);
  glBindVertexArray(0);
  return array;
}

Eigen::Matrix4f matrix_of(const HeadPose& pose) {
  const Quat& q = pose.rotation;
  Eigen::Affine3f world_from_head = Eigen::Affine3f::Identity();
  world_from_head.linear() = pose.scale * Eigen::Quaternionf(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
  world_from_head.translation() = Eigen::Map<const Eigen::Vector3d>(pose.position).cast<float>();
  return world_from_head.matrix();
}

void set_lights(GLuint program, std::span<const Light> lights) {
  float direction[kMaxLights][3] = {};
  float color[kMaxLights][3] = {};
  const std::size_t count = std::min<std::size_t>(lights.size(), kMaxLights);
  for (std::size_t i = 0; i < count; ++i) {
    Eigen::Map<Eigen::Vector3f>{direction[i]} = to_eigen(lights[i].from).normalized();
    Eigen::Map<Eigen::Vector3f>{color[i]} = to_eigen(lights[i].color);
  }
  glUniform3fv(glGetUniformLocation(program, "light_direction"), kMaxLights, direction[0]);
  glUniform3fv(glGetUniformLocation(program, "light_color"), kMaxLights, color[0]);
  glUniform1i(glGetUniformLocation(program, "light_count"), static_cast<GLint>(count));
  glUniform2f(glGetUniformLocation(program, "clay"), kClayAmbient, kClayWrap);
}

/// Once, before the first draw: two kinds of samplers on one unit are an error, whether they are read or not.
void set_shadow_units(GLuint program, const HairShadow& shadow) {
  glUseProgram(program);
  for (GLuint i = 0; i < HairShadow::kTextures; ++i) {
    if (shadow.sampler(i) != nullptr) glUniform1i(glGetUniformLocation(program, shadow.sampler(i)), GLint(i));
  }
  glUseProgram(0);
}

void set_shadow(GLuint program, const HairShadow& shadow) {
  const ShadowUniforms uniforms = shadow.uniforms({});
  glUniformMatrix4fv(glGetUniformLocation(program, "map_from_world"), 1, GL_FALSE, uniforms.map_from_origin);
  glUniform4fv(glGetUniformLocation(program, "shadow_depth"), 1, uniforms.depth);
  glUniform4fv(glGetUniformLocation(program, "shadow_map"), 1, uniforms.map);
  for (GLuint i = 0; i < HairShadow::kTextures; ++i) {
    if (shadow.sampler(i) == nullptr) continue;
    glActiveTexture(GL_TEXTURE0 + i);
    glBindTexture(GL_TEXTURE_2D, shadow.texture(i));
  }
  glActiveTexture(GL_TEXTURE0);
}

tl::expected<GLuint, ToolError> build_body(const HairShadow* shadow) {
  std::vector<const char*> fragment{kPreamble};
  if (shadow != nullptr) fragment.insert(fragment.end(), shadow->code().begin(), shadow->code().end());
  fragment.push_back(shadow != nullptr ? kShadow : kNoShadow);
  fragment.push_back(kBodyFragment);
  return build_gl_program(kBodyVertex, fragment);
}

}  // namespace

tl::expected<StageRenderer, ToolError> StageRenderer::create(std::span<const SolidMesh> meshes,
                                                             const HairShadow* shadow) {
  const char* const backdrop_fragment = kBackdropFragment;
  const auto backdrop = build_gl_program(kBackdropVertex, {&backdrop_fragment, 1});
  if (!backdrop) return tl::unexpected(backdrop.error());
  const auto body_program = build_body(shadow);
  if (!body_program) return tl::unexpected(body_program.error());

  StageRenderer stage;
  stage.backdrop_program_ = *backdrop;
  stage.body_program_ = *body_program;
  if (shadow != nullptr) set_shadow_units(*body_program, *shadow);
  glGenVertexArrays(1, &stage.empty_vertex_array_);
  for (const SolidMesh& mesh : meshes) {
    Body& body = stage.bodies_.emplace_back();
    body.vertex_array = upload(mesh, body.buffers);
    body.index_count = static_cast<std::int32_t>(mesh.triangles.size());
    body.color = mesh.color;
  }
  return stage;
}

void StageRenderer::destroy() {
  for (const Body& body : bodies_) {
    glDeleteVertexArrays(1, &body.vertex_array);
    glDeleteBuffers(2, body.buffers);
  }
  bodies_.clear();
  glDeleteVertexArrays(1, &empty_vertex_array_);
  glDeleteProgram(backdrop_program_);
  glDeleteProgram(body_program_);
}

void StageRenderer::draw_backdrop() const {
  glDepthMask(GL_TRUE);
  glClear(GL_DEPTH_BUFFER_BIT);
  glDisable(GL_DEPTH_TEST);
  glUseProgram(backdrop_program_);
  glUniform3fv(glGetUniformLocation(backdrop_program_, "bottom"), 1, kBackdropBottom.data());
  glUniform3fv(glGetUniformLocation(backdrop_program_, "top"), 1, kBackdropTop.data());
  glBindVertexArray(empty_vertex_array_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void StageRenderer::set_placement(const Eigen::Matrix4f& clip_from_world, const HeadPose& head) const {
  const auto set_matrix = [&](const char* name, const Eigen::Matrix4f& matrix) {
    glUniformMatrix4fv(glGetUniformLocation(body_program_, name), 1, GL_FALSE, matrix.data());
  };
  glUseProgram(body_program_);
  set_matrix("clip_from_world", clip_from_world);
  set_matrix("world_from_head", matrix_of(head));
}

void StageRenderer::draw_meshes() const {
  for (const Body& body : bodies_) {
    glUniform3fv(glGetUniformLocation(body_program_, "color"), 1, body.color.data());
    glBindVertexArray(body.vertex_array);
    glDrawElements(GL_TRIANGLES, body.index_count, GL_UNSIGNED_INT, nullptr);
  }
  glBindVertexArray(0);
}

void StageRenderer::draw_bodies(const Camera& camera, const HeadPose& head, std::span<const Light> lights,
                                const HairShadow* shadow) const {
  glEnable(GL_DEPTH_TEST);
  set_placement(camera.clip_from_world, head);
  set_lights(body_program_, lights);
  if (shadow != nullptr) set_shadow(body_program_, *shadow);
  draw_meshes();
}

// A framebuffer without colour ignores what the shader says of it.
void StageRenderer::draw_casters(const Eigen::Matrix4f& clip_from_world, const HeadPose& head) const {
  set_placement(clip_from_world, head);
  draw_meshes();
}

}  // namespace coif
