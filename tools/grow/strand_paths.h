#pragma once

#include "cook/recipe/hair_style.h"
#include "grow/body_field.h"
#include "grow/head_frame.h"
#include "platform/stop.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace coif::grow {

/// The lowest elevation of hair at an azimuth, degrees.
[[nodiscard]] float hairline(const cook::HairStyle& style, float azimuth);

/// Where a strand begins, and what it is like.
struct Root {
  Eigen::Vector3f place;      ///< On the skin.
  Eigen::Vector3f direction;  ///< HeadFrame::direction().
  float length = 0;           ///< Metres.
  float height = 0;           ///< 0 at the hairline, 1 at the top.
  bool is_fringe = false;
};

/// As many as the style asks for, evenly over the scalp but for where it thins out towards the hairline. Fewer, or
/// none, where the hairline leaves no room.
[[nodiscard]] std::vector<Root> spread_roots(const cook::HairStyle& style, const HeadFrame& head, const BodyField& body,
                                             const platform::Threads& threads);

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

/// Which strand each strand's clump is about; a middle is its own.
using ClumpMiddles = std::vector<std::uint32_t>;

/// Clumps `size` metres apart, of strands that begin and fall beside each other: across a parting there is none.
/// `within`, where it is not empty, are larger clumps, that none of these reaches out of.
[[nodiscard]] ClumpMiddles find_clumps(const StrandPaths& paths, float size, std::uint32_t seed,
                                       const ClumpMiddles& within);

/// Draws strands together into clumps and these into smaller ones, waves and curls them, lets them stray, and takes
/// what that pushed into the skin out of it. What each of these is, as grooming tools have it: Yuksel, Schaefer and
/// Keyser 2009, "Hair meshes"; clumps whose strands curl together as in Choe and Ko 2005, "A statistical wisp model and
/// pseudophysical approaches".
void shape_strands(const Ground& ground, StrandPaths& paths, const platform::Threads& threads);

/// How many points of each strand are left below a level cut; all where the style has none. A strand's last point is
/// moved to where it is cut.
[[nodiscard]] std::vector<std::uint32_t> cut_level(const Ground& ground, StrandPaths& paths);

}  // namespace coif::grow
