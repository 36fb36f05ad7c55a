#pragma once

#include "cook/recipe/findings.h"
#include "cook/rig/skeleton.h"
#include "cook/strands/hair_strips.h"
#include "platform/stop.h"

#include <cstdint>
#include <span>
#include <vector>

namespace coif::cook {

struct DrawnRecipe;

/// One level of detail: what it draws of each patch, and the bones that move on their own.
struct DetailLevel {
  std::vector<std::vector<std::uint32_t>> triangles_of;  ///< Per patch, three vertices each; empty: it is not drawn.
  float error = 0;                                       ///< As LodRecord::error.
  /// Metres: what of `error` shows, as screen sizes follow from it.
  float shown_error = 0;
  float screen_size = 0;        ///< As LodRecord::screen_size.
  std::vector<bool> simulated;  ///< Per bone.

  [[nodiscard]] std::size_t triangle_count() const;
  [[nodiscard]] std::size_t patch_count() const;
};

/// Of all its triangles, patch by patch.
[[nodiscard]] std::vector<std::uint32_t> indices_of(const DetailLevel& level);
/// Each once, ascending.
[[nodiscard]] std::vector<std::uint32_t> vertices_of(const DetailLevel& level);

struct LodSettings {
  std::uint32_t levels = 3;
  double ratio = 0.5;             ///< Triangles of a level, against the next finer one.
  double max_error = 0.01;        ///< Metres.
  double pixel_error = 1;         ///< Pixels that the error may be on a screen of kScreenLines lines.
  double still_pixels = 24;       ///< Hair that hangs free for less than this on such a screen is rigid.
  platform::Threads threads = 1;  ///< The result does not depend on it.
};

[[nodiscard]] LodSettings lod_settings(const DrawnRecipe& recipe, const platform::Threads& threads);

inline constexpr double kScreenLines = 1080;

/// What the hair's triangles draw from the one with this number on.
[[nodiscard]] DetailLevel level_from(const HairStrips& hair, std::size_t first_triangle);

/// What the hair's own triangles draw, all of them, with all bones.
[[nodiscard]] DetailLevel finest_level(const HairStrips& hair, const Skeleton& skeleton);

/// Screen sizes of all levels, and the bones of the coarser ones, which follow from the largest size each is used at.
///
/// A level fits from that size on at which what shows of the next coarser one's error is `pixel_error` pixels:
/// screen_size = height of the head * pixel_error / (kScreenLines * shown_error of the next level).
void place_on_screen(double head_height, const Skeleton& skeleton, const LodSettings& settings,
                     std::vector<DetailLevel>& levels);

/// Notes what each coarser level has, and what all of them take.
void describe_levels(std::span<const DetailLevel> levels, Findings& findings);

/// Leaves levels out that are too fine or too coarse for every size at which the recipe's scene shows the head. One
/// always stays. The finest that stays simulates every bone and is what errors are measured from: those of the others
/// grow by its own at most, and are given so.
void leave_out_levels(const DrawnRecipe& recipe, std::vector<DetailLevel>& levels, Findings& findings);

}  // namespace coif::cook
