#pragma once

#include "base/texture_channel.h"

#include <string>

namespace coif::cook {

/// An image that the recipe names, and which of its numbers are meant. In JSON a path alone, or
/// {"file": "hair_packed.png", "channel": "g", "invert": true}.
struct RecipeTexture {
  std::string file;  ///< Path relative to the recipe; "": none.
  TextureChannel channel = TextureChannel::kAuto;
  bool is_inverted = false;  ///< 1 and 0 are exchanged.

  [[nodiscard]] bool empty() const { return file.empty(); }
};

/// "r", "g", "b", "a", "luminance" or "auto".
[[nodiscard]] const char* channel_word(TextureChannel channel);

}  // namespace coif::cook
