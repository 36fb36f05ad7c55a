#include "render/light_rig.h"

#include "base/srgb.h"
#include "base/studio.h"

#include <charconv>
#include <cstdint>

namespace coif::render {
namespace {

using RigLights = std::array<StudioLight, 3>;

// Hair wants its key from high, or the highlights' bands lie on the face's side of the crown; a face wants it from one
// side.
constexpr RigLights kPortrait = {{{{-0.55f, 1.0f, 0.55f}, {1.36f, 1.29f, 1.19f}},
                                  {{0.8f, 0.05f, 0.9f}, {0.22f, 0.23f, 0.26f}},
                                  {{0.75f, 0.55f, -0.9f}, {0.85f, 0.92f, 1.10f}}}};
constexpr RigLights kSun = {{{{0.6f, 0.9f, 0.35f}, {2.05f, 1.86f, 1.55f}},
                             {{-0.5f, 0.6f, 0.7f}, {0.22f, 0.29f, 0.40f}},
                             {{-0.6f, 0.5f, -0.8f}, {0.20f, 0.27f, 0.38f}}}};
constexpr RigLights kRim = {{{{0.8f, 0.75f, -0.75f}, {2.3f, 2.2f, 2.05f}},
                             {{-0.9f, 0.45f, -0.7f}, {1.15f, 1.35f, 1.75f}},
                             {{-0.35f, 0.6f, 0.8f}, {0.20f, 0.19f, 0.18f}}}};

const RigLights& lights_of(LightRig rig) {
  switch (rig) {
    case LightRig::kStudio: return kPortrait;
    case LightRig::kSun: return kSun;
    case LightRig::kRim: return kRim;
    case LightRig::kMeasured: break;
  }
  return kStudioLights;
}

std::optional<std::array<float, 3>> parse_color(std::string_view word) {
  if (word.size() != 7 || word[0] != '#') return std::nullopt;
  std::array<float, 3> color{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string_view digits = word.substr(1 + 2 * k, 2);
    std::uint8_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + 2, value, 16);
    if (error != std::errc{} || end != digits.data() + 2) return std::nullopt;
    color[k] = decode_srgb(float(value) / 255);
  }
  return color;
}

}  // namespace

std::array<Light, 3> rig_lights(LightRig rig, const Camera& camera) { return camera_lights(lights_of(rig), camera); }

BodyLook rig_body_look(LightRig rig) {
  if (rig == LightRig::kMeasured) return {};
  return {.ambient = rig == LightRig::kRim ? 0.05f : 0.10f, .wrap = 0.15f, .bleed = 0.22f, .gloss = 1};
}

std::optional<Backdrop> find_backdrop(std::string_view word) {
  if (word == "light") return Backdrop{};
  if (word == "dark") {
    return Backdrop{.bottom = {0.012f, 0.013f, 0.016f},
                    .top = {0.016f, 0.019f, 0.026f},
                    .glow = {0.052f, 0.060f, 0.076f},
                    .vignette = 0.55f};
  }
  if (word == "clear") return Backdrop{.opacity = 0};
  const auto color = parse_color(word);
  if (!color) return std::nullopt;
  return Backdrop{.bottom = *color, .top = *color};
}

}  // namespace coif::render
