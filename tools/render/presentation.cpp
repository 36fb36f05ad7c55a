#include "render/presentation.h"

#include "base/srgb.h"
#include "base/studio.h"
#include "cook/texture/source_images.h"

#include <charconv>
#include <cstdint>
#include <map>

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

BodyTextures read_body_textures(const importer::SourceModel& model, cook::Findings& findings) {
  constexpr std::uint32_t kLargest = 2048;
  std::vector<bool> is_shown(model.materials.size());
  for (const importer::SourceMesh& mesh : model.meshes) {
    if (mesh.material < is_shown.size() && !mesh.uvs.empty()) is_shown[mesh.material] = true;
  }
  cook::SourceImages images(model);
  std::map<const cook::Image*, std::shared_ptr<const SolidTexture>> known;  // looked up only
  BodyTextures textures(model.materials.size());
  for (std::size_t m = 0; m < textures.size(); ++m) {
    const cook::Image* const image = is_shown[m] ? images.of(model.materials[m]) : nullptr;
    if (image == nullptr) continue;
    std::shared_ptr<const SolidTexture>& texture = known[image];
    if (texture == nullptr) {
      cook::Image small = cook::reduce(*image, kLargest, cook::TexelMeaning::kSrgbColorAlpha);
      texture = std::make_shared<SolidTexture>(small.width, small.height, std::move(small.texels));
    }
    textures[m] = texture;
  }
  for (const Diagnostic& warning : images.findings().warnings) findings.warnings.push_back(warning);
  return textures;
}

}  // namespace coif::render
