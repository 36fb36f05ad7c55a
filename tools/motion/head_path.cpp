#include "motion/head_path.h"

#include "base/geometry.h"
#include "base/hair_runtime.h"
#include "motion/motion_path.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace coif::motion {

namespace {

HeadState state_of(const HeadMovement& moved) {
  HeadState state;
  state.position = {moved.x.value, moved.y.value, moved.z.value};
  state.velocity = {moved.x.rate, moved.y.rate, moved.z.rate};
  state.acceleration = {moved.x.acceleration, moved.y.acceleration, moved.z.acceleration};
  state.rotation = Eigen::AngleAxisd(moved.turn.value, moved.axis);
  state.angular_velocity = moved.axis * moved.turn.rate;
  state.angular_acceleration = moved.axis * moved.turn.acceleration;
  return state;
}

class MotionPath final : public HeadPath {
 public:
  explicit MotionPath(Motion motion) : motion_(motion) {}

  [[nodiscard]] HeadState at(double seconds, double inside) const override {
    if (seconds < 0) return standing(state_of(movement(motion_, 0, 0)));
    return state_of(movement(motion_, seconds, std::max(inside, 0.0)));
  }
  [[nodiscard]] std::vector<PathBreak> breaks(double until) const override { return breaks_of(motion_, until); }

 private:
  Motion motion_;
};

}  // namespace

HeadState standing(const HeadState& moved) {
  HeadState state;
  state.position = moved.position;
  state.rotation = moved.rotation;
  return state;
}

HeadPose HeadPath::pose(double seconds) const { return pose_of(at(seconds)); }

std::unique_ptr<HeadPath> path_of(Motion motion) { return std::make_unique<MotionPath>(motion); }

namespace {

class TurnedPath final : public HeadPath {
 public:
  explicit TurnedPath(std::unique_ptr<HeadPath> path) : path_(std::move(path)) {}

  [[nodiscard]] HeadState at(double seconds, double inside) const override {
    HeadState state = path_->at(seconds, inside);
    for (Eigen::Vector3d* v : {&state.position, &state.velocity, &state.acceleration, &state.angular_velocity,
                               &state.angular_acceleration}) {
      *v = {-v->x(), v->y(), -v->z()};
    }
    const Eigen::Quaterniond& q = state.rotation;
    state.rotation = {q.w(), -q.x(), q.y(), -q.z()};  // half a turn about Y before and back after it
    return state;
  }
  [[nodiscard]] std::vector<PathBreak> breaks(double until) const override { return path_->breaks(until); }

 private:
  std::unique_ptr<HeadPath> path_;
};

}  // namespace

std::unique_ptr<HeadPath> turned_round(std::unique_ptr<HeadPath> path) {
  return std::make_unique<TurnedPath>(std::move(path));
}

HeadPose pose_of(const HeadState& state) {
  HeadPose pose;
  std::copy_n(state.position.data(), 3, pose.position);
  const Eigen::Quaternionf rotation = state.rotation.cast<float>();
  pose.rotation = {rotation.x(), rotation.y(), rotation.z(), rotation.w()};
  return pose;
}

HeadVelocity velocity_of(const HeadState& state) { return {to_vec3(state.velocity), to_vec3(state.angular_velocity)}; }

namespace {

constexpr MotionInfo kMotions[] = {
    {Motion::kStill, "still", "no movement: the hair sags under gravity and settles"},
    {Motion::kNod, "nod", "nods 40 deg up and down about X at 0.77 Hz"},
    {Motion::kTurn, "turn", "shakes the head 57 deg to each side about Y at 1.54 Hz"},
    {Motion::kCharge, "charge", "from 0 to 8 m/s forward (+Z) in 0.3 s, then steady"},
    {Motion::kRun, "run", "bobs 6 cm and nods 6 deg at 2.4 Hz while swaying forward and back at up to 3 m/s"},
    {Motion::kJump, "jump", "crouches 25 cm, jumps 45 cm high, lands and rises; repeats"},
    {Motion::kTumble, "tumble", "a forward somersault about X in 0.8 s with a hop of 1 m; repeats every 1.5 s"},
    {Motion::kTeleport, "teleport", "still, but for a jump of 10 m (+X) at 1 s and a turn of 180 deg about Y at 2 s"},
    {Motion::kBow, "bow", "bends 120 deg forward and down in 0.8 s: hair falls over the face; repeats every 2.8 s"},
    {Motion::kLie, "lie", "lies down on the back in 0.8 s, and stays there"},
    {Motion::kJog, "jog", "bobs 4.5 cm up and down at 2.4 steps a second and leans 1 deg to the side of each foot"},
};

}  // namespace

std::span<const MotionInfo> all_motions() { return kMotions; }

std::optional<Motion> find_motion(std::string_view name) {
  for (const MotionInfo& info : kMotions) {
    if (name == info.name) return info.motion;
  }
  return std::nullopt;
}

const char* name_of(Motion motion) { return kMotions[std::size_t(motion)].name; }

HeadPose head_pose(Motion motion, double seconds) { return path_of(motion)->pose(seconds); }

namespace {

class HeldTurn final : public HeadPath {
 public:
  HeldTurn(const Eigen::Vector3d& axis, double radians, double seconds)
      : axis_(axis), radians_(radians), seconds_(seconds) {}

  [[nodiscard]] HeadState at(double seconds, double inside) const override {
    const Jet u = inside < seconds_ ? Jet::time(std::max(seconds, 0.0)) * (1 / seconds_) : Jet(1.0);
    const Jet turn = radians_ * (u * u * u * (10 - 15 * u + 6 * u * u));
    HeadState state;
    state.rotation = Eigen::AngleAxisd(turn.value, axis_);
    state.angular_velocity = axis_ * turn.rate;
    state.angular_acceleration = axis_ * turn.acceleration;
    return state;
  }

  [[nodiscard]] std::vector<PathBreak> breaks(double until) const override {
    if (seconds_ > until) return {};
    return {{seconds_, false}};
  }

 private:
  Eigen::Vector3d axis_;
  double radians_;
  double seconds_;
};

}  // namespace

std::unique_ptr<HeadPath> held_turn(const Eigen::Vector3d& axis, double radians, double seconds) {
  return std::make_unique<HeldTurn>(axis, radians, seconds);
}

std::unique_ptr<HeadPath> held_attitude(const Eigen::Vector3d& up, double seconds) {
  const Eigen::Vector3d to = up.normalized(), axis = Eigen::Vector3d::UnitY().cross(to);
  const double radians = std::atan2(axis.norm(), to.y());
  return held_turn(axis.norm() > 1e-9 ? Eigen::Vector3d(axis.normalized()) : Eigen::Vector3d::UnitX(), radians,
                   seconds);
}

std::vector<HeldAttitude> held_attitudes() {
  std::vector<HeldAttitude> all;
  for (int cell = 0; cell < 27; ++cell) {
    const Eigen::Vector3d up(cell / 9 - 1, cell / 3 % 3 - 1, cell % 3 - 1);
    if (!up.isZero()) all.push_back({up, held_attitude(up)});
  }
  return all;
}

namespace {

constexpr double kRate = 60;  // Hz
constexpr int kSettleSteps = 120;

tl::unexpected<ToolError> not_simulated(const char* why) {
  return failure(ToolError::Kind::kBadInput, std::string("the hair cannot be simulated: ") + why);
}

}  // namespace

tl::expected<std::vector<HairPose>, ToolError> simulate_poses(const Asset& asset, const HeadPath* motion,
                                                              std::span<const double> seconds, StepSettings step,
                                                              const Solver* solver, const HairCompany* company) {
  const HairCompany beside = company ? *company : HairCompany();
  const auto pose_at = [&](double time) {
    HeadPose pose = motion ? motion->pose(time) : HeadPose{};
    pose.scale = beside.scale;
    return pose;
  };
  std::vector<HairPose> poses;
  if (asset.dynamics().empty()) {
    for (const double time : seconds) poses.push_back({pose_at(time), std::vector<Mat34>(asset.bones().size())});
    return poses;
  }
  step.dt = static_cast<float>(1 / kRate);
  const HairDesc desc = beside.description(asset, solver);
  const MemoryNeed need = Hair::memory_need(asset, desc);
  const HairMemory memory = allocate(need);
  if (!memory) return not_simulated("out of memory");
  Hair hair;
  Status status = hair.create(asset, desc, {memory.get(), need.bytes});
  if (status == Status::kOk) status = hair.reset(0, pose_at(0));
  int done = -kSettleSteps;
  for (const double time : seconds) {
    const int until = motion ? static_cast<int>(std::lround(time * kRate)) : 0;
    while (done < until && status == Status::kOk) {
      ++done;
      const double now = done > 0 ? done / kRate : 0;
      status = hair.set_head(0, pose_at(now));
      if (status == Status::kOk) status = beside.tell(hair, now);
      if (status == Status::kOk) status = hair.step(step);
    }
    if (status != Status::kOk) return not_simulated(describe(status));
    const std::span<const Mat34> palette = hair.palette(0);
    poses.push_back({pose_at(until / kRate), {palette.begin(), palette.end()}});
  }
  return poses;
}

tl::expected<HairPose, ToolError> simulate_pose(const Asset& asset, const HeadPath* motion, double seconds,
                                                const StepSettings& step, const Solver* solver,
                                                const HairCompany* company) {
  auto poses = simulate_poses(asset, motion, {&seconds, 1}, step, solver, company);
  if (!poses) return tl::unexpected(poses.error());
  return std::move(poses->front());
}

HairDesc HairCompany::description(const Asset& asset, const Solver* usual) const {
  HairDesc desc;
  desc.solver = usual;
  const bool in_gusts = gusts.amplitude > 0;
  const bool is_worn = colliders || pose || in_gusts;
  if (is_worn && usual == &kCoifSolver) desc.solver = &kCharacterSolver;
  desc.links = links_of(asset, *desc.solver);
  if (colliders) desc.moving_colliders = kMaxMovingColliders;
  desc.follows_poses = bool(pose);
  desc.feels_gusts = in_gusts;
  return desc;
}

Status HairCompany::tell(Hair& hair, double seconds) const {
  if (colliders) {
    const auto now = colliders(seconds);
    if (const Status status = hair.set_colliders(0, now); status != Status::kOk) return status;
  }
  if (gusts.amplitude > 0) {
    if (const Status status = hair.set_gusts(gusts); status != Status::kOk) return status;
  }
  if (!pose) return Status::kOk;
  return hair.set_pose(0, pose(seconds), {&pose_weight, 1});
}

std::span<const HeadLook> head_looks() {
  static const HeadLook kLooks[] = {{"look-down", "looking down", Eigen::Vector3d::UnitX(), 55, 0.4},
                                    {"look-aside", "a rapid turn", Eigen::Vector3d::UnitY(), 80, 0.25},
                                    {"look-up", "looking up", Eigen::Vector3d::UnitX(), -50, 0.4}};
  return kLooks;
}

std::unique_ptr<HeadPath> path_of(const HeadLook& look) {
  return held_turn(look.axis, look.degrees * kDegree, look.seconds);
}

}  // namespace coif::motion
