#pragma once

#include "cook/recipe/hair_style.h"
#include "grow/body_field.h"
#include "grow/head_frame.h"
#include "grow/scalp.h"
#include "platform/stop.h"

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <vector>

namespace coif::grow {

/// Strands of as many points each, at even shares of their lengths, root first.
struct StrandPaths {
  std::size_t stations = 0;
  std::vector<Eigen::Vector3f> points;

  [[nodiscard]] std::size_t count() const { return points.size() / stations; }
  [[nodiscard]] std::span<Eigen::Vector3f> strand(std::size_t i) {
    return std::span(points).subspan(i * stations, stations);
  }
  [[nodiscard]] std::span<const Eigen::Vector3f> strand(std::size_t i) const {
    return std::span(points).subspan(i * stations, stations);
  }
};

/// What hair grows on.
struct Ground {
  const cook::HairStyle& style;
  const HeadFrame& head;
  const BodyField& body;
};

inline constexpr float kLeastClearance = 0.002f;  ///< Metres from the skin on a head of usual size, but for roots.

/// How hair falls that nothing shapes but comb and weight: step by step, turned towards the comb's way near the skin,
/// downwards by its weight, kept off the skin and above the hair below it.
[[nodiscard]] StrandPaths grow_open(const Ground& ground, std::span<const Root> roots, std::size_t stations,
                                    const platform::Threads& threads);

/// The same drawn to a tie along the skin, from where it falls as one tail.
[[nodiscard]] StrandPaths grow_tied(const Ground& ground, std::span<const Root> roots, std::size_t stations,
                                    const platform::Threads& threads);

// What both have in common.

/// A strand's tip on its way.
struct Tip {
  Eigen::Vector3f place, way;  ///< `way`: unit.
  float grown = 0;             ///< Metres.
};

/// How far hair of a root keeps from the skin here: all of it on the head, hardly at all on shoulders.
[[nodiscard]] float clearance(const Ground& ground, const Root& root, float lift, const Tip& tip);

/// One step of `length`, turned by `turn` (a vector for each metre), then out of the skin: hard from the least
/// clearance, softly from the wanted one.
void advance(const Ground& ground, const Eigen::Vector3f& turn, float length, float wanted_clearance, Tip& tip);

}  // namespace coif::grow
