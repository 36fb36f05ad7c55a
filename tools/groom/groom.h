#pragma once

// Hair as strands: what grooming tools export, and what cards are made from.

#include "base/tool_error.h"
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
inline constexpr std::size_t kMostStrandPoints = std::size_t{1} << 26;  ///< Of all strands together.

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
  std::vector<Eigen::Vector3f>
      points;  ///< Metres, Y up, as the file says (`space`); whether it is right is not judged here.
  std::vector<std::uint32_t> begin;  ///< Of each strand into `points`, and one more; a strand has two points at least.
  std::vector<float> widths;         ///< Diameters, metres, >= 0; empty: the file has none.
  std::vector<Eigen::Vector3f> colors;  ///< As the file has them, 0..1; empty: none.
  std::vector<float> opacities;         ///< 0..1; empty: the file has none.
  std::vector<StrandGroup> groups;
  std::uint32_t follow_hairs = 0;  ///< That the file asks for beside each strand; none of them is here.
  bool root_first = false;         ///< By the format's definition. Else either end of a strand may be its root.
  importer::SourceSpace space;
  std::vector<Warning> warnings;  ///< What was repaired or dropped, one sentence each.

  [[nodiscard]] std::size_t strand_count() const { return begin.empty() ? 0 : begin.size() - 1; }
  [[nodiscard]] std::span<const Eigen::Vector3f> strand(std::size_t i) const {
    return std::span(points).subspan(begin[i], begin[i + 1] - begin[i]);
  }
};

/// Metres, of strands on a head of that radius of which nothing else is known. Fewer than a head has stand for as many:
/// as wide as their number is less they would hide as much and be ropes, as wide as its root they would be as heavy and
/// show the skin; half way.
[[nodiscard]] float usual_strand_width(float head_radius, std::size_t strands);

/// Every promise above. Empty when they hold, else the first that does not.
[[nodiscard]] std::string find_groom_fault(const Groom& groom);

/// What readers of files add strands by, so that what cannot be used is left out by one rule and counted.
class GroomBuilder {
 public:
  /// `groom` outlives the builder and is empty but for what concerns the whole file.
  explicit GroomBuilder(Groom& groom) : groom_(groom) { groom_.begin.assign(1, 0); }

  /// The strands that follow belong to it.
  void begin_group(std::string name);

  /// What a point has beside its place; the file's own unit.
  struct Attributes {
    std::span<const float> widths;            ///< Empty, or one for each point.
    std::span<const Eigen::Vector3f> colors;  ///< The same.
    std::span<const float> opacities;         ///< The same.
  };

  /// One strand. Left out, and counted: fewer than two points, places that are not finite or farther than an asset
  /// reaches, no length. Neighbours at one place become one.
  void add(std::span<const Eigen::Vector3f> points, const Attributes& attributes = {});

  /// Says what was left out. The error is a sentence without the file's name: nothing is left, or too much.
  [[nodiscard]] std::string finish();

 private:
  Groom& groom_;
  std::size_t too_short_ = 0, misplaced_ = 0, without_length_ = 0;
  bool too_many_ = false;
};

}  // namespace coif::groom
