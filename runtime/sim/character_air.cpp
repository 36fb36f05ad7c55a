#include "character_air.h"

#include "crowd.h"
#include "memory_carver.h"
#include "vector_math.h"

namespace coif {
namespace {

const GustField* blowing(const CharacterState& character) {
  if (character.gusts.empty() || character.gusts[0].told.amplitude == 0.0f) return nullptr;
  return &character.gusts[0];
}

HeadAir air_of(const CharacterState& character, std::uint32_t instance) {
  return character.airs.empty() ? HeadAir{} : character.airs[instance];
}

/// Evaluates the waves at a head in the middle of a part of a step, `back` seconds before the step's end, where the
/// share `left` of its way still lies ahead.
void meet_gusts(const GustField& field, const HeadLanes& heads, std::uint32_t i, float back, float left, float strength,
                GustLanes& lanes) {
  const Vec3 way = lane(heads.way, i) * left;
  const double ahead[3] = {double(way.x), double(way.y), double(way.z)};
  const double come = field.way - double(field.told.speed) * double(back);
  for (std::uint32_t k = 0; k < kGustWaves; ++k) {
    double turns = field.waves.begin[k] - field.waves.turns_per_way[k] * come;
    for (int axis = 0; axis < 3; ++axis) {
      turns += field.waves.turns[k][axis] * (heads.next_position[axis][i] - ahead[axis]);
    }
    lanes.turns[k].v[i] = part_turn(turns);
  }
  lanes.scale.v[i] = 1.0f / heads.per_scale.v[i];
  lanes.strength.v[i] = strength * heads.per_scale.v[i];
}

}  // namespace

float part_turn(double turns) {
  if (!(turns > -1e15 && turns < 1e15)) return 0;
  const double whole = double(std::int64_t(turns < 0 ? turns - 0.5 : turns + 0.5));
  return float(turns - whole);
}

void carve_air(MemoryCarver& carver, const HairDesc& desc, std::uint32_t blocks, CharacterState& character) {
  character.airs = carver.take<HeadAir>(desc.has_own_air ? desc.instances : 0);
  character.gust_lanes = carver.take<GustLanes>(desc.feels_gusts ? blocks : 0);
  character.gusts = carver.take<GustField>(desc.feels_gusts ? 1 : 0);
}

void pass_time(CrowdState& crowd, float dt) {
  if (crowd.character.gusts.empty()) return;
  GustField& field = crowd.character.gusts[0];
  field.way += double(field.told.speed) * double(dt);
}

void blow(CrowdState& crowd, std::uint32_t index, const StepParts& parts, std::uint32_t part, MoveLanes& move) {
  const CharacterState& character = crowd.character;
  const GustField* const field = blowing(character);
  if (character.airs.empty() && field == nullptr) return;
  Block& block = crowd.blocks[index];
  const float left = 1.0f - (float(part) + 0.5f) / float(parts.count);
  for (std::uint32_t i = 0; i < block.count; ++i) {
    const HeadAir air = air_of(character, block.instance[i]);
    if (!(air.wind == Vec3{}) || air.exposure != 1.0f) {
      const Vec3 change = air.wind + parts.wind * (air.exposure - 1.0f);
      set_lane(move.air, i, lane(move.air, i) + change * block.heads.per_scale.v[i]);
    }
    if (field == nullptr) continue;
    meet_gusts(*field, block.heads, i, parts.dt * left, left, air.exposure, character.gust_lanes[index]);
    // Between two gusts hair may hardly move for a while. That must not count as rest.
    if (air.exposure != 0.0f) block.heads.quiet.v[i] = -2.0f * parts.dt;
  }
}

void set_up_air(const CharacterState& character, std::uint32_t block, RowCharacter& row) {
  const GustField* const field = blowing(character);
  row.gusts = field != nullptr ? &character.gust_lanes[block] : nullptr;
  row.waves = field != nullptr ? &field->waves : nullptr;
}

}  // namespace coif
