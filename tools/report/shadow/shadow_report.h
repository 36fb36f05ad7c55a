#pragma once

// What `coif report shadows` found, as data: measured by measure_shadows(), shown by the renderers of report/page.
//
// A light's transmittance at a point is the share of it that neither head nor hair keep from there, 0..1. An error is a
// technique's transmittance less the exact one, the product of 1 - alpha of all that lies between.

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace coif {

/// Of a technique's transmittance over many points.
struct ShadowError {
  double rmse = std::numeric_limits<double>::quiet_NaN();  ///< NaN: there are no such points.
  double bias = std::numeric_limits<double>::quiet_NaN();  ///< Mean; positive: too much light comes through.
};

/// One technique under one light in one pose.
struct ShadowRow {
  std::string technique;  ///< "plain" or "deep", as the command line calls them; "none": all light reaches everything.
  std::uint32_t layers = 0;  ///< 0: it has none.
  std::uint32_t size = 0;    ///< Texels of the map each way.
  std::string light;         ///< ShadowLight::name.
  std::string pose{};        ///< "rest" or a motion.
  ShadowError hair{};        ///< Over the hair that the head leaves in the light, each point counted by its alpha.
  ShadowError head{};        ///< Over the side of the head that is turned to the light.
  double ms = 0;             ///< Wall time of drawing the map, until the device has finished, median.
};

/// One technique over all lights and poses.
struct ShadowTotal {
  std::string technique;
  std::uint32_t layers = 0;
  std::uint32_t size = 0;
  ShadowError hair{}, head{};
  std::string worst_light{};  ///< Where the error over hair is largest,
  std::string worst_pose{};
  double worst_rmse = 0;    ///< and how large.
  double ms = 0;            ///< Median over lights and poses.
  std::uint64_t bytes = 0;  ///< Of the map's textures.
};

/// A direction that light comes from, in degrees as of a camera: yaw 0 is before the face, positive to the model's left.
struct ShadowLight {
  std::string name;
  double yaw_degrees = 0, pitch_degrees = 0;
};

struct ShadowReport {
  std::string device;                              ///< GL_RENDERER.
  double spacing = 0;                              ///< Metres between the exact reference's lines.
  std::uint64_t hair_points = 0, head_points = 0;  ///< All lights and poses together.
  std::vector<ShadowLight> lights;
  std::vector<ShadowRow> rows;
  std::vector<ShadowTotal> totals;  ///< In the order in which they first occur in `rows`.
};

}  // namespace coif
