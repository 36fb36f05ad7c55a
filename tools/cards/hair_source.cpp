#include "cards/hair_source.h"

#include "cards/cards_model.h"
#include "groom/read_groom.h"

#include <utility>

namespace coif {
namespace {

tl::expected<SourceModel, ToolError> cards_of(const Groom& groom, const Recipe& recipe, const ImportSettings& settings,
                                              unsigned threads) {
  const CardsBudget budget{recipe.cards_triangles, recipe.cards_texels, float(recipe.cards_strand_width)};
  auto model = model_of_cards(groom, budget, threads);
  if (model) model->roots = settings.roots;
  return model;
}

}  // namespace

tl::expected<SourceModel, ToolError> read_hair_source(const std::filesystem::path& path, const Recipe& recipe,
                                                      const ImportSettings& settings, unsigned threads) {
  const auto suffix = find_suffix(path);
  const bool has_strands_alone = suffix && suffix->assimp_suffix == nullptr;
  if (!has_strands_alone) {
    auto model = import_model(path, settings);
    // Lines without triangles are no model, but may be hair.
    if (model || model.error().kind != ToolError::Kind::kBadInput || !has_strand_suffix(path)) return model;
    const auto groom = read_groom(path, settings);
    return groom ? cards_of(*groom, recipe, settings, threads) : std::move(model);
  }
  const auto groom = read_groom(path, settings);
  if (!groom) return tl::unexpected(groom.error());
  return cards_of(*groom, recipe, settings, threads);
}

}  // namespace coif
