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

/// One level of detail: the triangles that it draws of each patch, and the bones that it simulates.
struct DetailLevel {
  std::vector<std::vector<std::uint32_t>> triangles_of;  ///< Per patch, three vertices each; empty: it is not drawn.
  float error = 0;                                       ///< As LodRecord::error.
  /// Metres: the visible part of `error`, from which screen sizes follow.
  float shown_error = 0;
  float screen_size = 0;        ///< As LodRecord::screen_size.
  std::vector<bool> simulated;  ///< Per bone.

  [[nodiscard]] std::size_t triangle_count() const;
  [[nodiscard]] std::size_t patch_count() const;
};

/// The indices of all its triangles, patch by patch.
[[nodiscard]] std::vector<std::uint32_t> indices_of(const DetailLevel& level);
/// Its vertices, each once, ascending.
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

/// The level of the hair's triangles from this number on.
[[nodiscard]] DetailLevel level_from(const HairStrips& hair, std::size_t first_triangle);

/// The level of all the hair's own triangles, with all bones.
[[nodiscard]] DetailLevel finest_level(const HairStrips& hair, const Skeleton& skeleton);

/// Sets the screen sizes of all levels, and the bones of the coarser ones, which follow from the largest size at which
/// each is used.
///
/// A level fits from the size on at which the shown error of the next coarser one is `pixel_error` pixels: screen_size
/// = height of the head * pixel_error / (kScreenLines * shown_error of the next level).
void place_on_screen(double head_height, const Skeleton& skeleton, const LodSettings& settings,
                     std::vector<DetailLevel>& levels);

/// Notes the contents of each coarser level, and the size of all of them.
void describe_levels(std::span<const DetailLevel> levels, Findings& findings);

/// Leaves out levels that are too fine or too coarse for every size at which the recipe's scene shows the head. One
/// always stays. The finest that stays simulates every bone, and errors are relative to it: those of the others grow by
/// its own at most, and are stored so.
void leave_out_levels(const DrawnRecipe& recipe, std::vector<DetailLevel>& levels, Findings& findings);

}  // namespace coif::cook
