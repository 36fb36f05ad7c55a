#pragma once

#include "visibility/fragment_view.h"

#include <cstdint>
#include <span>
#include <vector>

namespace coif {

/// A fragment as far as drawing order is concerned.
struct Layer {
  float alpha = 0;
  std::uint32_t triangle : 31 = 0;
  std::uint32_t is_front : 1 = 0;
};

/// Lines of one view on which the order of drawing can matter, each with its layers, nearest first: what the head hides is
/// cut off, and so is what is behind a layer of at least the view's solid_alpha, or less than a thousandth of the light comes
/// from.
struct SightLines {
  SightLines() = default;
  SightLines(const FragmentView& view, float solid_alpha);

  [[nodiscard]] std::size_t size() const { return begin.size() - 1; }
  [[nodiscard]] std::span<const Layer> line(std::size_t index) const {
    return std::span(layers).subspan(begin[index], begin[index + 1] - begin[index]);
  }

  std::vector<std::uint32_t> begin = {0};  ///< Per line and one more: its first layer.
  std::vector<Layer> layers;
  std::size_t covered = 0;  ///< Lines of the view that meet hair, those left out here as well.
};

}  // namespace coif
