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

/// What the page shows beside the picture.
struct ViewNumbers {
  float step_ns_of_bone =
      0;                ///< Nanoseconds that a sub-step of one bone took, mean of the last steps; 0: nothing moved yet.
  float substeps = 0;   ///< Of a step.
  float bones = 0;      ///< Simulated, of one head.
  float triangles = 0;  ///< Of the level that is shown, one head.
  float asset_bytes = 0;
  float drawn = 0;             ///< Frames since the asset was opened.
  float asleep = 0;            ///< All hair rests.
  float levels = 0;            ///< Of detail.
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

  /// Copies the bytes. The error is what the command line says of such a file.
  static tl::expected<LoadedAsset, ToolError> load(std::span<const std::byte> bytes);
};

/// An open asset, one or two heads that wear it, and what the visitor does to them.
class ViewSession {
 public:
  /// `bytes` are taken over. The error is what the command line says of such a file.
  static tl::expected<std::unique_ptr<ViewSession>, ToolError> open(std::vector<std::byte> bytes);

  ViewSession(const ViewSession&) = delete;
  ViewSession& operator=(const ViewSession&) = delete;

  [[nodiscard]] const Asset& asset() const { return asset_; }
  [[nodiscard]] ViewSettings& settings() { return settings_; }
  [[nodiscard]] const ViewNumbers& numbers() const { return numbers_; }

  /// One more motion after motion_words(false), which begins again where it ends; keys as path_of() wants them, or
  /// none.
  void set_clip(std::vector<motion::ClipKey> keys) { clip_ = std::move(keys); }
  /// Another view of the same asset, which has its own settings, heads and time. What the GPU holds is of all of them,
  /// and drawn with by one after the other. Its heads are made when it is first drawn.
  [[nodiscard]] std::unique_ptr<ViewSession> another() const;

  /// Makes what the GPU holds: after open(), and when the browser has given a lost context back.
  tl::expected<void, ToolError> start_drawing();
  /// While the context is lost, which forgets its objects without complaint.
  void stop_drawing() { scene_.reset(); }

  /// The heads go on by `seconds` of wall time. True: something was drawn; false: nothing has changed.
  tl::expected<bool, ToolError> frame(std::uint32_t width, std::uint32_t height, double seconds);

  /// Head and hair to where the motion begins, at rest.
  tl::expected<void, ToolError> restart();
  /// ... and then on to the step nearest to so many seconds into it. Of settings that play.
  tl::expected<void, ToolError> seek(double seconds);
  /// The next frame() draws, though nothing has changed: the canvas was another view's.
  void redraw() { shown_.samples = -1; }

  /// Another asset takes the place of the one that `before` shows: what is set stays, time goes on, and the heads are
  /// where they were, with hair that hangs.
  tl::expected<void, ToolError> go_on(const ViewSession& before);

  [[nodiscard]] TunableMotion& motion() { return motion_; }

  /// Whether a head is there; then it follows drag() and turn() until release(). 0..1 of the canvas, from its top left.
  bool grab(double x, double y);
  void drag(double across, double down);  ///< Of the canvas.
  void turn(double across, double down);  ///< Radians.
  void release() { held_.release(); }

 private:
  /// Of all views of one asset.
  struct Shared {
    LoadedAsset loaded;
    AssetMotion motion;  ///< As the asset came.
    std::unique_ptr<ViewScene> scene;
  };

  explicit ViewSession(std::shared_ptr<Shared> shared);
  /// Writes what is tuned into a copy of the asset, which the heads have from then on: other views have the asset as it
  /// came.
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
  std::vector<float> worn_;  ///< Solvers of the heads, and whether there are gusts.
  std::vector<motion::ClipKey> clip_;
  std::unique_ptr<motion::HeadPath> path_;
  double length_ = 0;    ///< Of a clip, seconds, after which it begins again; 0: `path_` is no clip, or has one key.
  bool is_put_ = false;  ///< In the next step heads are put where they belong: clips begin anywhere.
  float moved_by_ = -1;  ///< The motion that `path_` is.
  float timed_ = -1;     ///< The solver that the cost was measured of.
  HeldHead held_;
  HeadPose pose_;
  double time_ = 0, left_over_ = 0;
  std::uint32_t width_ = 0, height_ = 0;
};

}  // namespace coif::view
