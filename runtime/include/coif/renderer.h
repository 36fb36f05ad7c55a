#pragma once

#include <coif/asset.h>
#include <coif/math.h>
#include <coif/status.h>

#include <cstdint>
#include <span>

namespace coif {

/// The host's way to find an OpenGL ES 3.0 function: eglGetProcAddress or the like. Must return null for unknown names.
struct GlLoader {
  void* (*get_proc)(const char* name, void* user) = nullptr;
  void* user = nullptr;
};

inline constexpr std::uint32_t kMaxLights = 8;

struct Light {
  enum class Kind : std::uint8_t { kDirectional, kPoint } kind = Kind::kDirectional;
  Vec3 position;          ///< kDirectional: towards the light, any length > 0. kPoint: world, metres.
  Vec3 color{1, 1, 1};    ///< Linear. kPoint: at one metre, falling with the square of the distance.
};

/// What of Algorithm 3 is drawn; the six pictures of the thesis's Gallery 1.
enum class Component : std::uint8_t { kAll, kAmbient, kDiffuse, kSpecular, kPrimary, kSecondary };

struct DrawDesc {
  float clip_from_world[16] = {};  ///< Column-major, OpenGL clip space.
  Vec3 eye;                        ///< World, metres.
  HeadPose head;                   ///< World from head space.
  std::span<const Mat34> palette;  ///< From Hair::palette(); as many as the asset has bones.
  std::span<const Light> lights;   ///< At most kMaxLights.
  Component component = Component::kAll;
  /// Replaces the asset's material when not null; must stay valid during the call.
  const MaterialRecord* material = nullptr;
  /// False: everything drawn once, without blending, cut at the opaque threshold.
  bool transparency = true;
  /// The framebuffer encodes sRGB itself (GL_SRGB8_ALPHA8). Otherwise the shader encodes.
  bool framebuffer_is_srgb = false;
};

/// Programs shared by all models of one OpenGL context. The context must be current in every call.
class HairRenderer;
/// One asset's buffers and textures on the GPU.
class HairModel;

}  // namespace coif
