
#include "vector_math.h"
#include "world_step.h"

namespace coif {
namespace {

const GustField* blowing(const WorldState& world) {
  if (world.gusts.empty() || world.gusts[0].told.amplitude == 0.0f) return nullptr;
  return &world.gusts[0];
}

HeadAir air_of(const WorldState& world, std::uint32_t head) {
  return world.airs.empty() ? HeadAir{} : world.airs[head];
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

void blow(const WorldState& world, const RowHeads& heads, const StepParts& parts, std::uint32_t part, MoveLanes& move) {
  const GustField* const field = blowing(world);
  if (world.airs.empty() && field == nullptr) return;
  const float left = 1.0f - (float(part) + 0.5f) / float(parts.count);
  for (std::uint32_t i = 0; i < heads.count; ++i) {
    const HeadAir air = air_of(world, heads.head[i]);
    if (!(air.wind == Vec3{}) || air.exposure != 1.0f) {
      const Vec3 change = air.wind + parts.wind * (air.exposure - 1.0f);
      set_lane(move.air, i, lane(move.air, i) + change * heads.heads->per_scale.v[i]);
    }
    if (field != nullptr) meet_gusts(*field, *heads.heads, i, parts.dt * left, left, air.exposure, *heads.gusts);
  }
}

void keep_awake_in_gusts(const WorldState& world, BlockStep& step) {
  if (blowing(world) == nullptr) return;
  for (std::uint32_t i = 0; i < step.block.count; ++i) {
    const bool is_reached = air_of(world, step.block.head[i]).exposure != 0.0f;
    if (is_reached) step.block.heads.quiet.v[i] = -2.0f * step.parts.dt;
  }
}

void set_up_air(const WorldState& world, const RowHeads& heads, RowCharacter& row) {
  const GustField* const field = blowing(world);
  row.gusts = field != nullptr ? heads.gusts : nullptr;
  row.waves = field != nullptr ? &field->waves : nullptr;
}

}  // namespace coif
