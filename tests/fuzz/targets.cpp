#include "fuzz/targets.h"

#include "cache/cook_cache.h"
#include "cache/manifest.h"
#include "cook/recipe/recipe.h"

#include <set>
#include <string>

namespace coif::fuzz {

bool try_recipe(Input input) {
  const std::string text(reinterpret_cast<const char*>(input.data()), input.size());
  const auto recipe = cook::parse_recipe(text, "a.recipe.json");
  if (!recipe) {
    promise(recipe.error().kind == ToolError::Kind::kBadInput, "a refusal is the recipe's fault");
    promise(recipe.error().message.starts_with("a.recipe.json: "), "a refusal names the file");
    promise(recipe.error().message.size() < 1000, "a refusal is a sentence");
    return false;
  }
  const std::string printed = cook::print_recipe(*recipe);
  const auto again = cook::parse_recipe(printed, "printed");
  promise(again.has_value(), "a printed recipe parses");
  promise(cook::print_recipe(*again) == printed, "a printed recipe parses back to the same");
  return true;
}

bool try_manifest(Input input) {
  static const LoneFile file("manifest.json");
  const auto requests = cache::read_manifest(file.with(input), "out");
  if (!requests) {
    promise(requests.error().kind == ToolError::Kind::kBadInput, "a refusal is the manifest's fault");
    return false;
  }
  std::set<std::string> outputs;
  for (const cache::CookRequest& request : *requests) {
    promise(request.output.starts_with("out/"), "no output leaves the folder");
    promise(request.output.find("/../") == std::string::npos, "no output climbs");
    promise(!request.output.ends_with('/'), "an output is a file");
    promise(outputs.insert(request.output).second, "no two assets have one output");
  }
  return true;
}

bool try_cache_entry(Input input) {
  const auto entry = cache::decode_entry(std::as_bytes(input));
  if (!entry) return false;
  const auto bytes = cache::encode_entry(*entry);
  const auto again = cache::decode_entry(bytes);
  promise(again.has_value(), "an entry that was read can be written and read");
  promise(cache::encode_entry(*again) == bytes, "an entry comes back as it was");
  return true;
}

}  // namespace coif::fuzz
