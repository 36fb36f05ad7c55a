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
out vec2 spot;  // -1..1 in the picture
void main() {  // one triangle that covers the picture
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  spot = corner;
  gl_Position = vec4(corner, 0.0, 1.0);
})glsl";

constexpr char kBackdropFragment[] = R"glsl(#version 300 es
precision highp float;
uniform vec3 bottom;
uniform vec3 top;
uniform vec3 glow;
uniform vec2 veil;  // vignette, opacity
in vec2 spot;
out vec4 fragment;
void main() {
  vec3 color = mix(bottom, top, smoothstep(0.0, 1.0, 0.5 * spot.y + 0.5));
  float from_middle = dot(spot, spot);
  color += glow * exp(-1.8 * from_middle);
  color *= 1.0 - veil.x * smoothstep(0.0, 2.0, from_middle);
  fragment = vec4(color, 1.0) * veil.y;
}
)glsl";

constexpr char kBodyVertex[] = R"glsl(#version 300 es
uniform mat4 clip_from_world;
uniform mat4 world_from_head;
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 head_normal;
layout(location = 2) in vec2 texture_place;
out vec2 uv;
out vec3 normal;
out vec3 place;
void main() {
  uv = texture_place;
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

// Matte, and what a smooth surface mirrors: Blinn and Phong's highlight with Schlick's approximation of Fresnel's share.
constexpr char kBodyFragment[] = R"glsl(
uniform sampler2D base;
uniform vec3 color;
uniform vec2 surface;  // least alpha, roughness
uniform vec3 eye;
uniform vec3 light_direction[8];
uniform vec3 light_color[8];
uniform int light_count;
uniform vec4 look;  // ambient, wrap, bleed, gloss
in vec3 normal;
in vec3 place;
in vec2 uv;
out vec4 fragment;

float mirrored(vec3 n, vec3 view, vec3 towards, float roughness) {
  vec3 h = normalize(view + towards + 1e-4 * n);
  float exponent = 2.0 / max(roughness * roughness * roughness * roughness, 1e-3);
  float away = 1.0 - max(dot(h, view), 0.0);
  float reflected = 0.04 + 0.96 * away * away * away * away * away;
  return reflected * (exponent + 2.0) / 8.0 * pow(max(dot(n, h), 0.0), exponent) * max(dot(n, towards), 0.0);
}

void main() {
  vec4 texel = texture(base, uv);
  vec3 n = normalize(gl_FrontFacing ? normal : -normal);
  vec3 view = normalize(eye - place);
  vec3 around = clamp(look.y + look.z * vec3(1.0, 0.35, 0.2), 0.0, 0.9);
  vec3 light = vec3(look.x), shine = vec3(0.0);
  float key = key_light(place, n, dot(n, light_direction[0]));
  for (int i = 0; i < light_count; ++i) {
    vec3 arriving = (i == 0 ? key : 1.0) * light_color[i];
    light += arriving * max((1.0 - around) * dot(n, light_direction[i]) + around, 0.0);
    if (look.w > 0.0) shine += arriving * mirrored(n, view, light_direction[i], surface.y);
  }
  if (texel.a < surface.x) discard;
  fragment = vec4(color * texel.rgb * light + look.w * shine, 1.0);
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
  std::vector<const char*> fragment{kPreamble};
  if (shadow != nullptr) fragment.insert(fragment.end(), shadow->code().begin(), shadow->code().end());
  fragment.push_back(shadow != nullptr ? kShadow : kNoShadow);
  fragment.push_back(kBodyFragment);
  return build_gl_program(kBodyVertex, fragment);
}

}  // namespace

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
  }
  return stage;
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

void StageRenderer::draw_meshes() const {
  glActiveTexture(GL_TEXTURE0 + GLenum(kBaseTextureUnit));
  for (const Body& body : bodies_) {
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

// A framebuffer without colour ignores what the shader says of it.
void StageRenderer::draw_casters(const Eigen::Matrix4f& clip_from_world, const HeadPose& head) const {
  set_placement(clip_from_world, head);
  draw_meshes();
}

}  // namespace coif
