#pragma once

// What `coif report order` found, as data: measured by measure_order(), shown by the renderers of report/page.
//
// A picture's error is its difference from the exact one, in which every pixel's layers are sorted by depth and every alpha
// counts as it is: over the pixels that hair covers there, in sRGB-encoded values of 0..1, as a screen shows them. 8-bit
// pictures that are equal have kEqualDb.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace coif {

inline constexpr double kEqualDb = 99;         ///< The most that any PSNR says.
inline constexpr double kBadDifference = 0.1;  ///< Of any channel, from which on a pixel counts as wrong.

/// Errors of one way to draw over all views.
struct OrderError {
  double psnr_db = kEqualDb;         ///< Of the squared error over the pixels of all views together.
  double median_psnr_db = kEqualDb;  ///< Over the views.
  double worst_psnr_db = kEqualDb;
  double rmse = 0;
  double bad_pixels_pct = 0;
  std::vector<double> view_psnr_db;  ///< One per view, in OrderReport::directions' order.
};

/// A draw order in one pose.
struct OrderRow {
  std::string order;  ///< file, head, best, view, bones, triangles.
  std::string pose;   ///< rest or a motion.
  bool faces_together = false;
  OrderError error;
  /// RMS over an orbit by single degrees of what a pixel changes from frame to frame beyond what it changes in exact pictures.
  std::optional<double> popping{};
  double ms_per_frame = 0;  ///< Wall time until the device has finished; `triangles`: sorting included, upload not.
  std::uint64_t bytes = 0;  ///< Of indices on the device.
};

/// A way to draw transparent hair, with the asset's orders, in one pose.
struct OrderModeRow {
  std::string transparency;  ///< As the command line calls it.
  std::uint32_t samples = 1;
  std::string pose;
  OrderError error;
  std::optional<double> popping{};
  double ms_per_frame = 0;
};

/// The asset's orders with another opaque threshold than its own, at rest.
struct ThresholdRow {
  double opaque_threshold = 0;
  bool is_own = false;  ///< It is the asset's.
  OrderError error;
};

/// How much hair is left where the head is drawn small, at rest.
struct DistanceRow {
  std::uint32_t pixels = 0;     ///< Height of the picture that the head fills.
  double coverage_pct = 0;      ///< Sum of alpha, finest level, of that of the exact picture at the first row's size.
  std::uint32_t lod = 0;        ///< What a game would draw at this size,
  double lod_coverage_pct = 0;  ///< and how much that covers.
};

/// What a way to draw looks like where it is worst.
struct WorstPicture {
  std::string name;  ///< An order or a transparency mode.
  std::string pose;
  double yaw_degrees = 0, pitch_degrees = 0;
  double psnr_db = 0;
  std::vector<std::uint8_t> png;  ///< Side by side: exact, this, four times the difference.
};

/// Of the exact picture from itself, over a few views: the floor below which no error means anything.
struct SelfDifferenceRow {
  std::string against;  ///< "again": the same taken twice.
  double psnr_db = kEqualDb;
  double max_difference = 0;  ///< Of any channel, 0..1.
};

struct ViewAngle {
  double yaw_degrees = 0, pitch_degrees = 0;
};

/// How much better the asset's own orders are than the thesis's.
struct OrderGain {
  std::string pose;
  double gain_over_head_db = 0;  ///< Of psnr_db.
};

struct OrderLeftOut {
  std::string what;  ///< An order or a mode.
  std::string why;
};

struct OrderReport {
  std::string device;                   ///< GL_RENDERER.
  std::uint32_t width = 0, height = 0;  ///< Pixels.
  double opaque_threshold = 0;          ///< The asset's.
  std::uint32_t orders = 1;             ///< That the asset has.
  std::vector<ViewAngle> directions;
  std::uint32_t orbit_frames = 0;
  std::vector<OrderRow> rows;
  std::vector<OrderModeRow> modes;
  std::vector<ThresholdRow> thresholds;
  std::vector<DistanceRow> distance;
  std::vector<SelfDifferenceRow> reference;
  std::vector<OrderGain> gains;
  std::vector<OrderLeftOut> left_out;
  std::vector<WorstPicture> worst;
};

}  // namespace coif
