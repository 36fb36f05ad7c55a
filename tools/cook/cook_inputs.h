#pragma once

#include "cook/texture_question.h"

#include <filesystem>
#include <string>
#include <vector>

namespace coif {

/// What a cook's result depends on beside the source's and the recipe's own bytes.
struct CookInputs {
  std::vector<std::filesystem::path>
      source_files;  ///< What the source names, side files and images; some may be absent.
  std::vector<std::filesystem::path> recipe_files;  ///< What the recipe names, found from the recipe's folder.
  std::vector<TextureQuestion> questions;           ///< To the TextureFolder of the source.
};

}  // namespace coif
