#pragma once

#include "motion/head_path.h"
#include "view/page/held_head.h"
#include "view/page/simulated_head.h"
#include "view/page/tunable_motion.h"
#include "view/page/view_scene.h"
#include "view/page/view_settings.h"

#include <coif/asset.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace coif::view {

/// The numbers that the page shows beside the picture.
struct ViewNumbers {
  /// Nanoseconds that a sub-step of one bone took, mean of the last steps; 0: nothing moved yet.
  float step_ns_of_bone = 0;
  float substeps = 0;   ///< Per step.
  float bones = 0;      ///< Simulated, of one head.
  float triangles = 0;  ///< Triangles of the shown level, one head.
  float asset_bytes = 0;
  float drawn = 0;             ///< Frames since the asset was opened.
  float asleep = 0;            ///< 1 if all hair is at rest.
  float levels = 0;            ///< Number of levels of detail.
  float time = 0;              ///< Seconds into the motion.
  float tip_error_source = 0;  ///< TipErrorSource of these two, shares of the chain's length.
  float tip_rms = 0, tip_max = 0;
  float head_position[3] = {};  ///< World, metres: where the first head's motion has it.
  float head_rotation[4] = {};  ///< Unit quaternion (x, y, z, w).
};

/// An asset and the bytes that it is open in.
struct LoadedAsset {
  HairMemory memory{nullptr, &std::free};
  std::size_t bytes = 0;
  Asset asset;

  /// Copies the bytes. The error is the command line's for such a file.
  static tl::expected<LoadedAsset, ToolError> load(std::span<const std::byte> bytes);
};

/// An open asset, one or two heads that wear it, and the visitor's actions on them.
class ViewSession {
 public:
  /// Takes over `bytes`. The error is the command line's for such a file.
  static tl::expected<std::unique_ptr<ViewSession>, ToolError> open(std::vector<std::byte> bytes);

  ViewSession(const ViewSession&) = delete;
  ViewSession& operator=(const ViewSession&) = delete;

  [[nodiscard]] const Asset& asset() const { return asset_; }
  [[nodiscard]] ViewSettings& settings() { return settings_; }
  [[nodiscard]] const ViewNumbers& numbers() const { return numbers_; }

  /// Sets one more motion after motion_words(false), which repeats; keys as for path_of(), or none.
  void set_clip(std::vector<motion::ClipKey> keys) { clip_ = std::move(keys); }
  /// Sets what is beneath the hair in place of the asset's colliders; null: nothing. Before start_drawing().
  void set_body(std::shared_ptr<const PageBody> body) { shared_->body = std::move(body); }
  /// Another view of the same asset, with its own settings, heads and time. All views share the GPU objects and are
  /// drawn one after the other. Its heads are made when it is first drawn.
  [[nodiscard]] std::unique_ptr<ViewSession> another() const;

  /// Makes the GPU objects: after open(), and when the browser has restored a lost context.
  tl::expected<void, ToolError> start_drawing();
  /// While the context is lost, which forgets its objects without complaint.
  void stop_drawing() { scene_.reset(); }

  /// Moves the heads on by `seconds` of wall time. True: something was drawn; false: nothing has changed.
  tl::expected<bool, ToolError> frame(std::uint32_t width, std::uint32_t height, double seconds);

  /// Head and hair to where the motion begins, at rest.
  tl::expected<void, ToolError> restart();
  /// Moves on to the step nearest to this many seconds. For settings that play.
  tl::expected<void, ToolError> seek(double seconds);
  /// The next frame() draws, though nothing has changed: the canvas was another view's.
  void redraw() { shown_.samples = -1; }

  /// Replaces the asset that `before` shows: settings stay, time goes on, and the heads are where they were, with hair
  /// that hangs.
  tl::expected<void, ToolError> go_on(const ViewSession& before);

  [[nodiscard]] TunableMotion& motion() { return motion_; }

  /// Whether a head is there; then it follows drag() and turn() until release(). 0..1 of the canvas, from its top left.
  bool grab(double x, double y);
  void drag(double across, double down);  ///< In shares of the canvas.
  void turn(double across, double down);  ///< Radians.
  void release() { held_.release(); }

 private:
  /// Shared by all views of one asset.
  struct Shared {
    LoadedAsset loaded;
    AssetMotion motion;  ///< The motion of the asset as it was opened.
    std::shared_ptr<const PageBody> body;
    std::unique_ptr<ViewScene> scene;
  };

  explicit ViewSession(std::shared_ptr<Shared> shared);
  /// Writes the tuned values into a copy of the asset, which the heads use from then on; other views keep the asset as
  /// it was opened.
  tl::expected<void, ToolError> tune();
  [[nodiscard]] const Asset& simulated_asset() const { return tuned_ ? tuned_->asset : asset_; }
  tl::expected<void, ToolError> choose_heads();
  void choose_motion();
  [[nodiscard]] double time_in_motion() const;
  [[nodiscard]] HeadPose pose_in_motion() const;
  [[nodiscard]] StepSettings step_settings() const;
  [[nodiscard]] Gusts gusts() const;
  [[nodiscard]] Vec3 wind() const;
  tl::expected<void, ToolError> step(double seconds);
  [[nodiscard]] bool is_moving() const;
  void tell_numbers(std::uint32_t level);

  std::shared_ptr<Shared> shared_;
  const Asset& asset_;
  std::unique_ptr<ViewScene>& scene_;
  ViewSettings settings_, shown_;  ///< `shown_`: of the last frame drawn.
  ViewNumbers numbers_;
  TunableMotion motion_;
  std::optional<LoadedAsset> tuned_;
  bool measures_cost_ = true;
  std::vector<std::unique_ptr<SimulatedHead>> heads_;
  std::vector<float> worn_;  ///< The heads' solvers, and whether there are gusts.
  std::vector<motion::ClipKey> clip_;
  std::unique_ptr<motion::HeadPath> path_;
  /// Length of a clip, seconds, after which it repeats; 0: `path_` is not a clip, or has one key.
  double length_ = 0;
  bool is_put_ = false;  ///< The next step puts the heads at their poses: clips may begin anywhere.
  float moved_by_ = -1;  ///< The motion that `path_` is.
  float timed_ = -1;     ///< The solver that the cost was measured of.
  HeldHead held_;
  HeadPose pose_;
  double time_ = 0, left_over_ = 0;
  std::uint32_t width_ = 0, height_ = 0;
};

}  // namespace coif::view
