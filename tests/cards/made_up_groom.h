#pragma once

// Grooms that tests make up.

#include "groom/groom.h"

#include <Eigen/Core>

#include <cmath>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace coif::cards::test {

inline groom::Groom groom_of(const std::vector<std::vector<Eigen::Vector3f>>& strands) {
  groom::Groom groom;
  groom.root_first = true;
  groom::GroomBuilder builder(groom);
  for (const auto& strand : strands) builder.add(strand);
  const std::string fault = builder.finish();
  if (!fault.empty()) groom.warnings.emplace_back("S223", fault);
  return groom;
}

/// Straight down from a place, `points` of them.
inline std::vector<Eigen::Vector3f> hanging(const Eigen::Vector3f& root, float length, std::size_t points = 9) {
  std::vector<Eigen::Vector3f> strand;
  for (std::size_t k = 0; k < points; ++k)
    strand.emplace_back(root - Eigen::Vector3f(0, length * float(k) / float(points - 1), 0));
  return strand;
}

/// Wisps of `each` strands that hang from places far from each other, flat: 2 cm wide along X, 1 mm deep.
inline groom::Groom hanging_wisps(std::size_t wisps, std::size_t each) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(-1, 1);
  std::vector<std::vector<Eigen::Vector3f>> strands;
  for (std::size_t w = 0; w < wisps; ++w) {
    const Eigen::Vector3f middle(0.1f * float(w), 0, 0.1f * float(w % 3));
    for (std::size_t i = 0; i < each; ++i) {
      strands.push_back(hanging(middle + Eigen::Vector3f(0.01f * unit(random), 0, 0.0005f * unit(random)), 0.3f));
    }
  }
  return groom_of(strands);
}

/// Strands that go out from a sphere of 0.1 m about the origin, above its middle, and fall.
inline std::vector<std::vector<Eigen::Vector3f>> strands_of_a_head(std::size_t count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> unit(0, 1);
  std::vector<std::vector<Eigen::Vector3f>> strands;
  for (std::size_t i = 0; i < count; ++i) {
    const float y = unit(random), around = 6.2831853f * unit(random), r = std::sqrt(1 - y * y);
    const Eigen::Vector3f out(r * std::cos(around), y, r * std::sin(around));
    const float length = 0.1f + 0.2f * unit(random);
    std::vector<Eigen::Vector3f> strand;
    for (int k = 0; k < 12; ++k) {
      const float t = float(k) / 11 * length;
      strand.emplace_back(0.1f * out + t * out - Eigen::Vector3f(0, 3 * t * t, 0));
    }
    strands.push_back(strand);
  }
  return strands;
}

}  // namespace coif::cards::test
