#include "motion/motion.h"

#include "motion/head_path.h"

namespace coif {
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
};

}  // namespace

std::span<const MotionInfo> all_motions() { return kMotions; }

std::optional<Motion> find_motion(std::string_view name) {
  for (const MotionInfo& info : kMotions) {
    if (name == info.name) return info.motion;
  }
  return std::nullopt;
}

HeadPose head_pose(Motion motion, double seconds) { return path_of(motion)->pose(seconds); }

}  // namespace coif
