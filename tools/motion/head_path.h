#pragma once
// What a head has beside it while its hair is simulated: a character's hands, size and animation.

#include "base/tool_error.h"

#include <coif/asset.h>
#include <coif/hair.h>
#include <coif/math.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <tl/expected.hpp>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace coif::motion {

struct HairCompany {
  std::function<std::vector<MovingCollider>(double seconds)> colliders{};  ///< World. Empty: none.
  /// The pose at that time, rotations of all the asset's bones as Hair::set_pose() takes them. Empty: none.
  std::function<std::vector<Quat>(double seconds)> pose{};
  float pose_weight = 1;  ///< 1: the pose is what pulls, 0: the hair is the pose.
  float scale = 1;        ///< Of the head.
  Gusts gusts{};          ///< Of amplitude 0: none.

  /// Which solver it needs: `usual` where it asks for nothing more.
  [[nodiscard]] HairDesc description(const Asset& asset, const Solver* usual) const;
  /// Tells the hair of one head where all will be at the end of the coming step.
  [[nodiscard]] Status tell(Hair& hair, double seconds) const;
};

/// A head's built-in movement, defined for every time; starts at rest at the origin (y = 0) at t = 0.
enum class Motion { kStill, kNod, kTurn, kCharge, kRun, kJump, kTumble, kTeleport, kBow, kLie, kJog };

struct MotionInfo {
  Motion motion;
  const char* name;         ///< As on the command line.
  const char* description;  ///< One line with the figures: angles, rates, speeds.
};

/// Every motion that a user may ask for, in the order of Motion. The cook tries motions of its own choice.
[[nodiscard]] std::span<const MotionInfo> all_motions();
[[nodiscard]] std::optional<Motion> find_motion(std::string_view name);
[[nodiscard]] const char* name_of(Motion motion);

/// The pose of the head at `seconds`, world; before 0 as at 0. Position and rotation are continuous, and so is their
/// velocity, except where kTeleport jumps.
[[nodiscard]] HeadPose head_pose(Motion motion, double seconds);

/// A head's pose and how it changes. World axes, metres, radians, seconds.
struct HeadState {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  ///< World from head space, unit.
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();
  Eigen::Vector3d angular_acceleration = Eigen::Vector3d::Zero();
};

/// The same pose at rest.
[[nodiscard]] HeadState standing(const HeadState& moved);

/// Where one smooth piece of a path ends and the next begins.
struct PathBreak {
  double seconds = 0;
  bool jumps = false;  ///< The pose itself is another one; else only its velocity or acceleration.
};

/// How a head moves, exactly, at any time. Between its breaks a path is smooth, so that an integrator that ends its
/// steps there keeps its order.
class HeadPath {
 public:
  HeadPath() = default;
  HeadPath(const HeadPath&) = delete;
  HeadPath& operator=(const HeadPath&) = delete;
  virtual ~HeadPath() = default;

  /// At `seconds`, by the smooth piece that the time `inside` lies in: at a piece's end its own derivatives are meant,
  /// or the next piece's. Times before 0 count as 0.
  [[nodiscard]] virtual HeadState at(double seconds, double inside) const = 0;
  [[nodiscard]] HeadState at(double seconds) const { return at(seconds, seconds); }

  /// Ascending, above 0 and at most `until`.
  [[nodiscard]] virtual std::vector<PathBreak> breaks(double until) const = 0;

  /// What a game would be given at that time.
  [[nodiscard]] HeadPose pose(double seconds) const;
};

[[nodiscard]] std::unique_ptr<HeadPath> path_of(Motion motion);

/// The same movement of a head that looks along -Z: forwards is where its face is.
[[nodiscard]] std::unique_ptr<HeadPath> turned_round(std::unique_ptr<HeadPath> path);

/// Rounded to the precision of the runtime's rotations.
[[nodiscard]] HeadPose pose_of(const HeadState& state);
[[nodiscard]] HeadVelocity velocity_of(const HeadState& state);

/// Turns the head from rest by `radians` about `axis` (unit) within `seconds` (> 0), without a jerk at either end, and
/// holds it there.
[[nodiscard]] std::unique_ptr<HeadPath> held_turn(const Eigen::Vector3d& axis, double radians, double seconds);

/// Seconds in which heads are turned to an attitude, where nothing else is said.
inline constexpr double kAttitudeSeconds = 0.8;

/// Turns the head from rest, by the shortest way, until its up axis points to `up` (of any length but 0), and holds it
/// there. Straight up there is nothing to turn by, and straight down every way is as short: forwards.
[[nodiscard]] std::unique_ptr<HeadPath> held_attitude(const Eigen::Vector3d& up, double seconds = kAttitudeSeconds);

/// A head that is held, and where its up axis points: to a corner, an edge or a face of a cube.
struct HeldAttitude {
  Eigen::Vector3d up;
  std::unique_ptr<HeadPath> path;
};

/// All 26 of them.
[[nodiscard]] std::vector<HeldAttitude> held_attitudes();

/// Where a head is at one time of an animation. World axes.
struct ClipKey {
  double seconds = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();            ///< Metres.
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  ///< World from head space; any length but 0, any sign.
};

/// A head that goes through all keys: position and velocity are continuous, acceleration is between two keys. Between
/// them the path is the cubic Hermite curve with the slopes of the parabola through three keys; rotations take the
/// shortest way, along the same curve of rotation vectors (Kim, Kim and Shin 1995, "A general construction scheme for
/// unit quaternion curves", with a cubic in place of their basis). The head rests before the first key and after the
/// last, so its slopes there are 0: a clip that is cut in full flight starts and stops within one key.
/// Null unless there is a key, all numbers are finite, times ascend by at least kLeastKeySpan and none is before 0.
[[nodiscard]] std::unique_ptr<HeadPath> path_of(std::vector<ClipKey> keys);

/// Seconds. Closer keys would make slopes of rounding errors.
inline constexpr double kLeastKeySpan = 1.0e-4;

/// One moment of an asset's movement.
struct HairPose {
  HeadPose head;
  std::vector<Mat34> palette;  ///< One per bone, head space.
};

/// Runs the runtime at 60 Hz: two seconds at the motion's first pose, so that gravity has sagged the hair, then the
/// motion up to `seconds`. Without a motion (null): the sagged hair under a head at rest. An asset without dynamics
/// keeps its rest shape. `company`, which may be null, is at its first moment while the hair sags.
tl::expected<HairPose, ToolError> simulate_pose(const Asset& asset, const HeadPath* motion, double seconds,
                                                const StepSettings& step, const Solver* solver = &kCoifSolver,
                                                const HairCompany* company = nullptr);

/// The same at several times, ascending.
tl::expected<std::vector<HairPose>, ToolError> simulate_poses(const Asset& asset, const HeadPath* motion,
                                                              std::span<const double> seconds, StepSettings step,
                                                              const Solver* solver = &kCoifSolver,
                                                              const HairCompany* company = nullptr);

/// A turn of the head that stays where it ends, unlike the built-in motions: what the thesis's gallery of motion shows.
struct HeadLook {
  const char* name;     ///< As the page of `coif view` calls it.
  const char* caption;  ///< "looking down"
  Eigen::Vector3d axis;
  double degrees;
  double seconds;
};

[[nodiscard]] std::span<const HeadLook> head_looks();
[[nodiscard]] std::unique_ptr<HeadPath> path_of(const HeadLook& look);

/// A clip to be carried into another program: for each key eight doubles, little-endian, seconds, position x, y, z and
/// rotation x, y, z, w.
[[nodiscard]] std::vector<std::byte> clip_bytes(std::span<const ClipKey> keys);

/// Of what clip_bytes() gave, bit for bit; empty for what is no clip that path_of() takes.
[[nodiscard]] std::vector<ClipKey> clip_keys(std::span<const std::byte> bytes);

}  // namespace coif::motion
