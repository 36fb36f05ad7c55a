#pragma once

// What tools need beside the runtime's own interface: memory for its hair, and what people call its shading models.

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

/// As large and as aligned as Hair::create() asks for; null where it cannot be had.
[[nodiscard]] inline HairMemory allocate(const MemoryNeed& need) {
  const std::size_t units = need.bytes == 0 ? 1 : (need.bytes + need.alignment - 1) / need.alignment;
  return {static_cast<std::byte*>(std::aligned_alloc(need.alignment, units * need.alignment)), &std::free};
}

/// What keeps the asset's linked chains together under `solver`; null where it links none, and for Algorithm 1, which
/// knows no links.
[[nodiscard]] inline const LinkCode* links_of(const Asset& asset, const Solver& solver) {
  if (asset.links().empty() || &solver == &kThesisSolver) return nullptr;
  const bool is_worn = &solver == &kCharacterSolver || &solver == &kCharacterCascadeSolver;
  return is_worn ? &kCharacterLinks : &kLinks;
}

/// Of an open asset's material.
[[nodiscard]] constexpr const char* name_of(ShadingModel model) { return kShadingModels[std::size_t(model)].name; }

/// None for a word that is no model's name.
[[nodiscard]] constexpr std::optional<ShadingModel> shading_model(std::string_view name) {
  for (std::uint32_t i = 0; i < kShadingModelCount; ++i) {
    if (name == kShadingModels[i].name) return ShadingModel(i);
  }
  return std::nullopt;
}

/// All names as recipe keys have their words: "thesis|kajiya-kay|marschner", ended by a zero byte.
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
