#include "base/geometry.h"
#include "base/parallel_for.h"
#include "grow/flow.h"
#include "grow/random.h"
#include "grow/strand_paths.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coif::grow {
namespace {

using Eigen::Matrix3f;
using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr float kTiedStep = 0.003f;  // metres on a head of usual size

/// The tie, and how the tail's middle falls from it.
class Tail {
 public:
  Tail(const Ground& ground, float length) : style_(ground.style), scale_(ground.head.scale()) {
    const auto& gather = *ground.style.grow_gather;
    const Vector3f ray = ground.head.radii.cwiseProduct(direction_at(float(gather[0]), float(gather[1])));
    Vector3f skin = ground.head.center + 1.6f * ray;
    for (int i = 0; i < 32; ++i) skin -= 0.9f * ground.body.distance(skin) * ray.normalized();
    out_ = ground.body.normal(skin);
    tie_ = skin + scale_ * (0.6f * float(style_.grow_tie_radius) + 0.004f) * out_;
    fall(ground, length);
  }

  [[nodiscard]] const Vector3f& tie() const { return tie_; }
  [[nodiscard]] float tie_radius() const { return scale_ * float(style_.grow_tie_radius); }

  /// The place of a strand in the tie's cross section, in tie radii: strands from above are on top.
  [[nodiscard]] Vector2f slot_of(const Root& root, float share) const {
    const Vector3f from = root.place - tie_;
    const Vector3f across = from - from.dot(frames_.front().col(2)) * frames_.front().col(2);
    const Vector2f flat = (frames_.front().leftCols<2>().transpose() * across);
    const float length = flat.norm();
    return length > 0 ? Vector2f(std::sqrt(share) * flat / length) : Vector2f::Zero();
  }

  /// A strand's place `along` metres behind the tie.
  [[nodiscard]] Vector3f place(const Vector2f& slot, float along) const {
    const float at = std::clamp(along / step_, 0.0f, float(middle_.size() - 1) - 1e-3f);
    const auto k = std::size_t(at);
    const float share = at - float(k);
    const Vector3f middle = (1 - share) * middle_[k] + share * middle_[k + 1];
    const Matrix3f frame = (1 - share) * frames_[k] + share * frames_[k + 1];
    return middle + width_at(along) * (frame.leftCols<2>() * slot) + std::max(along - length_, 0.0f) * frame.col(2);
  }

 private:
  [[nodiscard]] float width_at(float along) const {
    const auto tied = float(style_.grow_tie_radius), thick = float(style_.grow_tail_radius);
    const float full = tied + (thick - tied) * ramp(0, 0.11f * scale_, along);
    return scale_ * full * (1 - 0.55f * ramp(0.45f, 1, along / length_));
  }

  void fall(const Ground& ground, float length) {
    length_ = std::max(length, 0.02f * scale_);
    const int steps = std::max(int(std::ceil(length_ / (kTiedStep * scale_))), 2);
    step_ = length_ / float(steps);
    Tip tip{tie_, (out_ + 0.25f * Vector3f::UnitY()).normalized(), 1};
    Matrix3f frame;
    frame.col(2) = tip.way;
    frame.col(0) = Vector3f::UnitY().cross(tip.way).norm() > 0.1f ? Vector3f::UnitY().cross(tip.way).normalized()
                                                                  : tip.way.unitOrthogonal();
    frame.col(1) = tip.way.cross(frame.col(0));
    for (int i = 0; i <= steps; ++i) {
      middle_.push_back(tip.place);
      frames_.push_back(frame);
      const float bends = 1 - 0.7f * float(style_.grow_stiffness);
      const Vector3f turn = -3.2f * bends * float(style_.grow_gravity) * Vector3f::UnitY() / ground.head.mean_radius();
      advance(ground, turn, step_, 0.85f * width_at(step_ * float(i)), tip);
      const Vector3f way = (tip.place - middle_.back()).normalized();
      frame = turn_between(frame.col(2), way).toRotationMatrix() * frame;
    }
  }

  const cook::HairStyle& style_;
  float scale_, step_ = 1, length_ = 0;
  Vector3f tie_, out_;
  std::vector<Vector3f> middle_;
  std::vector<Matrix3f> frames_;  ///< Columns: two across, one along.
};

/// The places of each step from the root along the skin to its slot in the tie.
std::vector<Vector3f> way_to_tie(const Ground& ground, const Root& root, const Vector3f& slot, std::size_t number) {
  const float scale = ground.head.scale(), step = kTiedStep * scale;
  const Dice dice(ground.style.grow_seed, Purpose::kLift);
  const Vector3f normal = ground.body.normal(root.place);
  const float lift = float(ground.style.grow_lift) * kRadians;
  Tip tip{root.place, (slot - root.place).normalized(), 0};
  const Vector3f flat = (tip.way - tip.way.dot(normal) * normal).normalized();
  tip.way = (std::cos(lift) * flat + std::sin(lift) * normal + 0.04f * dice.in_cube(number, 2)).normalized();
  std::vector<Vector3f> places{tip.place};
  const float longest = 5 * ground.head.mean_radius();
  while (tip.grown < longest) {
    const Vector3f to = slot - tip.place;
    if (to.norm() < 1.5f * step) break;
    const Vector3f out = ground.body.normal(tip.place);
    const float near = 1 - ramp(0.015f * scale, 0.05f * scale, to.norm());
    Vector3f way = to - (1 - near) * to.dot(out) * out;
    if (way.norm() < 1e-6f) way = to;
    const float wanted = (1 - near) * clearance(ground, root, 1 + 0.3f * dice.signed_unit(number), tip);
    advance(ground, (way.normalized() - tip.way) * (0.12f + 0.7f * near) / step, step, wanted, tip);
    places.push_back(tip.place);
  }
  places.push_back(slot);
  return places;
}

float length_of(std::span<const Vector3f> line) {
  float length = 0;
  for (std::size_t k = 1; k < line.size(); ++k) length += (line[k] - line[k - 1]).norm();
  return length;
}

}  // namespace

StrandPaths grow_tied(const Ground& ground, std::span<const Root> roots, std::size_t stations,
                      const platform::Threads& threads) {
  float longest = 0;
  for (const Root& root : roots) longest = std::max(longest, root.length);
  const Tail tail(ground, longest);
  const Dice dice(ground.style.grow_seed, Purpose::kTail);
  StrandPaths paths{stations, std::vector<Vector3f>(roots.size() * stations)};
  parallel_for(roots.size(), threads, [&](std::size_t i) {
    const Root& root = roots[i];
    const Vector2f slot = tail.slot_of(root, dice.unit(i));
    const std::vector<Vector3f> way = way_to_tie(ground, root, tail.place(slot, 0), i);
    const float to_tie = length_of(way);
    // A strand that would not reach the tie grows long enough to do so.
    const float length = std::max(root.length, to_tie + 0.25f * root.length);
    const std::span<Vector3f> points = paths.strand(i);
    float before = 0;
    std::size_t next = 1;
    for (std::size_t k = 0; k < stations; ++k) {
      const float wanted = length * float(k) / float(stations - 1);
      if (wanted >= to_tie) {
        points[k] = tail.place(slot, wanted - to_tie);
        continue;
      }
      float piece = (way[next] - way[next - 1]).norm();
      while (next + 1 < way.size() && before + piece < wanted) {
        before += piece;
        ++next;
        piece = (way[next] - way[next - 1]).norm();
      }
      points[k] = way[next - 1] + (piece > 0 ? (wanted - before) / piece : 0.0f) * (way[next] - way[next - 1]);
    }
  });
  return paths;
}

}  // namespace coif::grow
