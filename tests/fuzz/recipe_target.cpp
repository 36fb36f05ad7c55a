#include "fuzz/promise.h"
#include "fuzz/targets.h"

#include "cook/recipe/recipe.h"

#include <string>

namespace coif::fuzz {

bool try_recipe(Input input) {
  const std::string text(reinterpret_cast<const char*>(input.data()), input.size());
  const auto recipe = parse_recipe(text, "a.recipe.json");
  if (!recipe) {
    promise(recipe.error().kind == ToolError::Kind::kBadInput, "a refusal is the recipe's fault");
    promise(recipe.error().message.starts_with("a.recipe.json: "), "a refusal names the file");
    promise(recipe.error().message.size() < 1000, "a refusal is a sentence");
    return false;
  }
  const std::string printed = print_recipe(*recipe);
  const auto again = parse_recipe(printed, "printed");
  promise(again.has_value(), "a printed recipe parses");
  promise(print_recipe(*again) == printed, "a printed recipe parses back to the same");
  return true;
}

}  // namespace coif::fuzz
