#pragma once

#include "base/tool_error.h"
#include "cook/recipe/hair_style.h"
#include "cook/recipe/recipe.h"
#include "groom/groom.h"
#include "import/import.h"
#include "import/source_model.h"
#include "platform/stop.h"

#include <tl/expected.hpp>

#include <array>
#include <filesystem>
#include <optional>
#include <string>

namespace coif::grow {

/// What hair grows on.
struct GrowGround {
  const importer::SourceModel&
      body;  ///< Any triangles in metres, Y up, with the head on top; what is called hair does not count.
  std::optional<std::array<double, 3>> head_center, head_radii;  ///< Of the skull; none: found at the body's top.
};

/// The sample's bust, looking along +Z.
[[nodiscard]] importer::SourceModel sample_body();

/// Strands, root first, with widths and colours, on the head and clear of the skin. `name` stands for the file in
/// messages. Repeats for equal input, whatever `threads` is. Errors (kBadInput): no head is found, or the hairline
/// leaves no room for a strand; kOverBudget: more points than a groom may have.
[[nodiscard]] tl::expected<groom::Groom, ToolError> grow_hair(const cook::HairStyle& style, const GrowGround& ground,
                                                              const std::string& name,
                                                              const platform::Threads& threads);

/// A model with the head and body that hair belongs to; the sample's bust where `path` is empty. Errors: those of
/// import_model().
[[nodiscard]] tl::expected<importer::SourceModel, ToolError> read_body(const std::filesystem::path& path,
                                                                       const importer::ImportSettings& settings);

/// The hair of a recipe on a body, with the head where the recipe says. Errors: those of grow_hair().
[[nodiscard]] tl::expected<groom::Groom, ToolError> grow_from(const cook::Recipe& recipe,
                                                              const importer::SourceModel& body,
                                                              const std::string& name,
                                                              const platform::Threads& threads);

}  // namespace coif::grow
