#pragma once

// What tools need beside the runtime's own interface: memory for its hair, and what people call its shading models.

#include <coif/asset_records.h>
#include <coif/hair.h>

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

/// As recipes and the command line call the shading models, in the order of ShadingModel.
inline constexpr const char* kShadingNames[] = {"thesis", "kajiya-kay", "marschner"};

/// Of an open asset's material.
[[nodiscard]] constexpr const char* name_of(ShadingModel model) { return kShadingNames[std::size_t(model)]; }

/// None for a word that is no model's name.
[[nodiscard]] constexpr std::optional<ShadingModel> shading_model(std::string_view name) {
  for (std::uint32_t i = 0; i < std::size(kShadingNames); ++i) {
    if (name == kShadingNames[i]) return ShadingModel(i);
  }
  return std::nullopt;
}

}  // namespace coif
