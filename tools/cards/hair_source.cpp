#include "cards/hair_source.h"

#include "base/files.h"
#include "cards/make_cards.h"
#include "cook/recipe/recipe_keys.h"
#include "cook/select/hair_evidence.h"
#include "groom/read_groom.h"
#include "grow/grow_hair.h"
#include "import/source_warnings.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

namespace coif::cards {
namespace {

namespace fs = std::filesystem;
using Model = tl::expected<importer::SourceModel, ToolError>;

/// Drafts, and others that hardly compare cards with strands, do not compare kinds of cards either.
std::optional<CardsPlan> plan_of(const cook::Recipe& recipe) {
  if (recipe.cards_rounds > 1) return std::nullopt;
  return CardsPlan{Construction::kBent, 3};
}

Model cards_of(const groom::Groom& groom, const cook::Recipe& recipe, const HairSourceSettings& settings) {
  if (settings.progress) settings.progress("cards");
  const CardsBudget budget{.triangles = recipe.cards_triangles,
                           .texels = recipe.cards_texels,
                           .rounds = int(recipe.cards_rounds),
                           .strand_width = float(recipe.cards_strand_width),
                           .caps = float(recipe.cards_caps),
                           .levels = recipe.lod_levels,
                           .level_ratio = recipe.lod_ratio,
                           .side = recipe.texture_max_size.value_or(0),
                           .wisps = recipe.cards_wisps,
                           .plan = plan_of(recipe)};
  auto model = model_of_cards(groom, budget, settings.threads);
  if (model) model->roots = settings.import.roots;
  return model;
}

/// The body file of the recipe; its unit is its own.
Model named_body(const cook::Recipe& recipe, const HairSourceSettings& settings) {
  importer::ImportSettings import = settings.import;
  import.metres_per_unit.reset();
  import.up_axis.reset();
  return importer::import_model(settings.recipe_directory / recipe.cards_body, import);
}

/// Cards of a file's strands, on a body if there is one.
Model cards_on(groom::Groom groom, std::optional<importer::SourceModel> body, const cook::Recipe& recipe,
               const HairSourceSettings& settings) {
  if (!recipe.cards_body.empty()) {
    auto named = named_body(recipe, settings);
    if (!named) return named;
    place_on_body(*named, groom);
    body = std::move(*named);
  }
  const std::uint32_t followers = recipe.cards_follow_hairs.value_or(groom.follow_hairs);
  const auto all = with_follow_hairs(std::move(groom), followers, float(recipe.cards_follow_radius));
  if (!all) return tl::unexpected(all.error());
  auto model = cards_of(*all, recipe, settings);
  if (model && body) add_body(std::move(*body), *model);
  return model;
}

Model grown_hair(const fs::path& path, const cook::Recipe& recipe, const HairSourceSettings& settings) {
  auto body = recipe.cards_body.empty() ? Model(grow::sample_body()) : named_body(recipe, settings);
  if (!body) return body;
  const auto groom = grow::grow_from(recipe, *body, path.string(), settings.threads);
  if (!groom) return tl::unexpected(groom.error());
  auto model = cards_of(*groom, recipe, settings);
  if (model) add_body(std::move(*body), *model);
  return model;
}

/// Whether the file may hold lines; cheaper than reading them.
bool mentions_lines(const fs::path& path) {
  const auto bytes = FileBytes::read(path);
  if (!bytes) return false;
  const std::string_view text(reinterpret_cast<const char*>(bytes->span().data()), bytes->span().size());
  const auto suffix = importer::find_suffix(path);
  if (suffix && suffix->format == importer::SourceFormat::kObj)
    return text.starts_with("l ") || text.find("\nl ") != text.npos;
  return text.find("\"mode\"") != text.npos;
}

bool has_mesh_called_hair(const importer::SourceModel& model) {
  return std::ranges::any_of(model.meshes, [&](const importer::SourceMesh& mesh) {
    return cook::is_called_hair(mesh.name) || cook::is_called_hair(importer::material_name(model, mesh));
  });
}

/// Whether lines beside a mesh are hair: modelling tools leave single edges, which are not.
bool is_hair_beside_mesh(const groom::Groom& groom) {
  constexpr std::size_t kFewestStrands = 32, kFewestPoints = 4;
  std::size_t strands = 0;
  for (std::size_t i = 0; i < groom.strand_count(); ++i) strands += groom.strand(i).size() >= kFewestPoints ? 1 : 0;
  return strands >= kFewestStrands;
}

/// The strands of a file that may have a mesh as well; none where its mesh is the hair.
std::optional<groom::Groom> strands_beside(const Model& model, const fs::path& path, const cook::Recipe& recipe,
                                           const importer::ImportSettings& import) {
  if (model && (recipe.names_hair() || has_mesh_called_hair(*model) || !mentions_lines(path))) return std::nullopt;
  auto groom = groom::read_groom(path, import);
  if (!groom || (model && !is_hair_beside_mesh(*groom))) return std::nullopt;
  return std::move(*groom);
}

/// A file that may hold triangles, lines, or both.
Model read_model(const fs::path& path, const cook::Recipe& recipe, const HairSourceSettings& settings) {
  auto model = importer::import_model(path, settings.import);
  // Lines without triangles are no model, but may be hair.
  const bool may_be_lines = model || model.error().kind == ToolError::Kind::kBadInput;
  std::optional<groom::Groom> groom;
  if (may_be_lines && groom::has_strand_suffix(path)) groom = strands_beside(model, path, recipe, settings.import);
  if (groom) {
    std::optional<importer::SourceModel> body;
    if (model) {
      body = std::move(*model);
      // The lines are the hair.
      std::erase_if(body->warnings,
                    [](const Diagnostic& warning) { return warning.code == importer::source_code::kLoose; });
    }
    return cards_on(std::move(*groom), std::move(body), recipe, settings);
  }
  if (model && !recipe.cards_body.empty()) {
    importer::warn(model->warnings, importer::source_code::kNoStrands,
                   "the file has strips: \"cards.body\" is for strands, and is not read");
  }
  return model;
}

}  // namespace

Model read_hair_source(const fs::path& path, const cook::Recipe& recipe, const HairSourceSettings& settings) {
  if (cook::is_recipe_file(path)) return grown_hair(path, recipe, settings);
  const auto suffix = importer::find_suffix(path);
  const bool has_strands_alone =
      suffix && (suffix->format == importer::SourceFormat::kHair || suffix->format == importer::SourceFormat::kTressFx);
  if (!has_strands_alone) return read_model(path, recipe, settings);
  auto groom = groom::read_groom(path, settings.import);
  if (!groom) return tl::unexpected(groom.error());
  return cards_on(std::move(*groom), std::nullopt, recipe, settings);
}

std::string source_values(const cook::Recipe& recipe) {
  std::string text;
  for (const cook::RecipeKey& key : cook::recipe_keys()) {
    const std::string_view section = key.section;
    if (section == "cards" || section == "grow" || section == "hair" || section == "head" || section == "lods" ||
        key.path() == "textures.max_size")
      text += cook::write_value(key, recipe).dump() + "\n";
  }
  return text;
}

}  // namespace coif::cards
