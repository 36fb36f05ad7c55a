// One step of the chains of several heads.

#include "../head_lanes.h"
#include "../world_step.h"
#include "bundles.h"

namespace coif {
namespace {

/// Bones of sixteen lanes, times the parts of the step, that make up a job: some ten microseconds.
constexpr std::uint32_t kJobBones = 32;

/// The heads of a bundle's lanes, side by side, for HeadCode::move().
struct LaneHeads {
  LaneHeads() {
    for (std::uint32_t& none : head) none = kNone;
  }

  std::uint32_t head[kLanes];
  HeadLanes heads;
  HeadStepLanes step;
  ColliderBounds bounds[kMaxPlaces];  // Not initialised, like the next: filled where needed.
  GustLanes gusts;
};

void gather_head(const Block& block, std::uint32_t i, LaneHeads& to, std::uint32_t k) {
  const HeadLanes& heads = block.heads;
  set_lane(to.heads.rotation, k, lane(heads.rotation, i));
  set_lane(to.heads.next_rotation, k, lane(heads.next_rotation, i));
  set_lane(to.heads.way, k, lane(heads.way, i));
  set_lane(to.heads.velocity, k, lane(heads.velocity, i));
  set_lane(to.heads.angular_velocity, k, lane(heads.angular_velocity, i));
  to.heads.per_scale.v[k] = heads.per_scale.v[i];
  set_lane(to.step.turn, k, lane(block.step->turn, i));
  set_lane(to.step.next_velocity, k, lane(block.step->next_velocity, i));
  set_lane(to.step.next_angular_velocity, k, lane(block.step->next_angular_velocity, i));
}

/// Does nothing for lanes with the same head as in the last bundle, as is common for long hair. Unused lanes of the
/// vectors compute any values.
void gather_heads(const WorldState& world, const Bundle& bundle, LaneHeads& lanes) {
  const std::uint32_t width = lanes_of(width_for(bundle.count));
  for (std::uint32_t k = 0; k < width; ++k) {
    const bool is_used = k < bundle.count;
    if (!is_used && lanes.head[k] != kNone) continue;
    const std::uint32_t index = bundle.head[is_used ? k : 0];
    if (index == lanes.head[k]) continue;
    lanes.head[k] = index;
    const WornHead& head = world.heads[index];
    gather_head(*head.block, head.lane, lanes, k);
    for (int axis = 0; !world.gusts.empty() && axis < 3; ++axis) {
      lanes.heads.next_position[axis][k] = head.block->heads.next_position[axis][head.lane];
    }
  }
}

void turn_lanes(const WorldState& world, const ChainShape& shape, Bundle& bundle, const Lanes4& by) {
  for (std::uint32_t i = 0; i < bundle.count; ++i) {
    const std::uint32_t bones = bones_in(world, bundle, i);
    shape.solver->turn(chain_lane(shape, {&bundle, i}, bones < bundle.longest ? bundle.longest : bones), lane(by, i));
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
  row.dt = shape.crowd->parts[bundle.treatment.power].part_dt();
  row.iterations = world.settings.iterations;
  row.level = bundle.treatment.level;
  row.colliders = shape.touching == 0 ? nullptr : &shape.colliders->placed;
  row.motion = &bundle.motion;
  return row;
}

/// What a bundle's chains meet on their characters.
class BundleCharacter {
 public:
  BundleCharacter(const WorldState& world, const Bundle& bundle, LaneHeads& lanes)
      : world_(world), code_(world.rules.character), bundle_(bundle) {
    heads_.heads = &lanes.heads;
    heads_.head = bundle.head;
    heads_.count = bundle.count;
    heads_.bounds = lanes.bounds;
    heads_.gusts = &lanes.gusts;
    if (code_ != nullptr) code_->gather(world, heads_);
  }

  void begin(const StepParts& parts, std::uint32_t part, MoveLanes& move, RowStep& row) {
    if (code_ == nullptr) return;
    code_->blow(world_, heads_, parts, part, move);
    code_->set_up(world_, heads_, parts, part, character_);
    character_.poses = character_.is_posed ? bundle_.poses : nullptr;
    character_.body_sets = bundle_.body_sets;
    row.character = &character_;
  }

 private:
  const WorldState& world_;
  const CharacterCode* code_;
  const Bundle& bundle_;
  RowHeads heads_;
  RowCharacter character_;
};

void step_bundle(const WorldState& world, const ChainShape& shape, Bundle& bundle, LaneHeads& lanes) {
  renew_coefficients(world, shape, bundle);
  if (!bundle.has_all_bones) fill_missing_bones(shape, bundle);
  gather_heads(world, bundle, lanes);
  Mat34* palettes[kLanes];  // Only lanes in use.
  for (std::uint32_t i = 0; i < bundle.count; ++i) {
    const Asset& asset = worn_in(world, bundle, i).asset;
    const std::span<Mat34> palette = world.palette(world.heads[bundle.head[i]]);
    palettes[i] = &palette[asset.chains()[bundle.chain[i]].first_bone];
  }
  const StepParts& parts = shape.crowd->parts[bundle.treatment.power];
  const std::uint32_t width = width_for(bundle.count);
  const HeadCode& heads = world.head_codes[width];
  MoveLanes move;
  Lanes4 carried;
  RowStep row = row_step(world, shape, bundle, move);
  BundleCharacter character(world, bundle, lanes);
  for (std::uint32_t part = 0; part < parts.count; ++part) {
    heads.move(lanes.heads, bundle.count, lanes.step, parts, part, move, carried);
    if (parts.inertia < 1.0f) turn_lanes(world, shape, bundle, carried);
    character.begin(parts, part, move, row);
    bundle.motion = Lanes{};
    row.palette = part + 1 == parts.count ? palettes : nullptr;
    shape.steps[width](row);
  }
}

}  // namespace

void share_out(WorldState& world, const Crowd& crowd) {
  std::uint32_t work = kJobBones;
  for (const ChainShape* shape = crowd.shapes; shape != nullptr; shape = shape->next) {
    for (std::uint32_t list = 0; list < shape->lists.size(); ++list) {
      Bundle* bundle = shape->lists[list].bundles.first;
      const Treatment& treatment = crowd.lists[list + 1].treatment;
      if (!treatment.has_its_turn(world.step_index)) continue;
      for (; bundle != nullptr; bundle = bundle->next) {
        bundle->treatment = treatment;
        if (bundle->is_loose) gather_wants(world, *shape, *bundle);
        if (work >= kJobBones) {
          world.jobs[world.job_count++] = world.unit_count;
          work = 0;
        }
        world.units[world.unit_count++] = {shape, bundle};
        work += bundle->longest * crowd.parts[treatment.power].count;
      }
    }
  }
}

void run_bundles(const WorldState& world, std::uint32_t first, std::uint32_t end) {
  LaneHeads lanes;
  for (std::uint32_t i = first; i < end; ++i) {
    step_bundle(world, *world.units[i].shape, *static_cast<Bundle*>(world.units[i].part), lanes);
  }
}

}  // namespace coif
