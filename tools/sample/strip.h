#pragma once

#include "sample/surface_mesh.h"

#include <functional>
#include <span>

namespace coif::sample {

/// A vertical window of the texture, U from..to.
struct TextureWindow {
  double from = 0;
  double to = 1;
};

/// One hair strip: what an artist decides about it. Angles as in HairCourse.
struct StripStyle {
  int columns = 4;          ///< Quads across.
  int rows = 14;            ///< Quads from root to tip.
  double azimuth = 0;       ///< Middle, degrees.
  double half_width = 20;   ///< Degrees at the skull's widest line.
  double parting_from = 0;  ///< Parting position of the edge with the smaller azimuth.
  double parting_to = 1;    ///< ... and of the other edge.
  double start = 0.02;
  double sweep = 0;          ///< Degrees that the tip is carried aside.
  double lift = 0.01;        ///< Metres above the skull.
  double bulge = 0.003;      ///< Metres that the middle stands above the edges.
  double tip_height = 1.43;  ///< Model Y, metres.
  double flare = 0.010;
  double curl = 0.020;
  double taper = 0.5;  ///< Share of the width lost at the tip.
  TextureWindow window;
};

/// A point of a strip: `across` -1..1, `along` 0 root .. 1 tip, and a little beyond.
using StripSurface = std::function<Eigen::Vector3d(double across, double along)>;

/// Appends a grid of quads with its own vertices and normals outwards, U across, V 0 at the root and 1 at the tip. Each row of
/// vertices lies at one of `places` along the strip, ascending.
void append_grid(int columns, std::span<const double> places, const TextureWindow& window, const StripSurface& surface,
                 SurfaceMesh& mesh);

/// Appends the strip to `mesh`: a grid with its own vertices, U across, V 0 at the root and 1 at the tip. `seed` picks
/// the slight irregularity of length, wave and twist.
void append_strip(const StripStyle& style, unsigned seed, SurfaceMesh& mesh);

}  // namespace coif::sample
