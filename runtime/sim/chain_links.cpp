// Which bones of a crowd's rows links are about: laid out once, when a crowd is created.

#include "chain_links.h"

#include "crowd.h"
#include "hold_links.h"
#include "memory_carver.h"

#include <coif/links.h>

namespace coif {
namespace {

bool is_linked(const Asset& asset, std::uint32_t chain) {
  for (const LinkRecord& link : asset.links()) {
    if (asset.bones()[link.bone].chain == chain || asset.bones()[link.to].chain == chain) return true;
  }
  return false;
}

void carve(MemoryCarver& carver, const Asset& asset, std::uint32_t rows, std::uint32_t blocks, LinkState& links) {
  std::uint32_t chains = 0, bones = 0, longest = 0;
  for (std::uint32_t chain = 0; chain < asset.chains().size(); ++chain) {
    if (!is_linked(asset, chain)) continue;
    const std::uint32_t count = asset.chains()[chain].bone_count;
    ++chains;
    bones += count;
    longest = count > longest ? count : longest;
  }
  if (chains == 0) return;
  const std::uint32_t linked_rows = chains < rows ? chains : rows;
  links.row_places = carver.take<std::uint32_t>(rows);
  links.chain_places = carver.take<std::uint32_t>(asset.chains().size());
  links.chains = carver.take<LinkedChain>(chains);
  links.bones = carver.take<LinkedBone>(bones);
  links.places = carver.take<std::uint32_t>(bones);
  links.links = carver.take<ChainLink>(asset.links().size());
  links.levels = carver.take<LinkLevel>(longest);
  links.steps = carver.take<LinkedRowStep>(std::uint64_t(blocks) * linked_rows);
  links.held = carver.take<HeldBone>(std::uint64_t(blocks) * bones);
  links.moved = carver.take<char>(std::uint64_t(blocks) * chains);
}

/// Rows and chains in the order of the rows.
void place_chains(CrowdState& crowd) {
  LinkState& links = crowd.links;
  std::uint32_t chain_count = 0, bone_count = 0;
  for (std::uint32_t& place : links.chain_places) place = kNone;
  for (std::uint32_t r = 0; r < crowd.rows.size(); ++r) {
    const Row& row = crowd.rows[r];
    links.row_places[r] = kNone;
    for (std::uint32_t lane = 0; lane < row.chain_count; ++lane) {
      const std::uint32_t chain = row.first_chain + lane;
      if (!is_linked(crowd.asset, chain)) continue;
      if (links.row_places[r] == kNone) links.row_places[r] = links.row_count++;
      links.chain_places[chain] = chain_count;
      links.chains[chain_count++] = {links.row_places[r], lane, bone_count, row.bone_count};
      bone_count += row.bone_count;
    }
  }
}

std::uint32_t depth_of(std::span<const RowBone> bones, std::uint32_t bone) {
  std::uint32_t depth = 0;
  for (std::int32_t up = bones[bone].parent; up >= 0; up = bones[std::size_t(up)].parent) ++depth;
  return depth;
}

/// One by the mass of everything that hangs from the bone's start, as it were at its particle.
float mobility_of(const BoneLanes& constants, std::uint32_t lane) {
  const float length = constants.length.v[lane];
  return length * length / constants.carried.v[lane];
}

/// The bones of `depth`, after those of lesser depth. Returns how many there are.
std::uint32_t place_bones(CrowdState& crowd, std::uint32_t depth, std::uint32_t first) {
  LinkState& links = crowd.links;
  std::uint32_t next = first;
  for (std::uint32_t r = 0; r < crowd.rows.size(); ++r) {
    if (links.row_places[r] == kNone) continue;
    const Row& row = crowd.rows[r];
    const auto shapes = crowd.row_bones.subspan(row.first_bone, row.bone_count);
    if (depth == 0) find_carried(shapes, crowd.constants.subspan(row.first_bone, row.bone_count));
    for (std::uint32_t lane = 0; lane < row.chain_count; ++lane) {
      const std::uint32_t chain = links.chain_places[row.first_chain + lane];
      if (chain == kNone) continue;
      const std::uint32_t* const places = &links.places[links.chains[chain].first];
      for (std::uint32_t i = 0; i < row.bone_count; ++i) {
        if (depth_of(shapes, i) != depth) continue;
        const std::int32_t parent = shapes[i].parent;
        links.places[links.chains[chain].first + i] = next;
        links.bones[next++] = {chain, i, parent < 0 ? -1 : std::int32_t(places[parent]), shapes[i].children != 0,
                               mobility_of(crowd.constants[row.first_bone + i], lane)};
      }
    }
  }
  return next - first;
}

std::uint32_t place_of(const CrowdState& crowd, std::uint32_t bone) {
  const std::uint32_t chain = crowd.asset.bones()[bone].chain;
  const LinkedChain& linked = crowd.links.chains[crowd.links.chain_places[chain]];
  return crowd.links.places[linked.first + bone - crowd.asset.chains()[chain].first_bone];
}

void create(CrowdState& crowd) {
  LinkState& links = crowd.links;
  if (links.chains.empty()) return;
  place_chains(crowd);
  std::uint32_t next_bone = 0, next_link = 0;
  for (std::uint32_t depth = 0; depth < links.levels.size(); ++depth) {
    LinkLevel& level = links.levels[depth];
    level.first_bone = next_bone;
    level.bone_count = place_bones(crowd, depth, next_bone);
    next_bone += level.bone_count;
  }
  for (LinkLevel& level : links.levels) {
    level.first_link = next_link;
    for (; next_link < links.links.size(); ++next_link) {
      const LinkRecord& link = crowd.asset.links()[next_link];
      const std::uint32_t bone = place_of(crowd, link.bone);
      if (bone >= level.first_bone + level.bone_count) break;
      links.links[next_link] = {bone, place_of(crowd, link.to), link.shortest, link.longest};
      ++level.link_count;
    }
  }
}

void keep_row(CrowdState& crowd, std::uint32_t block, std::size_t row, const RowStep& step) {
  const LinkState& links = crowd.links;
  const std::uint32_t place = links.row_places[row];
  if (place == kNone) return;
  LinkedRowStep& kept = links.steps[block * std::size_t(links.row_count) + place];
  kept.solver = crowd.rows[row].solver;
  kept.step = step;
  kept.step.keep_in_limit = links.code->keep_in_limit;
  if (step.character != nullptr) {
    kept.character = *step.character;
    kept.step.character = &kept.character;
  }
  if (step.palette == nullptr) return;
  for (std::uint32_t i = 0; i < kLanes; ++i) kept.palettes[i] = step.palette[i];
  kept.step.palette = kept.palettes;
}

template <const LinkedBoneCode& kBones>
float keep(CrowdState& crowd, std::uint32_t block, std::int32_t lane) {
  return hold_links(crowd, kBones, block, lane);
}

/// In constants of other files there is nothing yet when these are made.
template <const LinkedBoneCode& kBones>
void keep_alone(void* bone) {
  kBones.keep_in_limit(bone);
}

}  // namespace

const LinkCode kLinks{.of_character = false,
                      .keep_in_limit = &keep_alone<kLinkedBones>,
                      .carve = &carve,
                      .create = &create,
                      .keep_row = &keep_row,
                      .keep = &keep<kLinkedBones>};
const LinkCode kCharacterLinks{.of_character = true,
                               .keep_in_limit = &keep_alone<kLinkedCharacterBones>,
                               .carve = &carve,
                               .create = &create,
                               .keep_row = &keep_row,
                               .keep = &keep<kLinkedCharacterBones>};

}  // namespace coif
