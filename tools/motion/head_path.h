#pragma once
// Features of a character beside a head while its hair is simulated: hands, size and animation.

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
  /// The pose at that time, rotations of all the asset's bones as for Hair::set_pose(). Empty: none.
  std::function<std::vector<Quat>(double seconds)> pose{};
  float pose_weight = 1;  ///< 1: the hair is pulled to the pose, 0: the hair is the pose.
  float scale = 1;        ///< The head's scale.
  Gusts gusts{};          ///< With amplitude 0 there are none.

  /// The description with the solver that it needs; `usual` if it needs no other.
  [[nodiscard]] HairDesc description(const Asset& asset, const Solver* usual) const;
  /// Sets everything for the hair of one head at the end of the coming step.
  [[nodiscard]] Status tell(Hair& hair, double seconds) const;
};

/// A head's built-in movement, defined for every time; starts at rest at the origin (y = 0) at t = 0.
enum class Motion { kStill, kNod, kTurn, kCharge, kRun, kJump, kTumble, kTeleport, kBow, kLie, kJog };

struct MotionInfo {
  Motion motion;
  const char* name;         ///< The name on the command line.
  const char* description;  ///< One line with the figures: angles, rates, speeds.
};

/// Every motion that users can choose, in the order of Motion. The cook has its own choice.
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

/// The end of one smooth piece of a path and the beginning of the next.
struct PathBreak {
  double seconds = 0;
  bool jumps = false;  ///< The pose itself is another one; else only its velocity or acceleration.
};

/// The exact motion of a head at any time. Between its breaks a path is smooth, so that an integrator that ends its
/// steps there keeps its order.
class HeadPath {
 public:
  HeadPath() = default;
  HeadPath(const HeadPath&) = delete;
  HeadPath& operator=(const HeadPath&) = delete;
  virtual ~HeadPath() = default;

  /// The state at `seconds`, from the smooth piece that contains the time `inside`: at a break this chooses the
  /// derivatives of one piece or the next. Times before 0 count as 0.
  [[nodiscard]] virtual HeadState at(double seconds, double inside) const = 0;
  [[nodiscard]] HeadState at(double seconds) const { return at(seconds, seconds); }

  /// Ascending, above 0 and at most `until`.
  [[nodiscard]] virtual std::vector<PathBreak> breaks(double until) const = 0;

  /// The pose that a game would give at that time.
  [[nodiscard]] HeadPose pose(double seconds) const;
};

[[nodiscard]] std::unique_ptr<HeadPath> path_of(Motion motion);

/// The same movement for a head that looks along -Z: forwards is the direction of its face.
[[nodiscard]] std::unique_ptr<HeadPath> turned_round(std::unique_ptr<HeadPath> path);

/// Rounded to the precision of the runtime's rotations.
[[nodiscard]] HeadPose pose_of(const HeadState& state);
[[nodiscard]] HeadVelocity velocity_of(const HeadState& state);

/// Turns the head from rest by `radians` about `axis` (unit) within `seconds` (> 0), without a jerk at either end, and
/// holds it there.
[[nodiscard]] std::unique_ptr<HeadPath> held_turn(const Eigen::Vector3d& axis, double radians, double seconds);

/// Default time for turning heads to an attitude, seconds.
inline constexpr double kAttitudeSeconds = 0.8;

/// Turns the head from rest, by the shortest way, until its up axis points to `up` (of any length but 0), and holds it
/// there. For straight up there is no turn; for straight down, where every way is as short, it turns forwards.
[[nodiscard]] std::unique_ptr<HeadPath> held_attitude(const Eigen::Vector3d& up, double seconds = kAttitudeSeconds);

/// A head that is held, and where its up axis points: to a corner, an edge or a face of a cube.
struct HeldAttitude {
  Eigen::Vector3d up;
  std::unique_ptr<HeadPath> path;
};

/// All 26 attitudes.
[[nodiscard]] std::vector<HeldAttitude> held_attitudes();

/// The pose of a head at one time of an animation. World axes.
struct ClipKey {
  double seconds = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();            ///< Metres.
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  ///< World from head space; any length but 0, any sign.
};

/// A head that goes through all keys. Position and velocity are continuous, and so is acceleration between two keys.
/// Between keys the path is the cubic Hermite curve with the slopes of the parabola through three keys; rotations take
/// the shortest way, along the same curve of rotation vectors (Kim, Kim and Shin 1995, "A general construction scheme
/// for unit quaternion curves", with a cubic in place of their basis). The head rests before the first key and after
/// the last, so its slopes there are 0: a clip that is cut in full motion starts and stops within one key. Null unless
/// there is a key, all numbers are finite, times ascend by at least kLeastKeySpan and none is before 0.
[[nodiscard]] std::unique_ptr<HeadPath> path_of(std::vector<ClipKey> keys);

/// Seconds. Closer keys would make slopes of rounding errors.
inline constexpr double kLeastKeySpan = 1.0e-4;

/// One moment of an asset's motion.
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

/// A turn of the head that stays at its end, unlike the built-in motions; for the motion gallery, as in the thesis.
struct HeadLook {
  const char* name;     ///< The name on the page of `coif view`.
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

/// Decodes the bytes of clip_bytes(), bit for bit; empty for a clip that path_of() refuses.
[[nodiscard]] std::vector<ClipKey> clip_keys(std::span<const std::byte> bytes);

}  // namespace coif::motion
