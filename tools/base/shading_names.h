#pragma once

#include <coif/asset_records.h>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string_view>

namespace coif {

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
