#pragma once

#include <string>

namespace coif::cook {

enum class RecipeUpAxis { kFile, kX, kY, kZ };

/// The recipe's values for reading the source file.
struct SourceRecipe {
  double metres_per_unit = 0;  ///< 0: from the file.
  RecipeUpAxis up_axis = RecipeUpAxis::kFile;
  std::string source_variant;  ///< KHR_materials_variants; "": none.
};

}  // namespace coif::cook
