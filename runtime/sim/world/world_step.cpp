#include "world.h"

#include "../head_lanes.h"

#include <bit>

namespace coif {
namespace {

/// Bones of sixteen lanes, times the parts of the step, that make up a job: some ten microseconds.
constexpr std::uint32_t kJobBones = 32;

void wake_all(WorldState& world) {
  for (std::uint32_t head = 0; head < world.heads.size(); ++head) {
    if (world.heads[head].is_asleep) wake(world, head);
  }
}

/// Calls visit(block) for each block of heads that are awake.
template <typename Visit>
void for_each_block(const HeadPace& pace, const Visit& visit) {
  for (WorldBlock* block = pace.blocks.first; block != nullptr && block->count != 0; block = block->next) visit(*block);
}

const HeadCode& code_for(const WorldState& world, std::uint32_t lanes) { return world.head_codes[width_for(lanes)]; }

/// With dt = 0 nothing moves, so a head with a new pose was put there.
void put_moved_heads(WorldBlock& block) {
  for (std::uint32_t i = 0; i < block.count; ++i) {
    if (!is_still(block.heads, i)) block.teleports = std::uint16_t(block.teleports | 1u << i);
  }
}

/// Puts heads that appear elsewhere there, and then finds the ways of all heads.
void look_ahead(WorldState& world, const HeadPace& pace, WorldBlock& block) {
  const StepParts& parts = pace.parts;
  const bool some_are_far = code_for(world, block.count).look_ahead(block.heads, block.count, parts, block.step);
  if (!some_are_far && !(parts.carried > 0.0f) && block.teleports == 0) return;
  bool moved = false;
  for (std::uint32_t i = 0; i < block.count; ++i) {
    const bool is_put = ((block.teleports >> i) & 1u) != 0 || block.step.is_far.v[i] != 0.0f;
    if (!(is_put || parts.carried > 0.0f) || ((block.is_lost >> i) & 1u) != 0) continue;
    WornHead& head = world.heads[block.head[i]];
    if (is_put) {
      jump(world, head, parts.dt);
    } else {
      turn_hair(world, head, carry_head(block.heads, i, parts.carried, lane(block.step.turn, i)));
    }
    moved = true;
  }
  block.teleports = 0;
  if (moved) (void)code_for(world, block.count).look_ahead(block.heads, block.count, parts, block.step);
}

void begin_pace(WorldState& world, HeadPace& pace) {
  const StepSettings& settings = world.settings;
  FrameSpan span;
  add_frame(span, settings.dt);
  pace.parts = parts_of(pace.pace, settings, span);
  const float dt = pace.parts.part_dt();
  const bool is_known = pace.version != 0 && pace.terms.dt == dt && same(pace.terms.scale, settings.dynamics);
  if (!is_known && ++pace.version == 0) pace.version = 1;
  pace.terms = {dt, settings.dynamics};
  for_each_block(pace, [&](WorldBlock& block) {
    look_ahead(world, pace, block);
    code_for(world, block.count).begin(block.heads, block.count, pace.parts, block.step);
  });
}

void share_out(WorldState& world) {
  std::uint32_t steps = 0, work = kJobBones;
  for (const ChainShape* shape = world.shapes; shape != nullptr; shape = shape->next) {
    for (Bundle* bundle = shape->bundles.first; bundle != nullptr && bundle->count != 0; bundle = bundle->next) {
      if (bundle->is_loose) gather_wants(world, *shape, *bundle);
      if (work >= kJobBones) {
        world.jobs[world.job_count++] = steps;
        work = 0;
      }
      world.steps[steps++] = {shape, bundle};
      work += bundle->longest * shape->pace->parts.count;
    }
  }
  world.jobs[world.job_count] = steps;
}

/// The heads of a bundle's lanes, side by side, for HeadCode::move().
struct LaneHeads {
  LaneHeads() {
    for (std::uint32_t& none : head) none = kNone;
  }

  std::uint32_t head[kLanes];
  HeadLanes heads;
  HeadStepLanes step;
};

void gather_head(const WorldBlock& block, std::uint32_t i, LaneHeads& to, std::uint32_t k) {
  const HeadLanes& heads = block.heads;
  set_lane(to.heads.rotation, k, lane(heads.rotation, i));
  set_lane(to.heads.next_rotation, k, lane(heads.next_rotation, i));
  set_lane(to.heads.way, k, lane(heads.way, i));
  set_lane(to.heads.velocity, k, lane(heads.velocity, i));
  set_lane(to.heads.angular_velocity, k, lane(heads.angular_velocity, i));
  to.heads.per_scale.v[k] = heads.per_scale.v[i];
  set_lane(to.step.turn, k, lane(block.step.turn, i));
  set_lane(to.step.next_velocity, k, lane(block.step.next_velocity, i));
  set_lane(to.step.next_angular_velocity, k, lane(block.step.next_angular_velocity, i));
}

/// Does nothing for lanes with the same head as in the last bundle, as is common for long hair. Unused lanes of the
/// vectors compute any values.
void gather_heads(const WorldState& world, const Bundle& bundle, LaneHeads& lanes) {
  const std::uint32_t width = lanes_of(width_for(bundle.count));
  for (std::uint32_t k = 0; k < width; ++k) {
    const bool is_used = k < bundle.count;
    if (!is_used && lanes.head[k] != kNone) continue;
    const std::uint32_t head = bundle.head[is_used ? k : 0];
    if (head == lanes.head[k]) continue;
    lanes.head[k] = head;
    const auto& place = world.heads[head].place;
    gather_head(*place.part, place.lane, lanes, k);
  }
}

void turn_lanes(const WorldState& world, const ChainShape& shape, Bundle& bundle, const Lanes4& by) {
  for (std::uint32_t i = 0; i < bundle.count; ++i) {
    shape.solver->turn(chain_lane(shape, {&bundle, i}, bones_in(world, bundle, i)), lane(by, i));
  }
}

/// Sets everything except where the matrices go.
RowStep row_step(const WorldState& world, const ChainShape& shape, Bundle& bundle, const MoveLanes& move) {
  RowStep row;
  row.bones = {bundle.bones, bundle.longest};
  row.constants = bundle.constants;
  row.limits = bundle.limits;
  row.keep_in_limit = world.keep_in_limit[width_for(bundle.count)];
  row.coefficients = bundle.coefficients;
  row.state = bundle.state;
  row.twist = bundle.twist;
  row.scratch = bundle.scratch;
  row.lanes = bundle.count;
  row.move = &move;
  row.dt = shape.pace->parts.part_dt();
  row.colliders = shape.touching == 0 ? nullptr : &shape.colliders->placed;
  row.motion = &bundle.motion;
  return row;
}

void step_bundle(const WorldState& world, const ChainShape& shape, Bundle& bundle, LaneHeads& lanes) {
  renew_coefficients(world, shape, bundle);
  if (!bundle.has_all_bones) fill_missing_bones(shape, bundle);
  gather_heads(world, bundle, lanes);
  Mat34* palettes[kLanes];  // Only lanes in use.
  for (std::uint32_t i = 0; i < bundle.count; ++i) {
    const WornHead& head = world.heads[bundle.head[i]];
    palettes[i] = &head.palette[world.assets[head.asset].asset.chains()[bundle.chain[i]].first_bone];
  }
  const StepParts& parts = shape.pace->parts;
  const std::uint32_t width = width_for(bundle.count);
  const HeadCode& heads = world.head_codes[width];
  MoveLanes move;
  Lanes4 carried;
  RowStep row = row_step(world, shape, bundle, move);
  for (std::uint32_t part = 0; part < parts.count; ++part) {
    heads.move(lanes.heads, bundle.count, lanes.step, parts, part, move, carried);
    if (parts.inertia < 1.0f) turn_lanes(world, shape, bundle, carried);
    bundle.motion = Lanes{};
    row.palette = part + 1 == parts.count ? palettes : nullptr;
    shape.steps[width](row);
  }
}

/// Sum of the squared speeds of a head's tips, in the order of its chains, as a crowd sums them.
float motion_of(const WornHead& head) {
  float motion = 0;
  for (const ChainPlace& place : head.places) motion += place.part->motion.v[place.lane];
  return motion;
}

void finish_block(WorldState& world, const HeadPace& pace, WorldBlock& block) {
  Lanes motion{};
  for (std::uint32_t i = 0; i < block.count; ++i) motion.v[i] = motion_of(world.heads[block.head[i]]);
  const RestWatch watch = rest_watch(world.settings, pace.parts.dt);
  const RestingHeads resting = code_for(world, block.count).finish(block.heads, block.count, block.step, motion, watch);
  const std::uint32_t ended = sort_out(resting, block.count, block.is_lost, block.may_sleep);
  for (std::uint32_t left = ended; left != 0; left &= left - 1) {
    put_to_rest(world, world.heads[block.head[std::countr_zero(left)]]);
  }
}

/// A lane that a head leaves may be taken by another one that falls asleep too.
void let_sleep(WorldState& world, WorldBlock& block) {
  while (block.may_sleep != 0) {
    const auto i = std::uint32_t(std::countr_zero(block.may_sleep));
    block.may_sleep = std::uint16_t(block.may_sleep & ~(1u << i));
    fall_asleep(world, block.head[i]);
  }
}

}  // namespace

void begin_step(WorldState& world, const StepSettings& settings) {
  if (world.has_stepped && !rests_under_both(world.settings, settings)) wake_all(world);
  world.settings = settings;
  const bool passes = settings.dt >= kShortestStep;
  for (HeadPace& pace : world.paces) {
    if (!pace.blocks.is_used()) continue;
    if (passes) begin_pace(world, pace);
    if (!passes) for_each_block(pace, [](WorldBlock& block) { put_moved_heads(block); });
  }
  if (!passes) return;
  world.has_stepped = world.is_in_step = true;
  for (WornAsset& worn : world.assets) {
    if (worn.heads != 0 && worn.version != worn.pace->version) renew_motions(world, worn);
  }
  share_out(world);
}

void run_job(const WorldState& world, std::uint32_t job) {
  LaneHeads lanes;
  for (std::uint32_t i = world.jobs[job]; i < world.jobs[job + 1]; ++i) {
    step_bundle(world, *world.steps[i].shape, *world.steps[i].bundle, lanes);
  }
}

void finish_step(WorldState& world) {
  for (const HeadPace& pace : world.paces) {
    for_each_block(pace, [&](WorldBlock& block) { finish_block(world, pace, block); });
    for_each_block(pace, [&](WorldBlock& block) { let_sleep(world, block); });
  }
  world.job_count = 0;
  world.is_in_step = false;
}

}  // namespace coif
