#pragma once

#include "platform/stop.h"
#include "visibility/fragment_view.h"

#include <cstdint>
#include <span>
#include <vector>

namespace coif::visibility {

/// How the renderer turns layers into a pixel (thesis 5.3.1).
struct DrawRule {
  float opaque_threshold = 0.95f;  ///< Layers from this alpha on are solid, and sorted by depth.
  bool faces_together = false;     ///< The other layers are blended in one go; else back faces before front faces.
  float discard_threshold = 0;     ///< Fainter layers are not drawn.
  bool operator==(const DrawRule&) const = default;
};

/// PSNR of a picture with this squared error, summed over so many pixels; at most 99.
[[nodiscard]] double psnr_db(double squared_error, std::size_t pixels);

/// A vote to draw unit `first` before unit `second`, with the squared error that this saves; first < second, and a
/// negative weight is a vote for the reverse.
struct Vote {
  std::uint32_t first = 0;
  std::uint32_t second = 0;
  float weight = 0;
};

/// The votes of a view on an order of units (patches, or parts of them). For each two blended layers on a line, the
/// further one should come first, with the squared error of the pixel where only these two are swapped: both alphas
/// times the light that reaches the further one past all others. Pairs that no order can change have no vote: of one
/// unit, with a solid layer between or before them, or, where faces are drawn apart, one of each face. Sorted by units,
/// one vote per pair.
[[nodiscard]] std::vector<Vote> votes_of(const SightLines& lines, std::span<const std::uint32_t> unit_of_triangle,
                                         const DrawRule& rule);

/// Turns votes on units into votes on groups of them, such as triangles' patches: as votes_of() with groups as units.
[[nodiscard]] std::vector<Vote> votes_of_groups(std::span<const Vote> votes, std::span<const std::uint32_t> group_of);

/// The sums of several lists of votes, each as votes_of() makes it. `threads`: without influence on the result.
[[nodiscard]] std::vector<Vote> sum_of(std::span<const std::span<const Vote>> lists,
                                       const platform::Threads& threads = 1);

}  // namespace coif::visibility
