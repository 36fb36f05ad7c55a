#pragma once

#include <coif/shadow.h>

#include <cstdint>

namespace coif {

/// What a program needs that looks shadows up. The renderer reaches all of a shadow through this, so that it holds none of
/// it where no shadow is named.
struct ShadowLookup {
  std::uint32_t id;       ///< Of the programs that it is part of, 1..3.
  const char* pieces[2];  ///< GLSL: a line that defines what the other depends on; hair_light().
  const char* samplers[HairShadow::kTextures];
  ShadowUniforms (*uniforms)(const HairShadow& shadow, const Vec3& origin);
};

}  // namespace coif
