#include "cook/dynamics/bake_links.h"

#include "base/text.h"
#include "base/words.h"
#include "cook/dynamics/chain_groups.h"
#include "cook/recipe/rig_recipe.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace coif::cook {
namespace {

using Pairs = tl::expected<LinkedDepths, ToolError>;

constexpr std::size_t kMostPairs = 1 << 16;  // wildcards against wildcards; a skirt has dozens
constexpr std::size_t kMostNamed = 4;        // pairs, in a note

tl::unexpected<ToolError> bad_pair(const std::string& source, std::size_t pair, const std::string& what) {
  return tl::unexpected(
      ToolError{ToolError::Kind::kBadInput, fmt::format("{}: \"dynamics.links\" [{}]: {}", source, pair, what)});
}

std::set<std::uint32_t> chains_called(const AssetContents& contents, const std::string& name) {
  std::set<std::uint32_t> chains;
  for (std::size_t b = 0; b < contents.bones.size(); ++b) {
    const BoneRecord& bone = contents.bones[b];
    if (bone.kind == BoneKind::kSimulated && matches(contents.bone_names[b], name)) chains.insert(bone.chain);
  }
  return chains;
}

/// Names of the first bones of the chains, as many as a message has room for.
std::string chain_names(const AssetContents& contents) {
  constexpr std::size_t kMost = 12;
  std::vector<std::string> names;
  for (std::uint32_t c = 0; c < contents.chains.size() && names.size() <= kMost; ++c) {
    names.push_back(contents.bone_names[contents.chains[c].first_bone]);
  }
  if (names.size() > kMost) names.back() = "...";
  return fmt::format("{}", fmt::join(names, ", "));
}

Pairs pairs_of_recipe(const std::string& source, const AssetContents& contents, const RecipeLinks& links) {
  LinkedDepths pairs;
  for (std::size_t i = 0; i < links.pairs.size(); ++i) {
    std::set<std::uint32_t> sides[2];
    for (std::size_t k = 0; k < 2; ++k) {
      sides[k] = chains_called(contents, links.pairs[i][k]);
      if (!sides[k].empty()) continue;
      return bad_pair(source, i,
                      fmt::format("no bone that moves is called {}; chains begin with {}", links.pairs[i][k],
                                  chain_names(contents)));
    }
    bool any = false;
    for (const std::uint32_t one : sides[0]) {
      for (const std::uint32_t other : sides[1]) {
        if (one == other) continue;
        pairs.emplace(std::minmax(one, other), kNone);
        any = true;
      }
      if (pairs.size() > kMostPairs) return bad_pair(source, i, "names too many pairs of chains; name neighbours");
    }
    if (any) continue;
    return bad_pair(
        source, i,
        fmt::format("{} and {} are of one chain, the one of {}; name a bone of another: chains begin with {}",
                    links.pairs[i][0], links.pairs[i][1], chain_name(contents, *sides[0].begin()),
                    chain_names(contents)));
  }
  return pairs;
}

/// "'a' and 'b', 'b' and 'c' and 7 more".
std::string pairs_text(const AssetContents& contents, const std::vector<ChainPair>& pairs) {
  std::vector<std::string> texts;
  for (const ChainPair& pair : pairs) {
    if (texts.size() == kMostNamed) break;
    texts.push_back(fmt::format("{} and {}", chain_name(contents, pair.first), chain_name(contents, pair.second)));
  }
  const std::string text = fmt::format("{}", fmt::join(texts, ", "));
  return pairs.size() > kMostNamed ? fmt::format("{} and {} more", text, pairs.size() - kMostNamed) : text;
}

void report(const AssetContents& contents, const LinkForest& forest, Findings& findings) {
  std::set<std::uint32_t> chains;
  for (const auto& [one, other] : forest.linked) chains.insert({one, other});
  if (!forest.links.empty()) {
    findings.note(fmt::format("{} of {} chains, so that they stay beside each other: {}",
                              counted(forest.links.size(), "link", "links"), chains.size(),
                              pairs_text(contents, forest.linked)));
  }
  if (!forest.roundabout.empty()) {
    findings.note(fmt::format("{} of chains not linked, as other links hold them together: {}",
                              counted(forest.roundabout.size(), "pair", "pairs"),
                              pairs_text(contents, forest.roundabout)));
  }
  if (!forest.touching.empty()) {
    const LinkRecord& first = forest.touching.front();
    findings.note(fmt::format("{} left out, since both bones end at one place: the first '{}' and '{}'",
                              counted(forest.touching.size(), "link", "links"), contents.bone_names[first.bone],
                              contents.bone_names[first.to]));
  }
}

}  // namespace

tl::expected<std::vector<LinkRecord>, ToolError> bake_links(const std::string& source, const HairStrips& hair,
                                                            const HairRig& rig, const AssetContents& contents,
                                                            const RigRecipe& recipe, Findings& findings) {
  LinkedDepths pairs;
  if (!recipe.links.pairs.empty()) {
    Pairs named = pairs_of_recipe(source, contents, recipe.links);
    if (!named) return tl::unexpected(named.error());
    pairs = *std::move(named);
  } else {
    const SharedStrips shared = find_shared_strips(hair, rig);
    const std::string strips = counted(shared.count, "strip hangs", "strips hang");
    if (recipe.links.word == "none") {
      if (shared.count == 0) return std::vector<LinkRecord>{};
      findings.note(strips +
                    " on two chains, and may be torn where these drift apart: \"dynamics.links\":"
                    " \"shared_strips\" keeps them together");
      return std::vector<LinkRecord>{};
    }
    findings.note(shared.count > 0 ? strips + " on two chains, which are linked"
                                   : "no strip hangs on two chains, so that none are linked");
    for (const auto& [pair, hair_of_pair] : shared.pairs) pairs.emplace(pair, hair_of_pair.depths);
  }
  LinkForest forest = link_chains(contents, pairs, {recipe.link_stretch, recipe.link_shrink});
  report(contents, forest, findings);
  return std::move(forest.links);
}

}  // namespace coif::cook
