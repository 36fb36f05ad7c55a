#pragma once

#include "mannequin/head_shape.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace coif::research {

// The course of hair on this head: from the parting over the skull to its widest line, then hanging down.

/// One hair's course. Angles in degrees around the head: 0 at the face, +90 at the model's left (+X), 180 at the back.
struct HairCourse {
  double parting = 0;        ///< Where it leaves the parting: 0 at the forehead .. 1 at the crown.
  double azimuth = 0;        ///< Where it passes the skull's widest line.
  double start = 0;          ///< Share of the way from the parting to that line that is left out; may be negative.
  double lift = 0.01;        ///< Metres above the skull once away from the root.
  double tip_height = 1.43;  ///< Model Y of the tip, metres.
  double flare = 0.010;      ///< Metres that the hanging part leans outwards.
  double curl = 0.020;       ///< Metres that the tip turns back inwards.
};

/// Point of the hair at `along`, 0 root .. 1 tip, about evenly spaced. Model space, metres; clear of the bust.
[[nodiscard]] Eigen::Vector3d point_on_hair(const HairCourse& course, double along);

/// Angle of a point around the head, degrees, -180..180, as in HairCourse.
[[nodiscard]] double azimuth_of(const Eigen::Vector3d& point);

/// A vertical window of the texture, U from..to.
struct TextureWindow {
  double from = 0;
  double to = 1;
};

/// One hair strip, with an artist's choices. Angles as in HairCourse.
struct StripStyle {
  HairCourse course;        ///< The course of its middle, except for its start on the parting.
  int columns = 4;          ///< Quads across.
  int rows = 14;            ///< Quads from root to tip.
  double half_width = 20;   ///< Degrees at the skull's widest line.
  double parting_from = 0;  ///< Parting position of the edge with the smaller azimuth.
  double parting_to = 1;    ///< ... and of the other edge.
  double sweep = 0;         ///< Degrees that the tip is carried aside.
  double bulge = 0.003;     ///< Height of the middle above the edges, metres.
  double taper = 0.5;       ///< Share of the width lost at the tip.
  TextureWindow window;
};

/// A point of a strip: `across` -1..1, `along` 0 root .. 1 tip, and a little beyond.
using StripSurface = std::function<Eigen::Vector3d(double across, double along)>;

/// Appends a grid of quads with its own vertices and normals outwards, U across, V 0 at the root and 1 at the tip. Each
/// row of vertices lies at one of `places` along the strip, ascending.
void append_grid(int columns, std::span<const double> places, const TextureWindow& window, const StripSurface& surface,
                 mannequin::SurfaceMesh& mesh);

/// Appends the strip to `mesh`: a grid with its own vertices, U across, V 0 at the root and 1 at the tip. `seed` picks
/// the slight irregularity of length, wave and twist.
void append_strip(const StripStyle& style, unsigned seed, mannequin::SurfaceMesh& mesh);

/// The texture's windows, side by side: four clumps for strips, one broad one for panels.
inline constexpr std::array<TextureWindow, 4> kClumpWindows{
    {{0.000, 0.156}, {0.156, 0.312}, {0.312, 0.469}, {0.469, 0.625}}};
inline constexpr TextureWindow kBroadWindow{0.625, 1.000};

/// 512 x 512 RGBA, sRGB, straight alpha: roots at the top, tips at the bottom. Opaque in the middle, single strands at
/// tips and sides; colour continues under transparent texels, so that filtering leaves no halo. Not taller: a strand
/// changes little along its length, and a texture squeezed in V makes the renderer pick mips that blur the strands in
/// U.
struct StrandTexture {
  static constexpr int kWidth = 512;
  static constexpr int kHeight = 512;
  std::vector<std::uint8_t> rgba;
};

/// Mean colour of the hair along a strand, sRGB 0..1. The defaults are the bob's brown.
struct StrandColors {
  Eigen::Vector3d root{0.230, 0.148, 0.098};
  Eigen::Vector3d length{0.410, 0.275, 0.182};
  Eigen::Vector3d tip{0.560, 0.405, 0.280};
};

[[nodiscard]] StrandTexture make_strand_texture(const StrandColors& colors = {});

}  // namespace coif::research
