#include "cook/recipe/chain_links.h"

#include "cook/recipe/recipe_keys.h"

#include <fmt/format.h>

namespace coif::cook {
namespace {

using nlohmann::json;
using Outcome = tl::expected<void, std::string>;

constexpr const char* kWanted = "\"none\", \"shared_strips\" or a list of [\"bone of one chain\", \"bone of another\"]";
constexpr std::size_t kMostPairs = 4096;

Outcome read_pair(const json& value, std::array<std::string, 2>& out) {
  const auto is_name = [](const json& name) { return name.is_string() && !name.get<std::string>().empty(); };
  const bool fits = value.is_array() && value.size() == 2 && is_name(value[0]) && is_name(value[1]);
  if (!fits) return wants("two names of bones, * and ? are wildcards", value);
  out = {value[0].get<std::string>(), value[1].get<std::string>()};
  return {};
}

}  // namespace

Outcome read_chain_links(const json& value, RecipeLinks& out) {
  RecipeLinks links;
  if (value == json("none") || value == json("shared_strips")) {
    links.word = value.get<std::string>();
  } else {
    links.word.clear();
    if (Outcome outcome = read_entries(value, kWanted, kMostPairs, read_pair, links.pairs); !outcome) return outcome;
    if (links.pairs.empty()) links.word = "none";
  }
  out = std::move(links);
  return {};
}

json write_chain_links(const RecipeLinks& links) {
  if (links.pairs.empty()) return links.word;
  return links.pairs;
}

}  // namespace coif::cook
