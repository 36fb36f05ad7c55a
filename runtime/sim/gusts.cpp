// The waves of gusts (coif/air.h), at any place.

#include "lanes/gust_waves.h"
#include "rules.h"
#include "vector_math.h"

#include <cmath>

namespace coif {
namespace {

constexpr double kShorter = 1.6;            ///< Each wave is shorter than the one before by this factor.
constexpr double kWeaker = 0.854987973338;  ///< Each wave is weaker by this factor, the third root of 1 / kShorter.
constexpr double kMostSideways = 0.6, kLeastSideways = 0.1, kMostUp = 0.3;  ///< Radians.
constexpr float kAcross = 0.4f;

/// A random number in 0..1 for each seed, wave and use; after Steele et al. 2014, "Fast Splittable Pseudorandom Number
/// Generators".
double drawn(std::uint32_t seed, std::uint32_t wave, std::uint32_t use) {
  std::uint64_t z = (std::uint64_t{seed} << 16 | wave << 8 | use) * 0x9E37'79B9'7F4A'7C15u + 0x9E37'79B9'7F4A'7C15u;
  z = (z ^ z >> 30) * 0xBF58'476D'1CE4'E5B9u;
  z = (z ^ z >> 27) * 0x94D0'49BB'1331'11EBu;
  return double((z ^ z >> 31) >> 11) * 0x1p-53;
}

struct Axes {
  Vec3 along, side, up;
};

Axes axes_of(const Vec3& direction) {
  // The vector may have any length that a float can have, so it is scaled first.
  const float x = std::fabs(direction.x), y = std::fabs(direction.y), z = std::fabs(direction.z);
  const float side = x > y ? x : y, largest = side > z ? side : z;
  const Vec3 even{direction.x / largest, direction.y / largest, direction.z / largest};
  Axes axes;
  axes.along = even * (1.0f / length(even));
  const Vec3 level = cross(axes.along, {0, 1, 0});
  const float size = length(level);
  axes.side = size > 1e-3f ? level * (1.0f / size) : any_perpendicular(axes.along);
  axes.up = cross(axes.side, axes.along);
  return axes;
}

/// The first wave's share of the sum of all amplitudes.
double first_share() {
  double sum = 0, weight = 1;
  for (std::uint32_t i = 0; i < kGustWaves; ++i, weight *= kWeaker) sum += weight;
  return 1 / sum;
}

}  // namespace

bool are_gusts(const Gusts& gusts) { return check(gusts) == Status::kOk; }

GustWaves waves_of(const Gusts& gusts) {
  const Axes axes = axes_of(gusts.direction);
  GustWaves waves;
  double per_metre = 1 / double(gusts.length), strength = double(gusts.amplitude) * first_share();
  for (std::uint32_t i = 0; i < kGustWaves; ++i, per_metre *= kShorter, strength *= kWeaker) {
    const double sideways = kLeastSideways + (kMostSideways - kLeastSideways) * drawn(gusts.seed, i, 0);
    const plain::SineCosine yaw = plain::sine_cosine((i & 1u) != 0 ? -sideways : sideways);
    const plain::SineCosine pitch = plain::sine_cosine(kMostUp * (2 * drawn(gusts.seed, i, 1) - 1));
    const double along = pitch.cosine * yaw.cosine, side = pitch.cosine * yaw.sine;
    const auto towards = [&](float a, float s, float u) {
      return double(a) * along + double(s) * side + double(u) * pitch.sine;
    };
    const double unit[3] = {towards(axes.along.x, axes.side.x, axes.up.x),
                            towards(axes.along.y, axes.side.y, axes.up.y),
                            towards(axes.along.z, axes.side.z, axes.up.z)};
    for (int axis = 0; axis < 3; ++axis) waves.turns[i][axis] = unit[axis] * per_metre;
    waves.turns_near[i] = {float(waves.turns[i][0]), float(waves.turns[i][1]), float(waves.turns[i][2])};
    // All waves move along `along` at the same speed, so the pattern keeps its shape.
    waves.turns_per_way[i] = along * per_metre;
    waves.begin[i] = drawn(gusts.seed, i, 2);
    const Vec3 air = axes.along + axes.side * (drawn(gusts.seed, i, 3) < 0.5 ? -kAcross : kAcross);
    waves.air[i] = air * (float(strength) / length(air));
  }
  return waves;
}

Status gusts_near(const Gusts& gusts, double way, const double (&place)[3], std::span<const Vec3> offsets,
                  std::span<Vec3> air) {
  if (offsets.size() != air.size()) return Status::kSizeMismatch;
  if (!are_gusts(gusts)) return Status::kBadArgument;
  const GustWaves waves = waves_of(gusts);
  float here[kGustWaves];
  for (std::uint32_t i = 0; i < kGustWaves; ++i) {
    double turns = waves.begin[i] - waves.turns_per_way[i] * way;
    for (int axis = 0; axis < 3; ++axis) turns += waves.turns[i][axis] * place[axis];
    here[i] = part_turn(turns);
  }
  for (std::size_t k = 0; k < offsets.size(); ++k) {
    Vec3 sum;
    for (std::uint32_t i = 0; i < kGustWaves; ++i) {
      const float part = part_turn(double(here[i] + dot(waves.turns_near[i], offsets[k])));
      const float size = std::fabs(part), q = size * (0.5f - size);
      const float sine = ((kGustSine[0] * q + kGustSine[1]) * q + kGustSine[2]) * q;
      sum = sum + waves.air[i] * std::copysign(sine, part);
    }
    air[k] = sum;
  }
  return Status::kOk;
}

Vec3 gust_at(const Gusts& gusts, double way, const double (&place)[3]) {
  const Vec3 there;
  Vec3 air;
  (void)gusts_near(gusts, way, place, {&there, 1}, {&air, 1});
  return air;
}

}  // namespace coif
