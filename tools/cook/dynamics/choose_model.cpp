#include "base/parallel_for.h"
#include "cook/dynamics/chain_groups.h"
#include "cook/dynamics/chain_trial.h"
#include "cook/dynamics/settle_dynamics.h"
#include "lab/passive_model.h"
#include "lab/rig.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace coif {
namespace {

/// 1/s. A reference of what is stiffer takes minutes; and what is stiff hardly swings.
constexpr double kMostRate = 60000;

struct Verdict {
  std::uint32_t chain = 0;
  ChainFinding as_cascade;
  bool is_good_passive = true;
};

bool is_too_stiff(const AssetContents& passive) {
  const OpenedAsset opened(passive);
  return fastest_rate(rig_of(opened.asset()).bones) > kMostRate;
}

Verdict judge(const AssetContents& cascade, const AssetContents& passive, const ChainGroup& group) {
  Verdict verdict;
  for (const std::uint32_t chain : group.telling) {
    const ChainFinding finding = try_chain(chains_alone(cascade, std::array{chain})).finding;
    if (finding.is_good) continue;
    verdict.chain = chain;
    verdict.as_cascade = finding;
    verdict.is_good_passive =
        verdict.is_good_passive && try_chain(chains_alone(passive, std::array{chain})).finding.is_good;
  }
  return verdict;
}

}  // namespace

bool needs_passive_model(const AssetContents& cascade, const AssetContents& passive, unsigned threads,
                         Findings& findings) {
  if (is_too_stiff(passive)) return false;
  const std::vector<ChainGroup> groups = group_chains(cascade);
  std::vector<Verdict> verdicts(groups.size());
  parallel_for(groups.size(), threads, [&](std::size_t g) { verdicts[g] = judge(cascade, passive, groups[g]); });
  const auto failed =
      std::ranges::find_if(verdicts, [](const Verdict& verdict) { return !verdict.as_cascade.is_good; });
  if (failed == verdicts.end() || !std::ranges::all_of(verdicts, &Verdict::is_good_passive)) return false;
  findings.note(
      fmt::format("moved by the passive model: as a cascade chain {} would have to be damped ({}), and then not swing "
                  "as it was asked to",
                  chain_name(cascade, failed->chain), what_failed(failed->as_cascade)));
  return true;
}

}  // namespace coif
