#include "cook/pack/pack.h"
#include "cook/recipe/scene_recipe.h"

#include <fmt/format.h>

namespace coif::cook {
namespace {

/// Must be the last texture, so that no other has to move.
std::uint64_t clear_shift_mask(AssetContents& contents) {
  if (contents.textures.empty() || contents.textures.back().role != TextureRole::kShiftMask) return 0;
  const std::size_t before = contents.texels.size();
  contents.textures.pop_back();
  contents.texels.resize(contents.textures.empty() ? 0
                                                   : contents.textures.back().offset + contents.textures.back().bytes);
  return before - contents.texels.size() + sizeof(TextureRecord);
}

}  // namespace

void leave_out_parts(const SceneRecipe& recipe, AssetContents& contents, Findings& findings) {
  const auto note = [&](const char* what, const char* key, std::uint64_t bytes) {
    if (bytes > 0) findings.leave_out({what, fmt::format("\"scene.{}\" is false", key), bytes, 0});
  };
  if (!recipe.scene_names) note("bone names", "names", clear_group("names", contents));
  if (!recipe.scene_quality) note("quality of other settings", "quality", clear_group("quality", contents));
  const bool is_draft = !contents.provenance.empty() && (contents.provenance.front().flags & kProvenanceDraft) != 0;
  if (!recipe.scene_provenance && !is_draft) note("provenance", "provenance", clear_group("provenance", contents));
  if (!recipe.scene_draw) note("mesh, material and textures", "draw", clear_group("mesh", contents));
  if (!recipe.scene_shift_mask) note("shift and mask of the highlights", "shift_mask", clear_shift_mask(contents));
  if (!recipe.scene_relief) note("maps of normals and strands", "relief", clear_group("relief", contents));
}

}  // namespace coif::cook
