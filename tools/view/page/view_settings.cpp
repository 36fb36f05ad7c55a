#include "view/page/view_settings.h"

#include "base/geometry.h"
#include "base/hair_runtime.h"
#include "motion/head_path.h"

#include <coif/research.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace coif::view {
namespace {

// The words of the command line; WebGL 2 has no exact order.
constexpr std::array<const TransparencyMode*, 9> kModes{&kBlendMode,        &kOpaqueMode,   &kCoverageMode,
                                                        &kProportionalMode, &kJitteredMode, &kScreenDoorMode,
                                                        &kCheckerboardMode, &kBayerMode,    &kHashedMode};
constexpr std::array<const ShadowTechnique*, 5> kTechniques{nullptr, &kPlainShadow, &kOpacityShadow,
                                                            &kDeepOpacityShadow, &kDeepShadow};
constexpr std::array<const Solver*, 4> kSolvers{&kCoifSolver, &kCascadeSolver, &kPassiveSolver, &kThesisSolver};

/// Whatever a script wrote there.
template <typename Entry, std::size_t kCount>
const Entry& chosen(const std::array<Entry, kCount>& all, float number) {
  return all[number >= 0 && number < float(kCount) ? std::size_t(number) : 0];
}

/// The renderer's default for assets without a material.
MaterialRecord own_material(const Asset& asset) {
  return asset.material() != nullptr ? *asset.material() : drawn_hair_of(asset).material;
}

void fill_in_fiber(MaterialRecord& material) {
  if (material.roughness >= kLeastRoughness) return;
  material.tilt = 0.05f;  // never cooked with a recipe that has them
  material.roughness = 0.14f;
  material.scatter = 0.8f;
}

constexpr float kDegreesOfRadian = float(1 / kDegree);

}  // namespace

void set_look(const MaterialRecord& material, ViewSettings& s) {
  s.shading = float(material.shading);
  std::copy_n(material.ambient, 3, s.ambient);
  s.opaque_threshold = material.opaque_threshold;
  s.discard_threshold = material.discard_threshold;
  std::copy_n(material.primary_color, 3, s.primary_color);
  s.primary_exponent = material.primary_exponent;
  s.primary_shift = material.primary_shift;
  std::copy_n(material.secondary_color, 3, s.secondary_color);
  s.secondary_exponent = material.secondary_exponent;
  s.secondary_shift = material.secondary_shift;
}

ViewSettings settings_of(const Asset& asset) {
  ViewSettings s;
  MaterialRecord material = own_material(asset);
  fill_in_fiber(material);
  set_look(material, s);
  s.tilt = material.tilt * kDegreesOfRadian;
  s.roughness = material.roughness * kDegreesOfRadian;
  s.scatter = material.scatter;
  return s;
}

MaterialRecord material_of(const Asset& asset, const ViewSettings& s) {
  const ViewSettings own = settings_of(asset);
  MaterialRecord material = own_material(asset);
  const auto model = std::min(std::uint32_t(std::max(s.shading, 0.0f)), kShadingModelCount - 1);
  if (model != std::uint32_t(material.shading)) {
    material.light_cut = 0;  // made for the other model
    material.shading = ShadingModel(model);
    fill_in_fiber(material);
  }
  for (int k = 0; k < 3; ++k)
    material.base_color[k] *= s.base_color[k] / (s.cooked_color[k] > 0 ? s.cooked_color[k] : 1);
  std::copy_n(s.ambient, 3, material.ambient);
  material.opaque_threshold = s.opaque_threshold;
  material.discard_threshold = s.discard_threshold;
  std::copy_n(s.primary_color, 3, material.primary_color);
  material.primary_exponent = s.primary_exponent;
  material.primary_shift = s.primary_shift;
  std::copy_n(s.secondary_color, 3, material.secondary_color);
  material.secondary_exponent = s.secondary_exponent;
  material.secondary_shift = s.secondary_shift;
  // An untouched value keeps its bits, which degrees would round.
  if (s.tilt != own.tilt) material.tilt = s.tilt / kDegreesOfRadian;
  if (s.roughness != own.roughness) material.roughness = s.roughness / kDegreesOfRadian;
  if (s.scatter != own.scatter) material.scatter = s.scatter;
  return material;
}

const TransparencyMode& transparency_of(const ViewSettings& settings) { return *chosen(kModes, settings.transparency); }

const ShadowTechnique* shadows_of(const ViewSettings& settings) { return chosen(kTechniques, settings.shadows); }

const Solver& solver_of(float choice) { return *chosen(kSolvers, choice); }

Component component_of(const ViewSettings& settings) {
  static constexpr std::array kShown{Component::kAll,      Component::kAmbient, Component::kDiffuse,
                                     Component::kSpecular, Component::kPrimary, Component::kSecondary,
                                     Component::kDirection};
  return chosen(kShown, settings.component);
}

std::string motion_words(bool has_clip) {
  std::string words;
  for (const motion::MotionInfo& info : motion::all_motions()) words.append(words.empty() ? "" : "|").append(info.name);
  for (const motion::HeadLook& look : motion::head_looks()) words.append("|").append(look.name);
  return has_clip ? words + "|clip" : words;
}

bool is_clip(float choice) { return choice >= float(motion::all_motions().size() + motion::head_looks().size()); }

std::unique_ptr<motion::HeadPath> chosen_path(float choice) {
  const auto motions = motion::all_motions();
  const auto looks = motion::head_looks();
  // Whatever a script wrote there.
  const std::size_t number = choice >= 0 && choice < 1000 ? std::size_t(choice) : 0;
  if (number < motions.size()) return motion::path_of(motions[number].motion);
  return motion::path_of(looks[std::min(number - motions.size(), looks.size() - 1)]);
}

}  // namespace coif::view
