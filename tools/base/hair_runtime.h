#pragma once

// Memory for the runtime's hair, and names of its shading models, for tools.

#include <coif/hair.h>
#include <coif/links.h>
#include <coif/shading_models.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <memory>
#include <optional>
#include <string_view>

namespace coif {

using HairMemory = std::unique_ptr<std::byte, decltype(&std::free)>;

/// Memory of the size and alignment that Hair::create() needs; null where there is none.
[[nodiscard]] inline HairMemory allocate(const MemoryNeed& need) {
  const std::size_t units = need.bytes == 0 ? 1 : (need.bytes + need.alignment - 1) / need.alignment;
  return {static_cast<std::byte*>(std::aligned_alloc(need.alignment, units * need.alignment)), &std::free};
}

/// The code that keeps the asset's linked chains together under `solver`. Null where the asset has no links, and for
/// Algorithm 1, which does not support them.
[[nodiscard]] inline const LinkCode* links_of(const Asset& asset, const Solver& solver) {
  if (asset.links().empty() || &solver == &kThesisSolver) return nullptr;
  const bool is_worn = &solver == &kCharacterSolver || &solver == &kCharacterCascadeSolver;
  return is_worn ? &kCharacterLinks : &kLinks;
}

/// The name of a material's model; the asset must have been opened.
[[nodiscard]] constexpr const char* name_of(ShadingModel model) { return kShadingModels[std::size_t(model)].name; }

/// None for a word that is no model's name.
[[nodiscard]] constexpr std::optional<ShadingModel> shading_model(std::string_view name) {
  for (std::uint32_t i = 0; i < kShadingModelCount; ++i) {
    if (name == kShadingModels[i].name) return ShadingModel(i);
  }
  return std::nullopt;
}

/// All names in the form of recipe keys: "thesis|kajiya-kay|marschner|volume", ended by a zero byte.
inline constexpr auto kShadingWords = [] {
  std::array<char, 256> words{};
  std::size_t end = 0;
  for (const ShadingTraits& model : kShadingModels) {
    if (end > 0) words[end++] = '|';
    for (const char c : std::string_view(model.name)) words[end++] = c;
  }
  return words;
}();

}  // namespace coif
