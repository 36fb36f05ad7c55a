// A world that is called in any order with any arguments: it answers as documented, keeps what it was where it refuses,
// has finite matrices, and gives all memory back. COIF_RANDOM_CALLS=1000000 makes as many calls.

#include "sim/hair_town.h"
#include "sim/linked_sheet.h"
#include "sim/world_life.h"

#include <coif/links.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <iterator>
#include <vector>

namespace coif::world_calls_test {

const Kinds& kinds() {
  static const Kinds all = [] {
    std::vector<AssetContents> contents = hair_town::many_kinds();
    contents.push_back(small_asset());  // With a body.
    contents.push_back(links_test::sheet_rig().contents());
    contents.push_back(links_test::sheet_rig({.model = ChainModel::kPassive, .strands = 3, .twists = true}).contents());
    return hair_town::opened(contents);
  }();
  return all;
}

WorldDesc desc_of(std::uint32_t life) {
  constexpr const Solver* kSolvers[] = {&kCharacterSolver, &kCoifSolver,   &kCharacterSolver,       &kCascadeSolver,
                                        &kPassiveSolver,   &kThesisSolver, &kCharacterCascadeSolver};
  OddNumbers lot(life);
  WorldDesc desc{
      .assets = 1 + lot.below(7), .heads = 1 + lot.below(40), .solver = kSolvers[life % std::size(kSolvers)]};
  desc.hair_bytes = std::vector<std::size_t>{200'000, 1'000'000, 1'500'016, 8'000'000}[lot.below(4)];
  desc.longest_interval = 1u << lot.below(3);
  desc.dynamics_sets = lot.one_in(2) ? 1 : 1 + lot.below(8);
  const std::vector<InstructionSet> sets = runnable_sets();
  if (lot.one_in(2)) desc.instruction_set = sets[lot.below(std::uint32_t(sets.size()))];
  const bool is_on_character = desc.solver == &kCharacterSolver || desc.solver == &kCharacterCascadeSolver;
  if (desc.solver != &kThesisSolver && lot.one_in(2)) desc.links = is_on_character ? &kCharacterLinks : &kLinks;
  if (!is_on_character) return desc;
  desc.moving_colliders = lot.one_in(2) ? 0 : 1 + lot.below(lot.one_in(8) ? kMaxMovingColliders : 3);
  desc.follows_body = lot.one_in(2);
  desc.follows_poses = lot.one_in(2);
  desc.has_own_air = lot.one_in(2);
  desc.feels_gusts = lot.one_in(2);
  return desc;
}

TEST(WorldCalls, AnyCallsInAnyOrderAreAnsweredAsDocumented) {
  const char* const asked = std::getenv("COIF_RANDOM_CALLS");
  const char* const first = std::getenv("COIF_RANDOM_LIFE");
  const long calls = asked != nullptr ? std::atol(asked) : 20'000;
  constexpr long kLife = 500;
  constexpr long Tally::*kCounts[] = {&Tally::without_memory, &Tally::stepped, &Tally::asleep, &Tally::refused_bytes,
                                      &Tally::taken_bytes};
  auto number = std::uint32_t(first != nullptr ? std::atol(first) : 0);
  Tally all;
  for (long done = 0; done < calls; done += 2 * kLife, ++number) {
    SCOPED_TRACE(number);
    Life plain(kinds(), desc_of(number), number, false), chosen(kinds(), desc_of(number), number, true);
    for (long i = 0; i < kLife && !HasFailure(); ++i) {
      SCOPED_TRACE(i);
      plain.call();
      chosen.call();
    }
    EXPECT_TRUE(plain.history() == chosen.history()) << "what threads chose for floating point changed bits";
    if (HasFailure()) return;
    for (long Tally::*const count : kCounts) all.*count += chosen.tally.*count;
  }
  for (long Tally::*const count : kCounts) EXPECT_GT(all.*count, calls / 1000) << "or hardly anything was tried";
}

}  // namespace coif::world_calls_test
