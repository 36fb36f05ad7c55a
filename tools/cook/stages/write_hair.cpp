#include "cook/stages/stages.h"

#include "cook/pack/pack.h"
#include "lab/rig.h"

#include <fmt/format.h>

namespace coif::cook {

tl::expected<std::vector<std::byte>, ToolError> write_hair(const std::string& path, const SceneRecipe& recipe,
                                                           AssetContents& contents, CookLog& log) {
  return log.pass("write", [&]() -> tl::expected<std::vector<std::byte>, ToolError> {
    leave_out_parts(recipe, contents, log.findings());
    std::vector<std::byte> asset = write_asset(contents);
    const lab::OpenedAsset opened(asset);
    LoadStatus status = opened.status();
    if (status) status = opened.asset().verify_draw_data();
    if (status) return asset;
    char text[256];
    describe(status, text, sizeof text);
    return tl::unexpected(
        ToolError{ToolError::Kind::kBadInput, fmt::format("{}: the cooked asset is not valid: {}", path, text)});
  });
}

}  // namespace coif::cook
