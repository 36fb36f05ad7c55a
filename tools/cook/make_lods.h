#pragma once

#include "cook/drop_patches.h"
#include "cook/fit_head.h"
#include "cook/lod_bones.h"
#include "cook/simplify_patches.h"

#include <string>

namespace coif {

/// One level of detail: what it draws of each patch, and the bones that move on their own.
struct DetailLevel {
  std::vector<std::vector<std::uint32_t>> triangles_of;  ///< Per patch, three vertices each; empty: it is not drawn.
  float error = 0;                                       ///< As LodRecord::error.
  float screen_size = 0;                                 ///< As LodRecord::screen_size.
  std::vector<bool> simulated;                           ///< Per bone.

  [[nodiscard]] std::size_t triangle_count() const;
  [[nodiscard]] std::size_t patch_count() const;
};

struct DetailLevels {
  std::vector<DetailLevel> levels;  ///< Finest first; at least one.
  std::vector<std::string> notes;
};

struct LodSettings {
  std::uint32_t levels = 3;
  double ratio = 0.5;        ///< Triangles of a level, against the next finer one.
  double max_error = 0.01;   ///< Metres.
  double pixel_error = 1;    ///< Pixels that the error may be on a screen of kScreenLines lines.
  double still_pixels = 24;  ///< Hair that hangs free for less than this on such a screen is rigid.
  unsigned threads = 1;      ///< The result does not depend on it.
};

[[nodiscard]] LodSettings lod_settings(const Recipe& recipe, unsigned threads);

inline constexpr double kScreenLines = 1080;

/// Makes coarser levels of the hair until there are as many as wanted or one would save little. Each has, as far as its
/// error stays below the limit, `ratio` times the triangles of the one before: first patches are simplified, everywhere up
/// to the same error; where that is not enough patches that hardly show are dropped.
///
/// A level fits from that size on at which the next coarser one's error is `pixel_error` pixels:
/// screen_size = height of the head * pixel_error / (kScreenLines * error of the next level).
[[nodiscard]] DetailLevels make_lods(const HairMesh& mesh, std::span<const std::uint32_t> place,
                                     const PatchSet& patches, const Skeleton& skeleton, const SkinWeights& weights,
                                     const FittedHead& head, const AlphaTest& alpha, const LodSettings& settings);

}  // namespace coif
