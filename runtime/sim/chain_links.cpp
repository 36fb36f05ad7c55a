// Finds the bones of an asset's rows that have links, once, when a world gets the asset.

#include "chain_links.h"

#include "memory_carver.h"
#include "world.h"

#include <coif/links.h>

namespace coif {
namespace {

bool is_linked(const Asset& asset, std::uint32_t chain) {
  for (const LinkRecord& link : asset.links()) {
    if (asset.bones()[link.bone].chain == chain || asset.bones()[link.to].chain == chain) return true;
  }
  return false;
}

/// How many chains and bones of an asset have links.
struct LinkedCount {
  explicit LinkedCount(const Asset& asset) {
    for (std::uint32_t chain = 0; chain < asset.chains().size(); ++chain) {
      if (!is_linked(asset, chain)) continue;
      const std::uint32_t count = asset.chains()[chain].bone_count;
      ++chains;
      bones += count;
      longest = count > longest ? count : longest;
    }
  }
  std::uint32_t chains = 0, bones = 0, longest = 0;
};

void carve(MemoryCarver& carver, const Asset& asset, std::uint32_t rows, LinkState& links) {
  const LinkedCount count(asset);
  if (count.chains == 0) return;
  links.row_places = carver.take<std::uint32_t>(rows);
  links.chain_places = carver.take<std::uint32_t>(asset.chains().size());
  links.chains = carver.take<LinkedChain>(count.chains);
  links.bones = carver.take<LinkedBone>(count.bones);
  links.places = carver.take<std::uint32_t>(count.bones);
  links.links = carver.take<ChainLink>(asset.links().size());
  links.levels = carver.take<LinkLevel>(count.longest);
}

void carve_work(MemoryCarver& carver, const Asset& asset, std::uint32_t rows, LinkWork& work) {
  const LinkedCount count(asset);
  if (count.chains == 0) return;
  work.steps = carver.take<LinkedRowStep>(count.chains < rows ? count.chains : rows).data();
  work.held = carver.take<HeldBone>(count.bones).data();
  work.moved = carver.take<char>(count.chains).data();
}

void number_row(WornAsset& worn, std::uint32_t r) {
  const Row& row = worn.rows[r];
  worn.links.row_places[r] = worn.links.row_count++;
  if (row.solver->complete_lane != nullptr) return;  // complete_lane has done it.
  const auto bones = worn.row_bones.subspan(row.first_bone, row.bone_count);
  for (std::uint32_t lane = 0; lane < kLanes; ++lane) find_carried(bones, lane, &worn.constants[row.first_bone]);
}

/// Places rows and chains in the order of the rows.
void place_chains(WornAsset& worn) {
  LinkState& links = worn.links;
  std::uint32_t chain_count = 0, bone_count = 0;
  for (std::uint32_t& place : links.chain_places) place = kNone;
  for (std::uint32_t r = 0; r < worn.rows.size(); ++r) {
    const Row& row = worn.rows[r];
    links.row_places[r] = kNone;
    for (std::uint32_t lane = 0; lane < row.chain_count; ++lane) {
      const std::uint32_t chain = row.first_chain + lane;
      if (!is_linked(worn.asset, chain)) continue;
      if (links.row_places[r] == kNone) number_row(worn, r);
      links.chain_places[chain] = chain_count;
      links.chains[chain_count++] = {links.row_places[r], lane, bone_count, row.bone_count};
      bone_count += row.bone_count;
    }
  }
}

/// One by the mass of everything that hangs from the bone's start, treated as a point mass at its particle.
float mobility_of(const BoneLanes& constants, std::uint32_t lane) {
  const float length = constants.length.v[lane];
  return length * length / constants.carried.v[lane];
}

/// Calls visit(row of the crowd, lane, number of the linked chain) for each linked chain, in the order of the rows.
template <typename Visit>
void for_each_linked(const WornAsset& worn, const Visit& visit) {
  for (const Row& row : worn.rows) {
    for (std::uint32_t lane = 0; lane < row.chain_count; ++lane) {
      const std::uint32_t chain = worn.links.chain_places[row.first_chain + lane];
      if (chain != kNone) visit(row, lane, chain);
    }
  }
}

/// Counts the bones of each level. Until bones have their places, LinkState::places holds their depths.
void count_levels(WornAsset& worn) {
  LinkState& links = worn.links;
  for_each_linked(worn, [&](const Row& row, std::uint32_t, std::uint32_t chain) {
    const auto depths = links.places.subspan(links.chains[chain].first, row.bone_count);
    for (std::uint32_t i = 0; i < row.bone_count; ++i) {
      const std::int32_t parent = worn.row_bones[row.first_bone + i].parent;
      depths[i] = parent < 0 ? 0 : depths[std::size_t(parent)] + 1;
      ++links.levels[depths[i]].bone_count;
    }
  });
  std::uint32_t first = 0;
  for (LinkLevel& level : links.levels) {
    level.first_bone = first;
    first += level.bone_count;
    level.bone_count = 0;
  }
}

/// Sorts bones by depth, and then in the order of the rows.
void place_bones(WornAsset& worn) {
  LinkState& links = worn.links;
  for_each_linked(worn, [&](const Row& row, std::uint32_t lane, std::uint32_t chain) {
    const auto shapes = worn.row_bones.subspan(row.first_bone, row.bone_count);
    const auto constants = worn.constants.subspan(row.first_bone, row.bone_count);
    const auto places = links.places.subspan(links.chains[chain].first, row.bone_count);
    for (std::uint32_t i = 0; i < row.bone_count; ++i) {
      LinkLevel& level = links.levels[places[i]];
      const std::int32_t parent = shapes[i].parent;
      places[i] = level.first_bone + level.bone_count++;
      links.bones[places[i]] = {chain, i, parent < 0 ? -1 : std::int32_t(places[std::size_t(parent)]),
                                shapes[i].children != 0, mobility_of(constants[i], lane)};
    }
  });
}

std::uint32_t place_of(const WornAsset& worn, std::uint32_t bone) {
  const std::uint32_t chain = worn.asset.bones()[bone].chain;
  const LinkedChain& linked = worn.links.chains[worn.links.chain_places[chain]];
  return worn.links.places[linked.first + bone - worn.asset.chains()[chain].first_bone];
}

void create(WornAsset& worn) {
  LinkState& links = worn.links;
  if (links.chains.empty()) return;
  place_chains(worn);
  count_levels(worn);
  place_bones(worn);
  std::uint32_t next_link = 0;
  for (LinkLevel& level : links.levels) {
    level.first_link = next_link;
    for (; next_link < links.links.size(); ++next_link) {
      const LinkRecord& link = worn.asset.links()[next_link];
      const std::uint32_t bone = place_of(worn, link.bone);
      if (bone >= level.first_bone + level.bone_count) break;
      links.links[next_link] = {bone, place_of(worn, link.to), link.shortest, link.longest};
      ++level.link_count;
    }
  }
}

void keep_row(const WornAsset& worn, const LinkWork& work, std::size_t row, const RowStep& step) {
  const std::uint32_t place = worn.links.row_places[row];
  if (place == kNone) return;
  LinkedRowStep& kept = work.steps[place];
  kept.solver = worn.rows[row].solver;
  kept.step = step;
  kept.step.keep_in_limit = worn.links.code->bones->keep_in_limit;
  if (step.character != nullptr) {
    kept.character = *step.character;
    kept.step.character = &kept.character;
  }
  if (step.palette == nullptr) return;
  for (std::uint32_t i = 0; i < kLanes; ++i) kept.palettes[i] = step.palette[i];
  kept.step.palette = kept.palettes;
}

constexpr LinkCode code_for(const LinkedBoneCode& bones, bool of_character) {
  return {.of_character = of_character,
          .bones = &bones,
          .carve = &carve,
          .carve_work = &carve_work,
          .create = &create,
          .keep_row = &keep_row,
          .keep = &hold_links};
}

}  // namespace

constinit const LinkCode kLinks = code_for(kLinkedBones, false);
constinit const LinkCode kCharacterLinks = code_for(kLinkedCharacterBones, true);

}  // namespace coif
