#include "cards/ribbon.h"

#include "base/geometry.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace coif::cards {
namespace {

constexpr std::size_t kStations = Ribbon::kStations;
constexpr float kShortest = 1e-9f;    // metres
constexpr float kUsualStray = 0.04f;  // Share of a card's strands that may lie beside it.
constexpr int kTurns = 24;            // How often neighbours share how they spread across: over some five stations.
constexpr float kMovesOver = 0.06f;   // Share of the way to the strands' mean, from station to station.

Eigen::Vector3f any_right_angle(const Eigen::Vector3f& v) {
  const Eigen::Vector3f axis = std::abs(v.x()) < 0.7f ? Eigen::Vector3f::UnitX() : Eigen::Vector3f::UnitY();
  return v.cross(axis).normalized();
}

/// From station to station the middle line goes on as far as strands do. Where one ends, the mean of the others lies
/// elsewhere, perhaps behind: the line moves over to it slowly, or wide edges would cross, and never back.
void set_middle(const StrandsAt& strands, Ribbon& ribbon) {
  for (std::size_t k = 0; k < kStations; ++k) {
    Eigen::Vector3f mean = Eigen::Vector3f::Zero(), step = Eigen::Vector3f::Zero();
    float weights = 0;
    strands.for_each_step(k == 0 ? 0 : k - 1, k,
                          [&](const Eigen::Vector3f& before, const Eigen::Vector3f& point, float weight) {
                            mean += weight * point;
                            step += weight * (point - before);
                            weights += weight;
                          });
    mean /= weights;
    if (k > 0 && step.norm() > weights * kShortest) {
      const Eigen::Vector3f reached = ribbon.middle[k - 1] + step / weights, way = step.normalized();
      const Eigen::Vector3f off = mean - reached;
      mean = reached + kMovesOver * (off - way.dot(off) * way);
    }
    ribbon.middle[k] = mean;
  }
  for (std::size_t k = 0; k < kStations; ++k) {
    const Eigen::Vector3f way = ribbon.middle[std::min(k + 1, kStations - 1)] - ribbon.middle[k == 0 ? 0 : k - 1];
    ribbon.along[k] = way.norm() > kShortest ? way.normalized()
                      : k > 0                ? ribbon.along[k - 1]
                                             : Eigen::Vector3f::UnitY().eval();
  }
}

/// Directions in a plane with the axes x and y, by doubled angles, so that both senses count the same: (cos 2a, sin 2a)
/// times the strength.
struct Spread {
  float x = 0, y = 0;
};

/// Frames that do not twist along the middle line: across directions are angles in them.
std::array<Eigen::Vector3f, kStations> untwisted(const Ribbon& ribbon) {
  std::array<Eigen::Vector3f, kStations> side;
  side[0] = any_right_angle(ribbon.along[0]);
  for (std::size_t k = 1; k < kStations; ++k) {
    const Eigen::Vector3f carried = turn_between(ribbon.along[k - 1], ribbon.along[k]) * side[k - 1];
    side[k] = (carried - carried.dot(ribbon.along[k]) * ribbon.along[k]).normalized();
  }
  return side;
}

void set_across(const StrandsAt& strands, Ribbon& ribbon) {
  const auto side = untwisted(ribbon);
  std::array<Spread, kStations> spread{};
  for (std::size_t k = 0; k < kStations; ++k) {
    const Eigen::Vector3f up = ribbon.along[k].cross(side[k]);
    strands.for_each(k, [&](const Eigen::Vector3f& point, float weight) {
      const Eigen::Vector3f off = point - ribbon.middle[k];
      const float x = off.dot(side[k]), y = off.dot(up);
      spread[k].x += weight * (x * x - y * y);
      spread[k].y += weight * 2 * x * y;
    });
  }
  // A card turns slowly: each station has a share of its neighbours' direction, which also replaces its own where
  // strands run together.
  for (int pass = 0; pass < kTurns; ++pass) {
    const auto before = spread;
    for (std::size_t k = 0; k < kStations; ++k) {
      const Spread &a = before[k == 0 ? 0 : k - 1], &b = before[std::min(k + 1, kStations - 1)];
      spread[k] = {0.5f * before[k].x + 0.25f * (a.x + b.x), 0.5f * before[k].y + 0.25f * (a.y + b.y)};
    }
  }
  for (std::size_t k = 0; k < kStations; ++k) {
    const float angle = 0.5f * std::atan2(spread[k].y, spread[k].x);
    ribbon.across[k] = std::cos(angle) * side[k] + std::sin(angle) * ribbon.along[k].cross(side[k]);
    if (k > 0 && ribbon.across[k].dot(turn_between(ribbon.along[k - 1], ribbon.along[k]) * ribbon.across[k - 1]) < 0) {
      ribbon.across[k] = -ribbon.across[k];
    }
  }
}

void set_widths(const StrandsAt& strands, float width, float stray, Ribbon& ribbon) {
  std::vector<float> beside, before;
  for (std::size_t k = 0; k < kStations; ++k) {
    const Eigen::Vector3f normal = ribbon.along[k].cross(ribbon.across[k]);
    beside.clear();
    before.clear();
    strands.for_each(k, [&](const Eigen::Vector3f& point, float) {
      const Eigen::Vector3f off = point - ribbon.middle[k];
      beside.push_back(std::abs(off.dot(ribbon.across[k])));
      before.push_back(std::abs(off.dot(normal)));
    });
    ribbon.half_width[k] = quantile(beside, 1 - stray) + 0.5f * width;
    ribbon.half_depth[k] = quantile(before, 1 - stray);
  }
}

}  // namespace

Ribbon ribbon_of(const EvenStrands& strands, std::span<const std::uint32_t> members, float stray, float arc) {
  Ribbon ribbon;
  ribbon.arc = arc;
  const StrandsAt there(strands, members, arc);
  set_middle(there, ribbon);
  set_across(there, ribbon);
  set_widths(there, strands.width, stray, ribbon);
  return ribbon;
}

Ribbon card_ribbon_of(const EvenStrands& strands, std::span<const std::uint32_t> members) {
  float longest = 0;
  for (const std::uint32_t i : members) longest = std::max(longest, strands.lengths[i]);
  Ribbon ribbon = ribbon_of(strands, members, kUsualStray, longest);
  for (const std::size_t end : {std::size_t{0}, kStations - 1}) {
    const Eigen::Vector3f outwards = end == 0 ? (-ribbon.along[end]).eval() : ribbon.along[end];
    float farthest = 0;
    for (const std::uint32_t i : members) {
      farthest = std::max(farthest, (strands.strand(i)[end] - ribbon.middle[end]).dot(outwards));
    }
    ribbon.middle[end] += farthest * outwards;
  }
  for (std::size_t k = 0; k < kStations; ++k) ribbon.half_width[k] += ribbon.half_depth[k];
  return ribbon;
}

bool faces_inwards(const Ribbon& ribbon, const Eigen::Vector3f& middle) {
  float outwards = 0;
  for (std::size_t k = 0; k < kStations; ++k) {
    outwards += ribbon.along[k].cross(ribbon.across[k]).dot(ribbon.middle[k] - middle);
  }
  return outwards < 0;
}

float length_of(const Ribbon& ribbon) {
  float length = 0;
  for (std::size_t k = 1; k < kStations; ++k) length += (ribbon.middle[k] - ribbon.middle[k - 1]).norm();
  return length;
}

float distance_to(const Ribbon& ribbon, std::span<const Eigen::Vector3f> strand, float limit, float beside) {
  // Every second station, from the ends inwards, where strands of different shapes are farthest apart.
  static_assert(kStations == 32);
  constexpr std::size_t kOrder[] = {31, 0, 16, 8, 24, 4, 20, 12, 28, 2, 18, 10, 26, 6, 22, 14};
  const float most = limit * float(std::size(kOrder));
  float sum = 0;
  for (const std::size_t k : kOrder) {
    const Eigen::Vector3f off = strand[k] - ribbon.middle[k];
    const float sideways = off.dot(ribbon.across[k]);
    sum += std::max(off.squaredNorm() - (1 - beside) * sideways * sideways, 0.0f);
    if (sum >= most) break;
  }
  return sum / float(std::size(kOrder));
}

}  // namespace coif::cards
