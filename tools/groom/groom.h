#pragma once

// Hair as strands: exported by grooming tools, and the source of cards.

#include "base/diagnostic.h"
#include "import/source_model.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace coif::groom {

inline constexpr std::size_t kMostStrands = std::size_t{1} << 20;       ///< A head has some 100,000.
inline constexpr std::size_t kMostStrandPoints = std::size_t{1} << 26;  ///< All strands together.

/// Strands that belong together in the file: an object, or the whole file.
struct StrandGroup {
  std::string name;
  std::uint32_t first_strand = 0;  ///< Groups follow each other without gap.
  std::uint32_t strand_count = 0;  ///< > 0.
};

/// Polylines in the order of the file. Arrays per point are either empty or as long as `points`.
struct Groom {
  std::string path;
  std::string format;  ///< For people: "TressFX 3.0".
  /// Metres, Y up, by the file's statement (`space`); whether it is right is not judged here.
  std::vector<Eigen::Vector3f> points;
  /// First index in `points` of each strand, and one more; a strand has at least two points.
  std::vector<std::uint32_t> begin;
  std::vector<float> widths;            ///< Diameters, metres, >= 0; empty: the file has none.
  std::vector<Eigen::Vector3f> colors;  ///< The file's own, 0..1; empty: none.
  std::vector<float> opacities;         ///< 0..1; empty: the file has none.
  std::vector<StrandGroup> groups;
  std::uint32_t follow_hairs = 0;  ///< The number that the file wants beside each strand; they are not included here.
  bool root_first = false;         ///< By the format's definition. Else either end of a strand may be its root.
  importer::SourceSpace space;
  Diagnostics warnings;  ///< Repairs and losses, one sentence each.

  [[nodiscard]] std::size_t strand_count() const { return begin.empty() ? 0 : begin.size() - 1; }
  [[nodiscard]] std::span<const Eigen::Vector3f> strand(std::size_t i) const {
    return std::span(points).subspan(begin[i], begin[i + 1] - begin[i]);
  }
};

/// Width in metres for strands without one, on a head of that radius. Fewer strands than a head has stand for all of
/// its hair. Widths in inverse proportion to their number would hide as much but look like ropes; widths by the inverse
/// square root would have the same weight but show the skin. The result is half way between.
[[nodiscard]] float usual_strand_width(float head_radius, std::size_t strands);

/// Leaves out the few strands, one of a thousand at most, that lie at least twice as far away from the middle as all
/// others, or reach twice as far: an exporter's faults, which would make a head of the wrong size. Warns of them.
void leave_out_strays(Groom& groom);

/// Every promise above. Empty when they hold, else the first that does not.
[[nodiscard]] std::string find_groom_fault(const Groom& groom);

/// Adds strands for the readers of files, so that one rule decides what is left out, and it is counted.
class GroomBuilder {
 public:
  /// `groom` must outlive the builder and be empty except for values of the whole file.
  explicit GroomBuilder(Groom& groom) : groom_(groom) { groom_.begin.assign(1, 0); }

  /// The strands that follow belong to it.
  void begin_group(std::string name);

  /// Attributes of points; in the file's own unit.
  struct Attributes {
    std::span<const float> widths;            ///< Empty, or one for each point.
    std::span<const Eigen::Vector3f> colors;  ///< As widths.
    std::span<const float> opacities;         ///< As widths.
  };

  /// Adds one strand. Left out and counted: fewer than two points, places that are not finite or beyond an asset's
  /// range, no length. Neighbours at one place become one point.
  void add(std::span<const Eigen::Vector3f> points, const Attributes& attributes = {});

  /// Reports what was left out. The error is a sentence without the file's name: nothing is left, or too much.
  [[nodiscard]] std::string finish();

 private:
  Groom& groom_;
  std::size_t too_short_ = 0, misplaced_ = 0, without_length_ = 0;
  bool too_many_ = false;
};

}  // namespace coif::groom
