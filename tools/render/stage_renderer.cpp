#include "render/stage_renderer.h"

#include "base/geometry.h"
#include "render/gl_program.h"
#include "render/stage_shaders.h"

#include <GLES3/gl3.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <string>

namespace coif::render {
namespace {

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
  static_assert(sizeof(SolidVertex) == 8 * sizeof(float));
  const GLsizei stride = sizeof(SolidVertex);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride, nullptr);
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, stride, reinterpret_cast<const void*>(3 * sizeof(float)));
  glVertexAttribPointer(2, 2, GL_FLOAT, GL_FALSE, stride, reinterpret_cast<const void*>(6 * sizeof(float)));
  for (const GLuint attribute : {0u, 1u, 2u}) glEnableVertexAttribArray(attribute);
  glBindVertexArray(0);
  return array;
}

GLuint upload(const SolidTexture& image) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, GLsizei(image.width), GLsizei(image.height), 0, GL_RGBA,
               GL_UNSIGNED_BYTE, image.rgba.data());
  glGenerateMipmap(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glBindTexture(GL_TEXTURE_2D, 0);
  return texture;
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
}

constexpr GLint kBaseTextureUnit = GLint(HairShadow::kTextures);

/// Once, before the first draw: two kinds of samplers on one unit are an error, whether they are read or not.
void set_units(GLuint program, const HairShadow* shadow) {
  glUseProgram(program);
  glUniform1i(glGetUniformLocation(program, "base"), kBaseTextureUnit);
  for (GLuint i = 0; shadow != nullptr && i < HairShadow::kTextures; ++i) {
    if (shadow->sampler(i) != nullptr) glUniform1i(glGetUniformLocation(program, shadow->sampler(i)), GLint(i));
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
  std::vector<const char*> fragment{kStagePreamble};
  if (shadow != nullptr) fragment.insert(fragment.end(), shadow->code().begin(), shadow->code().end());
  fragment.push_back(shadow != nullptr ? kBodyWithShadow : kBodyWithoutShadow);
  fragment.push_back(kBodyFragment);
  return build_gl_program(kBodyVertex, fragment);
}

}  // namespace

void turn_back(std::span<const float> shares, const Quat& turn, std::span<SolidVertex> vertices) {
  const Eigen::Quaternionf whole = Eigen::Quaternionf(turn.w, turn.x, turn.y, turn.z).normalized();
  Eigen::Matrix3f back = Eigen::Matrix3f::Identity();
  float share = 1;  // the one that `back` is for: neighbours mostly have the same
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (shares[i] != share) {
      share = shares[i];
      back = (whole.conjugate() * Eigen::Quaternionf::Identity().slerp(share, whole)).toRotationMatrix();
    }
    if (share == 1) continue;
    vertices[i].position = back * vertices[i].position;
    vertices[i].normal = back * vertices[i].normal;
  }
}

tl::expected<StageRenderer, ToolError> StageRenderer::create(std::span<const SolidMesh> meshes,
                                                             const HairShadow* shadow, const BodyLook& look) {
  const char* const backdrop_fragment = kBackdropFragment;
  const auto backdrop = build_gl_program(kBackdropVertex, {&backdrop_fragment, 1});
  if (!backdrop) return tl::unexpected(backdrop.error());
  const auto body_program = build_body(shadow);
  if (!body_program) return tl::unexpected(body_program.error());

  StageRenderer stage;
  stage.backdrop_program_ = *backdrop;
  stage.body_program_ = *body_program;
  stage.look_ = look;
  set_units(*body_program, shadow);
  glGenVertexArrays(1, &stage.empty_vertex_array_);
  for (const SolidMesh& mesh : meshes) {
    Body& body = stage.bodies_.emplace_back();
    body.vertex_array = upload(mesh, body.buffers);
    body.index_count = static_cast<std::int32_t>(mesh.triangles.size());
    body.texture = stage.texture_of(mesh);
    body.color = mesh.color;
    body.alpha_cutoff = mesh.alpha_cutoff;
    body.roughness = mesh.roughness;
    body.is_ghost = mesh.is_ghost;
  }
  return stage;
}

void StageRenderer::move(std::size_t mesh, std::span<const SolidVertex> vertices) const {
  glBindBuffer(GL_ARRAY_BUFFER, bodies_[mesh].buffers[0]);
  glBufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(vertices.size_bytes()), vertices.data());
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

std::uint32_t StageRenderer::texture_of(const SolidMesh& mesh) {
  const auto [known, is_new] = textures_.try_emplace(mesh.texture, 0);
  if (is_new) known->second = upload(mesh.texture ? *mesh.texture : SolidTexture{1, 1, {255, 255, 255, 255}});
  return known->second;
}

void StageRenderer::destroy() {
  for (const Body& body : bodies_) {
    glDeleteVertexArrays(1, &body.vertex_array);
    glDeleteBuffers(2, body.buffers);
  }
  bodies_.clear();
  for (const auto& [image, texture] : textures_) glDeleteTextures(1, &texture);
  textures_.clear();
  glDeleteVertexArrays(1, &empty_vertex_array_);
  glDeleteProgram(backdrop_program_);
  glDeleteProgram(body_program_);
}

void StageRenderer::draw_backdrop(const Backdrop& backdrop) const {
  glDepthMask(GL_TRUE);
  glClear(GL_DEPTH_BUFFER_BIT);
  glDisable(GL_DEPTH_TEST);
  glUseProgram(backdrop_program_);
  glUniform3fv(glGetUniformLocation(backdrop_program_, "bottom"), 1, backdrop.bottom.data());
  glUniform3fv(glGetUniformLocation(backdrop_program_, "top"), 1, backdrop.top.data());
  glUniform3fv(glGetUniformLocation(backdrop_program_, "glow"), 1, backdrop.glow.data());
  glUniform2f(glGetUniformLocation(backdrop_program_, "veil"), backdrop.vignette, backdrop.opacity);
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

void StageRenderer::draw_meshes(bool ghosts) const {
  glActiveTexture(GL_TEXTURE0 + GLenum(kBaseTextureUnit));
  for (const Body& body : bodies_) {
    if (body.is_ghost != ghosts) continue;
    glUniform3fv(glGetUniformLocation(body_program_, "color"), 1, body.color.data());
    glUniform2f(glGetUniformLocation(body_program_, "surface"), body.alpha_cutoff, body.roughness);
    glBindTexture(GL_TEXTURE_2D, body.texture);
    glBindVertexArray(body.vertex_array);
    glDrawElements(GL_TRIANGLES, body.index_count, GL_UNSIGNED_INT, nullptr);
  }
  glBindVertexArray(0);
  glBindTexture(GL_TEXTURE_2D, 0);
  glActiveTexture(GL_TEXTURE0);
}

void StageRenderer::draw_bodies(const Camera& camera, const HeadPose& head, std::span<const Light> lights,
                                const HairShadow* shadow) const {
  glEnable(GL_DEPTH_TEST);
  set_placement(camera.clip_from_world, head);
  set_lights(body_program_, lights);
  glUniform4f(glGetUniformLocation(body_program_, "look"), look_.ambient, look_.wrap, look_.bleed, look_.gloss);
  glUniform3f(glGetUniformLocation(body_program_, "eye"), float(camera.eye.x()), float(camera.eye.y()),
              float(camera.eye.z()));
  if (shadow != nullptr) set_shadow(body_program_, *shadow);
  draw_meshes();
}

void StageRenderer::cut_out_bodies(const Camera& camera, const HeadPose& head) const {
  glEnable(GL_DEPTH_TEST);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  draw_casters(camera.clip_from_world, head);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void StageRenderer::draw_ghosts(const Camera& camera, const HeadPose& head, std::span<const Light> lights) const {
  constexpr float kOpacity = 0.4f;
  if (std::none_of(bodies_.begin(), bodies_.end(), [](const Body& body) { return body.is_ghost; })) return;
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  set_placement(camera.clip_from_world, head);
  set_lights(body_program_, lights);
  glUniform4f(glGetUniformLocation(body_program_, "look"), look_.ambient, look_.wrap, look_.bleed, look_.gloss);
  // Their nearest surface first, so that only this one is blended.
  glDepthMask(GL_TRUE);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  draw_meshes(true);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendColor(0, 0, 0, kOpacity);
  glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
  draw_meshes(true);
  glDisable(GL_BLEND);
  glDepthFunc(GL_LESS);
}

// A framebuffer without colour ignores the shader's output.
void StageRenderer::draw_casters(const Eigen::Matrix4f& clip_from_world, const HeadPose& head) const {
  set_placement(clip_from_world, head);
  draw_meshes();
}

}  // namespace coif::render
