#pragma once
// Viewing directions in cells: a cube around the head with 4 x 4 cells on each face. An asset may have a draw order for
// each cell (chunk VIEW).

#include <coif/asset_records.h>

#include <cmath>
#include <cstdint>

namespace coif {

/// tan(pi / 8), the edge between a face's inner and outer cells: cells are equal in angle along the two middle lines of
/// a face. So they differ in solid angle by a factor of 1.3; equal squares would differ by 3.
inline constexpr float kViewCellEdge = 0.41421356f;

/// The cell, below kViewCells, of a direction of any length, in head space, from the head towards the eye. A direction
/// of 0 or NaN gives some cell.
constexpr std::uint32_t view_cell(const float (&direction)[3]) {
  const auto size = [&](std::uint32_t axis) { return direction[axis] < 0 ? -direction[axis] : direction[axis]; };
  const std::uint32_t xy = size(0) >= size(1) ? 0 : 1;
  const std::uint32_t axis = size(xy) >= size(2) ? xy : 2;
  const float edge = kViewCellEdge * size(axis);
  const auto place = [&](float along) {
    return std::uint32_t(along >= -edge) + std::uint32_t(along >= 0) + std::uint32_t(along >= edge);
  };
  const std::uint32_t face = 2 * axis + std::uint32_t(direction[axis] < 0);
  return 16 * face + 4 * place(direction[(axis + 2) % 3]) + place(direction[(axis + 1) % 3]);
}

/// Writes the unit direction to a cell's middle.
inline void view_cell_direction(std::uint32_t cell, float (&direction)[3]) {
  constexpr float kMiddles[4] = {-0.66817864f, -0.19891237f, 0.19891237f,
                                 0.66817864f};  // tan of -3, -1, 1, 3 * pi / 16
  const std::uint32_t axis = cell / 32 % 3;
  const float a = kMiddles[cell % 4], b = kMiddles[cell / 4 % 4];
  const float scale = 1.0f / std::sqrt(1.0f + a * a + b * b);
  direction[axis] = cell / 16 % 2 == 0 ? scale : -scale;
  direction[(axis + 1) % 3] = a * scale;
  direction[(axis + 2) % 3] = b * scale;
}

}  // namespace coif
