#pragma once

#include "base/tool_error.h"
#include "cook/lods/detail_level.h"
#include "cook/order/choose_order.h"
#include "cook/recipe/cook_settings.h"
#include "cook/recipe/drawn_recipe.h"
#include "cook/recipe/scene_recipe.h"
#include "cook/stages/cook_log.h"
#include "cook/stages/make_rig.h"
#include "cook/texture/bake_textures.h"
#include "write/asset_writer.h"

#include <tl/expected.hpp>

#include <vector>

namespace coif::cook {

/// What hair looks like, near and far.
struct Drawn {
  Strips strips;                    ///< Cards of coarser levels are patches of them. Without vertex colours.
  HairRig rig;                      ///< With their weights.
  AssetContents contents;           ///< The rig's, and all that is drawn.
  std::vector<DetailLevel> levels;  ///< Finest first.
  PatchOrder order;                 ///< By distance from the head.
  BakedTextures textures;           ///< But for their texels, which are in `contents`.
  OrderFigures figures;
};

/// The fourth stage of a cook: textures, levels of detail, draw orders. Errors: a texture cannot be read, or what a
/// recipe asks of it is not there.
tl::expected<Drawn, ToolError> draw_hair(const importer::SourceModel& source, BaseColor color, Strips strips,
                                         CookedRig rig, const DrawnRecipe& recipe, const SceneRecipe& scene,
                                         const CookSettings& settings, CookLog& log);

}  // namespace coif::cook
