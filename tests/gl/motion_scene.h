#pragma once

#include "gl/gl_test.h"

#include <coif/motion_vectors.h>

#include <array>
#include <vector>

namespace coif {

/// One frame of a moving head under a moving camera.
struct Frame {
  HeadPose head;
  std::vector<Mat34> palette;
  std::array<float, 16> clip{};
  Vec3 eye;
};

/// Perspective, looking along -Z.
void look_from(Frame& frame, const Vec3& eye);

/// A head with every chain lifted by an angle of its own, seen from a metre in front.
[[nodiscard]] Frame frame_of(const Asset& asset, float lift, float yaw);

[[nodiscard]] MotionDesc desc_of(const Frame& now, const Frame& before);

/// A target of two floats for each pixel, with depth.
class MotionScene : public CountedGlTest {
 protected:
  using Vector = std::array<float, 2>;
  static constexpr int kSide = 64;  // pixels each way
  static constexpr float kUntouched = -9;
  static constexpr std::size_t kMiddle = kSide * kSide / 2 + kSide / 2;

  void SetUp() override;

  static void clear_vectors();
  [[nodiscard]] static std::vector<Vector> read_vectors();

  /// Uploads and draws; both must succeed. `asked`: instead of what the frames say.
  std::vector<Vector> vectors(const Asset& asset, const Frame& now, const Frame& before,
                              const MotionDesc* asked = nullptr);
};

}  // namespace coif
