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
#include <span>
#include <string>
#include <vector>

namespace coif {

/// What the page shows beside the picture.
struct ViewNumbers {
  float step_ns_of_bone =
      0;                ///< Nanoseconds that a sub-step of one bone took, mean of the last steps; 0: nothing moved yet.
  float substeps = 0;   ///< Of a step.
  float bones = 0;      ///< Simulated, of one head.
  float triangles = 0;  ///< Of the level that is shown, one head.
  float asset_bytes = 0;
  float drawn = 0;   ///< Frames since the asset was opened.
  float asleep = 0;  ///< All hair rests.
  float levels = 0;  ///< Of detail.
  float time = 0;    ///< Seconds into the motion.
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

  /// Makes what the GPU holds: after open(), and when the browser has given a lost context back.
  tl::expected<void, ToolError> start_drawing();
  /// While the context is lost, which forgets its objects without complaint.
  void stop_drawing() { scene_.reset(); }

  /// The heads go on by `seconds` of wall time. True: something was drawn; false: nothing has changed.
  tl::expected<bool, ToolError> frame(std::uint32_t width, std::uint32_t height, double seconds);

  /// Head and hair to where the motion begins, at rest.
  tl::expected<void, ToolError> restart();

  /// Another asset takes the place of the one that `before` shows: what is set stays, time goes on, and the heads are where they
  /// were, with hair that hangs.
  tl::expected<void, ToolError> go_on(const ViewSession& before);

  [[nodiscard]] TunableMotion& motion() { return motion_; }

  /// Whether a head is there; then it follows drag() and turn() until release(). 0..1 of the canvas, from its top left.
  bool grab(double x, double y);
  void drag(double across, double down);  ///< Of the canvas.
  void turn(double across, double down);  ///< Radians.
  void release() { held_.release(); }

 private:
  ViewSession() = default;
  tl::expected<void, ToolError> choose_heads();
  void choose_motion();
  [[nodiscard]] StepSettings step_settings() const;
  [[nodiscard]] Gusts gusts() const;
  [[nodiscard]] Vec3 wind() const;
  tl::expected<void, ToolError> step(double seconds);
  [[nodiscard]] bool is_moving() const;

  HairMemory memory_{nullptr, &std::free};
  Asset asset_;
  ViewSettings settings_, shown_;  ///< `shown_`: of the last frame drawn.
  ViewNumbers numbers_;
  TunableMotion motion_;
  std::unique_ptr<ViewScene> scene_;
  std::vector<std::unique_ptr<SimulatedHead>> heads_;
  std::vector<float> worn_;  ///< Solvers of the heads, and whether there are gusts.
  std::unique_ptr<HeadPath> path_;
  float moved_by_ = -1;  ///< The motion that `path_` is.
  float timed_ = -1;     ///< The solver that the cost was measured of.
  HeldHead held_;
  HeadPose pose_;
  double time_ = 0, left_over_ = 0;
  std::uint32_t width_ = 0, height_ = 0;
};

}  // namespace coif
