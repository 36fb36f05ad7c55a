#pragma once

#include "base/tool_error.h"
#include "cook/recipe/scene_recipe.h"
#include "cook/stages/cook_log.h"
#include "write/asset_writer.h"

#include <tl/expected.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace coif::cook {

/// The last stage of a cook: the bytes of an asset, and `contents` as they are in it, without the parts that the
/// recipe's scene does without. Error (kBadInput), which names the source at `path`: the runtime would refuse it, and
/// that must never reach a disk.
tl::expected<std::vector<std::byte>, ToolError> write_hair(const std::string& path, const SceneRecipe& recipe,
                                                           AssetContents& contents, CookLog& log);

}  // namespace coif::cook
