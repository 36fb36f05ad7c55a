#pragma once

namespace coif::cook {

/// The recipe's values about the needs of a game's scene.
struct SceneRecipe {
  bool scene_draw = false;
  bool scene_names = false;
  bool scene_quality = false;
  bool scene_provenance = false;
  bool scene_shift_mask = false;
  bool scene_relief = false;
};

}  // namespace coif::cook
