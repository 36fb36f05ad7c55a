#pragma once

#include "base/tool_error.h"
#include "cook/lods/detail_level.h"
#include "cook/order/choose_order.h"
#include "cook/recipe/cook_settings.h"
#include "cook/recipe/drawn_recipe.h"
#include "cook/recipe/hair_recipe.h"
#include "cook/recipe/rig_recipe.h"
#include "cook/recipe/scene_recipe.h"
#include "cook/recipe/strip_recipe.h"
#include "cook/rig/skeleton.h"
#include "cook/select/hair_mesh.h"
#include "cook/select/head.h"
#include "cook/stages/cook_log.h"
#include "cook/strands/choose_patches.h"
#include "cook/strands/hair_strips.h"
#include "cook/strands/patches.h"
#include "cook/texture/bake_textures.h"
#include "cook/texture/base_color.h"
#include "import/source_model.h"
#include "write/asset_writer.h"

#include <tl/expected.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace coif::cook {

/// The hair of a source.
struct SourceHair {
  /// The source in metres with Y up; none if it was read like that.
  std::optional<importer::SourceModel> settled;
  HairMesh mesh;  ///< With one texture and its coordinates.
  BaseColor color;

  /// The model that the hair is of.
  [[nodiscard]] const importer::SourceModel& model(const importer::SourceModel& source) const {
    return settled ? *settled : source;
  }
};

/// The first stage of a cook. Textures are joined here, since that moves texture coordinates and splits vertices, and
/// all later stages number vertices. Errors: those of select_hair() and find_base_color().
tl::expected<SourceHair, ToolError> find_hair(const importer::SourceModel& source, const HairRecipe& recipe,
                                              const DrawnRecipe& drawn, const CookSettings& settings, CookLog& log);

/// Hair as strips, and the head that they grow on.
struct Strips {
  HairStrips hair;
  ExtractedPatches extracted;
  std::vector<PatchListing> listings;  ///< Empty unless requested, or the recipe has values for some patches.
  HeadBone head_bone;
  FittedHead head;
};

/// The second stage of a cook, of hair that was found in `source`. Errors: the recipe's patches or head bone are not
/// there, or no hair is left.
tl::expected<Strips, ToolError> find_strips(const importer::SourceModel& source, HairMesh hair, const BaseColor& color,
                                            const HairRecipe& of_head, const StripRecipe& recipe,
                                            const CookSettings& settings, CookLog& log);

/// The bones that move hair.
struct CookedRig {
  HairRig rig;
  /// Bones, chains, colliders, dynamics, limits, links and tuning as the runtime has them. No tuning in a draft, and
  /// where nothing moves.
  AssetContents contents;
};

/// The third stage of a cook: bones of the file or fitted ones, their colliders, and their motion. Chains get a
/// well-defined motion, and then the cheapest way to simulate it. Errors: bones of the recipe do not exist, or no rate
/// keeps its budget.
tl::expected<CookedRig, ToolError> make_rig(const importer::SourceModel& source, const Strips& strips,
                                            const RigRecipe& recipe, const CookSettings& settings, CookLog& log);

/// The look of the hair, near and far.
struct Drawn {
  Strips strips;                    ///< Include cards of coarser levels as patches; without vertex colours.
  HairRig rig;                      ///< Includes the weights of these cards.
  AssetContents contents;           ///< The rig's, and all that is drawn.
  std::vector<DetailLevel> levels;  ///< Finest first.
  PatchOrder order;                 ///< By distance from the head.
  BakedTextures textures;           ///< Without their texels, which are in `contents`.
  OrderFigures figures;
};

/// The fourth stage of a cook: textures, levels of detail, draw orders. Errors: a texture cannot be read, or something
/// that the recipe names does not exist.
tl::expected<Drawn, ToolError> draw_hair(const importer::SourceModel& source, BaseColor color, Strips strips,
                                         CookedRig rig, const DrawnRecipe& recipe, const SceneRecipe& scene,
                                         const CookSettings& settings, CookLog& log);

/// The last stage of a cook: the bytes of an asset, and its `contents`, without the parts that the recipe's scene does
/// not need. Error (kBadInput) with the source at `path`: the runtime would refuse the asset, which must never be
/// written.
tl::expected<std::vector<std::byte>, ToolError> write_hair(const std::string& path, const SceneRecipe& recipe,
                                                           AssetContents& contents, CookLog& log);

}  // namespace coif::cook
