#pragma once

#include "cook/recipe/findings.h"
#include "cook/texture/image.h"
#include "platform/stop.h"
#include "write/asset_writer.h"

#include <cstdint>
#include <vector>

namespace coif::cook {

struct DrawnRecipe;

/// Encodes an image of four channels as TexelFormat::kSrgb8Alpha8Etc2, blocks row by row. The same bytes for any number
/// of threads.
[[nodiscard]] std::vector<std::uint8_t> encode_color(const Image& image, const platform::Threads& threads);

/// Stores the base colour in blocks, as the recipe's "textures.color_format" says; last of all passes, since those
/// before look at its texels. By itself it does so to large textures whose colours and alphas hardly change, and notes
/// how much.
void compress_color(const DrawnRecipe& recipe, const platform::Threads& threads, AssetContents& contents,
                    Findings& findings);

}  // namespace coif::cook
