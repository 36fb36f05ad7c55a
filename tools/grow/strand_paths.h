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

/// The lowest elevation of hair at an azimuth, degrees: one smooth line over forehead, temples, sideburns, around the
/// ears and along the nape.
[[nodiscard]] float hairline(const cook::HairStyle& style, float azimuth);

/// The beginning of a strand, and its properties.
struct Root {
  Eigen::Vector3f place;      ///< On the skin.
  Eigen::Vector3f direction;  ///< HeadFrame::direction().
  float length = 0;           ///< Metres.
  float height = 0;           ///< 0 at the hairline, 1 at the top.
  float width = 1;            ///< Share of the usual width.
  float grown_share = 1;      ///< Its length, as a share of what hair is away from the hairline.
  bool is_fringe = false;
  bool is_wisp = false;  ///< Short hair at the hairline, which belongs to no clump.
};

/// As many roots as the style wants, evenly over the scalp, thinner towards the hairline. Fewer or none where the
/// hairline leaves no room.
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

/// The body that hair grows on, with its field and its frame.
struct Ground {
  const cook::HairStyle& style;
  const HeadFrame& head;
  const BodyField& body;
};

inline constexpr float kLeastClearance = 0.002f;  ///< Metres from the skin on a head of usual size, except at roots.

/// The course of hair that only comb and weight shape: step by step it is turned towards the comb's direction near the
/// skin and downwards by its weight, and kept off the skin and above the hair below it.
[[nodiscard]] StrandPaths grow_open(const Ground& ground, std::span<const Root> roots, std::size_t stations,
                                    const platform::Threads& threads);

/// The same for hair that is drawn to a tie along the skin, and falls from there as one tail.
[[nodiscard]] StrandPaths grow_tied(const Ground& ground, std::span<const Root> roots, std::size_t stations,
                                    const platform::Threads& threads);

// Shared by both.

/// A strand's tip on its way.
struct Tip {
  Eigen::Vector3f place, way;  ///< `way`: unit.
  float grown = 0;             ///< Metres.
};

/// Distance that the hair of a root keeps from the skin here: the full one on the head, hardly any on shoulders.
[[nodiscard]] float clearance(const Ground& ground, const Root& root, float lift, const Tip& tip);

/// One step of `length`, turned by `turn` (a vector per metre), then moved out of the skin: completely to the least
/// clearance, gradually to the wanted one.
void advance(const Ground& ground, const Eigen::Vector3f& turn, float length, float wanted_clearance, Tip& tip);

/// For each strand the strand in the middle of its clump; a middle has itself.
using ClumpMiddles = std::vector<std::uint32_t>;

/// Finds clumps `size` metres apart, of strands that begin and fall beside each other; none crosses a parting. A wisp
/// is a clump of its own. `within`, if not empty, are larger clumps; no clump crosses their borders.
[[nodiscard]] ClumpMiddles find_clumps(const StrandPaths& paths, std::span<const Root> roots, float size,
                                       std::uint32_t seed, const ClumpMiddles& within);

/// Draws strands together into clumps and these into smaller ones, waves and curls them, lets them stray, and moves
/// parts that end inside the skin out of it. The terms are those of grooming tools: Yuksel, Schaefer and Keyser 2009,
/// "Hair meshes"; clumps whose strands curl together as in Choe and Ko 2005, "A statistical wisp model and
/// pseudophysical approaches".
void shape_strands(const Ground& ground, std::span<const Root> roots, StrandPaths& paths,
                   const platform::Threads& threads);

/// Number of points of each strand that remain below a level cut; all where the style has none. A strand's last point
/// is moved to the cut.
[[nodiscard]] std::vector<std::uint32_t> cut_level(const Ground& ground, StrandPaths& paths);

}  // namespace coif::grow
