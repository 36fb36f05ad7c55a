#pragma once

#include "platform/stop.h"
#include "visibility/fragment_view.h"
#include "visibility/linear_order.h"
#include "visibility/seen_lines.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace coif::visibility {

/// Errors of pictures drawn in some order, see picture_error(); PSNR over the pixels that hair covers, dB.
struct OrderQuality {
  double psnr = 0;     ///< Over all views' pixels.
  double median = 0;   ///< Over the views at rest.
  double worst = 0;    ///< Among the views at rest.
  double moving = 0;   ///< Median over the views in motion; that of those at rest where there are none.
  double blended = 0;  ///< Blended layers per pixel: the cost of drawing.
};

/// The hair from sides that no order is found from. The slow part is done once; any threshold, with the mips that
/// belong to it, can then be judged.
class JudgedHair {
 public:
  /// `settings`: its solid_alpha does not matter.
  JudgedHair(const SeenHair& hair, std::span<const HairPositions> poses, const SampleSettings& settings);

  struct View {
    std::uint32_t cell = 0;  ///< The cell of its direction.
    std::uint32_t pose = 0;
    SeenHits hits;
  };
  [[nodiscard]] std::size_t views_per_cell() const { return views_per_cell_; }
  [[nodiscard]] const View& view(std::size_t cell, std::size_t index) const {
    return views_[cell * views_per_cell_ + index];
  }

 private:
  std::size_t views_per_cell_;
  std::vector<View> views_;
};

/// The alpha of the judged hair, and how many views are used.
struct JudgeSettings {
  float least_threshold = 0.95f;   ///< Rules that are judged must have no lower opaque threshold.
  std::size_t views_per_cell = 1;  ///< The first of the existing ones.
  platform::Threads threads = 1;   ///< Without influence on the result.
};

/// Judges orders by views that none of them was found from.
class OrderJudge {
 public:
  OrderJudge(const JudgedHair& hair, const AlphaTexture& alpha, const JudgeSettings& settings);

  /// `orders`: of all triangles.
  [[nodiscard]] OrderQuality judge(const CellOrders& orders, const DrawRule& rule) const;
  /// The best that any order could do.
  [[nodiscard]] double best_psnr(const DrawRule& rule) const;
  /// Blended layers per line, mean over the views.
  [[nodiscard]] double blended(const DrawRule& rule) const;

 private:
  /// The hair drawn from one side.
  struct View {
    std::uint32_t cell = 0;
    std::uint32_t pose = 0;
    SeenLines lines;
  };
  [[nodiscard]] std::vector<double> of_views(const std::function<double(const View&)>& figure) const;
  [[nodiscard]] std::size_t pixels() const;

  std::vector<View> views_;
  platform::Threads threads_;
};

}  // namespace coif::visibility
