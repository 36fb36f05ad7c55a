#include "grow/strand_paths.h"

#include "base/geometry.h"
#include "base/parallel_for.h"
#include "grow/random.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace coif::grow {
namespace {

using Eigen::Vector3f;

constexpr float kTurn = 2 * std::numbers::pi_v<float>;
constexpr float kOfParent = 0.36f;  // size of a clump within a clump

/// Moves a strand towards its middle strand, comparing points at equal lengths; beyond its tip the middle continues
/// straight.
void draw_together(std::span<Vector3f> strand, float length, std::span<const Vector3f> middle, float middle_length,
                   float strength, float shape) {
  const std::size_t last = strand.size() - 1;
  const Vector3f between_roots = strand[0] - middle[0];
  for (std::size_t k = 1; k <= last; ++k) {
    const float t = float(k) / float(last);
    const float at = t * length / middle_length * float(last);
    const auto m = std::min(std::size_t(at), last - 1);
    const Vector3f apart = strand[k] - (middle[m] + (at - float(m)) * (middle[m + 1] - middle[m]));
    const float weight = strength * ramp(0, shape, t);
    // A lock is never a thread: a part of the distance between roots stays.
    strand[k] -= weight * (apart - 0.08f * between_roots);
  }
}

/// Frames along a strand that do not twist: the two axes at right angles to it, the first one outwards from the head at
/// its root. Source: Wang, Juettler, Zheng and Liu 2008, "Computation of rotation minimizing frames".
class UntwistedFrames {
 public:
  UntwistedFrames(std::span<const Vector3f> line, const Vector3f& outwards) {
    Vector3f along = (line[1] - line[0]).normalized();
    Vector3f first = outwards - outwards.dot(along) * along;
    first = first.norm() > 1e-3f ? Vector3f(first.normalized()) : along.unitOrthogonal();
    for (std::size_t k = 0; k < line.size(); ++k) {
      const Vector3f next = line[std::min(k + 1, line.size() - 1)] - line[k > 0 ? k - 1 : 0];
      const Vector3f way = next.norm() > 0 ? Vector3f(next.normalized()) : along;
      first = turn_between(along, way) * first;
      first = (first - first.dot(way) * way).normalized();
      along = way;
      first_.push_back(first);
      second_.push_back(along.cross(first));
    }
  }
  [[nodiscard]] const Vector3f& first(std::size_t k) const { return first_[k]; }
  [[nodiscard]] const Vector3f& second(std::size_t k) const { return second_[k]; }

 private:
  std::vector<Vector3f> first_, second_;
};

class Shaper {
 public:
  Shaper(const Ground& ground, std::span<const Root> roots, StrandPaths& paths, const platform::Threads& threads)
      : ground_(ground),
        style_(ground.style),
        roots_(roots),
        paths_(paths),
        threads_(threads),
        scale_(ground.head.scale()) {
    for (std::size_t i = 0; i < paths.count(); ++i) {
      float length = 0;
      const auto strand = paths.strand(i);
      for (std::size_t k = 1; k < strand.size(); ++k) length += (strand[k] - strand[k - 1]).norm();
      lengths_.push_back(std::max(length, 1e-6f));
    }
  }

  void run() {
    const float size = scale_ * float(style_.grow_clump_size);
    const ClumpMiddles clumps = find_clumps(paths_, roots_, size, style_.grow_seed, {});
    const ClumpMiddles children = find_clumps(paths_, roots_, kOfParent * size, style_.grow_seed + 1, clumps);
    gather(children, float(style_.grow_clump_children), 0.7f);
    gather(clumps, float(style_.grow_clump), float(style_.grow_clump_shape));
    parallel_for(paths_.count(), threads_, [&](std::size_t i) {
      wander(i, clumps[i], size);
      bend(i, clumps[i], children[i]);
      stray(i);
      keep_out(i);
    });
  }

 private:
  [[nodiscard]] bool flies_away(std::size_t i) const {
    return !roots_[i].is_wisp && Dice(style_.grow_seed, Purpose::kFlyaway).unit(i) < float(style_.grow_flyaways);
  }

  /// Into each clump; strands differ in how closely they keep to it.
  void gather(const ClumpMiddles& middles, float strength, float shape) {
    if (strength == 0) return;
    const Dice dice(style_.grow_seed, Purpose::kClump);
    const StrandPaths before = paths_;
    parallel_for(paths_.count(), threads_, [&](std::size_t i) {
      const std::uint32_t middle = middles[i];
      if (middle == i || flies_away(i)) return;
      const float loose = roots_[i].is_fringe ? 0.6f : 1.0f;  // One sees the forehead between locks.
      const float of_clump = 1 - 0.25f * dice.unit(middle, 7), of_strand = 1 - 0.3f * dice.unit(i, 8) * dice.unit(i, 9);
      draw_together(paths_.strand(i), lengths_[i], before.strand(middle), lengths_[middle],
                    loose * strength * std::min(of_clump * of_strand * 1.1f, 1.0f), shape);
    });
  }

  /// Locks do not hang in parallel: each strays a little, with all of its strands.
  void wander(std::size_t i, std::uint32_t clump, float size) {
    constexpr float kPeriod = 0.11f, kShare = 0.4f;
    if (flies_away(i) || roots_[i].is_wisp) return;
    const Dice dice(style_.grow_seed, Purpose::kWander);
    const auto strand = paths_.strand(i);
    const float height = kShare * size * float(style_.grow_clump), period = scale_ * kPeriod;
    const Vector3f begin = dice.smooth(clump, 0);
    for (std::size_t k = 1; k < strand.size(); ++k) {
      const float t = float(k) / float(strand.size() - 1), at = t * lengths_[i] / period;
      strand[k] += height * ramp(0, 2, at) * (dice.smooth(clump, at) - begin);
    }
  }

  /// Adds waves and curls about the strand's own course.
  void bend(std::size_t i, std::uint32_t clump, std::uint32_t child) {
    const float curl = scale_ * float(style_.grow_curl_radius), wave = scale_ * float(style_.grow_wave_height);
    if (curl == 0 && wave == 0) return;
    const Dice curls(style_.grow_seed, Purpose::kCurl), waves(style_.grow_seed, Purpose::kWave);
    const auto random = float(style_.grow_curl_random);
    const auto mixed = [&](const Dice& dice, std::uint64_t k) {
      return dice.unit(clump, k) + 0.5f * random * dice.signed_unit(child, k) + 0.5f * random * dice.signed_unit(i, k);
    };
    const float phase = kTurn * mixed(curls, 0), turns = curls.unit(clump, 1) < 0.5f ? -1.0f : 1.0f;
    const float pitch = scale_ * float(style_.grow_curl_pitch) *
                        (1 + 0.25f * curls.signed_unit(clump, 2) + 0.2f * random * curls.signed_unit(i, 2));
    const float radius = curl * (1 + 0.2f * curls.signed_unit(clump, 3) + 0.5f * random * curls.signed_unit(i, 3));
    const float wave_phase = kTurn * mixed(waves, 0), wave_side = 0.9f * waves.signed_unit(clump, 3);
    const float wave_length = scale_ * float(style_.grow_wave_length) * (1 + 0.15f * waves.signed_unit(clump, 2));
    const auto strand = paths_.strand(i);
    const UntwistedFrames frames(strand, ground_.head.direction(strand[0]));
    const auto start = float(style_.grow_curl_start);
    const std::size_t last = strand.size() - 1;
    for (std::size_t k = 1; k <= last; ++k) {
      const float t = float(k) / float(last), at = t * lengths_[i];
      const float curled = ramp(0, std::max(start, 0.02f), t) * radius, angle = phase + turns * kTurn * at / pitch;
      const float waved = ramp(0, 0.5f, t) * (0.4f + 0.6f * t) * roots_[i].grown_share * wave,
                  wave_angle = wave_phase + kTurn * at / wave_length;
      strand[k] += curled * (std::cos(angle) * frames.first(k) + std::sin(angle) * frames.second(k));
      // Flat, half as deep as wide, with another orientation for each lock, so that some show their waves to every
      // side.
      const Vector3f across = std::cos(wave_side) * frames.second(k) + std::sin(wave_side) * frames.first(k);
      const Vector3f deep = std::cos(wave_side) * frames.first(k) - std::sin(wave_side) * frames.second(k);
      strand[k] += waved * (std::sin(wave_angle) * across + 0.5f * std::cos(wave_angle) * deep);
    }
  }

  void stray(std::size_t i) {
    const Dice frizz(style_.grow_seed, Purpose::kFrizz);
    const bool flies = flies_away(i);
    const float height = scale_ * (float(style_.grow_frizz) * (0.4f + 1.2f * frizz.unit(i, 1u << 30)) +
                                   (flies ? float(style_.grow_flyaway_reach) : 0.0f));
    if (height == 0) return;
    const float length = scale_ * float(style_.grow_frizz_length) * (flies ? 2.5f : 1.0f);
    const auto strand = paths_.strand(i);
    const Vector3f outwards = flies ? Vector3f(0.6f * ground_.head.direction(strand[0])) : Vector3f::Zero();
    const Vector3f begin = frizz.smooth(i, 0);
    for (std::size_t k = 1; k < strand.size(); ++k) {
      const float t = float(k) / float(strand.size() - 1);
      strand[k] += height * ramp(-0.15f, 0.9f, t) * t * (frizz.smooth(i, t * lengths_[i] / length) - begin + outwards);
    }
  }

  /// Treats the points, and the middles between them.
  void keep_out(std::size_t i) {
    constexpr int kRounds = 6;
    const auto strand = paths_.strand(i);
    const float least = scale_ * kLeastClearance;
    for (int round = 0; round < kRounds; ++round) {
      bool is_out = true;
      float grown = 0;
      for (std::size_t k = 1; k < strand.size(); ++k) {
        grown += (strand[k] - strand[k - 1]).norm();
        strand[k] = ground_.body.kept_off(strand[k], std::min(least, 0.5f * grown));
        const Vector3f middle = 0.5f * (strand[k - 1] + strand[k]);
        const float away = ground_.body.distance(middle);
        if (k == 1 || away >= 0.8f * least) continue;
        const Vector3f out = (least - away) * ground_.body.normal(middle);
        if (k > 2) strand[k - 1] += out;
        strand[k] += out;
        is_out = false;
      }
      if (is_out) break;
    }
  }

  const Ground& ground_;
  const cook::HairStyle& style_;
  std::span<const Root> roots_;
  StrandPaths& paths_;
  platform::Threads threads_;
  float scale_;
  std::vector<float> lengths_;
};

}  // namespace

void shape_strands(const Ground& ground, std::span<const Root> roots, StrandPaths& paths,
                   const platform::Threads& threads) {
  Shaper(ground, roots, paths, threads).run();
}

std::vector<std::uint32_t> cut_level(const Ground& ground, StrandPaths& paths) {
  std::vector<std::uint32_t> sizes(paths.count(), std::uint32_t(paths.stations));
  if (!ground.style.grow_cut) return sizes;
  const Dice dice(ground.style.grow_seed, Purpose::kLength);
  const float level = ground.head.center.y() + float(*ground.style.grow_cut) * ground.head.radii.y();
  for (std::size_t i = 0; i < paths.count(); ++i) {
    const auto strand = paths.strand(i);
    const float height =
        level + 0.25f * float(ground.style.grow_length_random) * ground.head.radii.y() * dice.signed_unit(i, 3);
    for (std::size_t k = 1; k < strand.size(); ++k) {
      if (strand[k].y() >= height || strand[k - 1].y() < height) continue;
      const float share = (strand[k - 1].y() - height) / (strand[k - 1].y() - strand[k].y());
      strand[k] = strand[k - 1] + std::max(share, 0.02f) * (strand[k] - strand[k - 1]);
      sizes[i] = std::uint32_t(k + 1);
      break;
    }
  }
  return sizes;
}

}  // namespace coif::grow
