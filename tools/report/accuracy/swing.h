#pragma once

// The liveliness of hair: its motion after the head has stopped accelerating.

#include "report/page/report_columns.h"

#include <coif/asset.h>

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace coif::report {

/// A tip that was thrown from where it rests.
struct Swing {
  double thrown = 0;  ///< Farthest from its rest.
  /// How far it then swings to the other side, as a share of `thrown`, both horizontal.
  double overshoot = 0;
  /// From the moment when the head moves steadily until the tip stays within a twentieth of `thrown`. NaN: never.
  double settling_s = 0;
};

/// `tips`: places of the tip relative to the head, `dt` seconds apart, the first one when the head begins to move
/// steadily. `rest`: its resting place. Units are the caller's.
[[nodiscard]] Swing swing_of(std::span<const Eigen::Vector3d> tips, const Eigen::Vector3d& rest, double dt);

/// One chain after the motion `charge`, from 0 to 8 m/s in 0.3 s: with the asset's dynamics at 60 frames per second,
/// and by Algorithm 1 with the artist's resistance.
struct SwingRow {
  std::string chain;
  double length_mm = kNoNumber;
  double thrown_pct = kNoNumber;  ///< % of the chain's length.
  double overshoot_pct = kNoNumber;
  double settling_s = kNoNumber;
  double artist_overshoot_pct = kNoNumber;
  double artist_settling_s = kNoNumber;
  double apart_pct = kNoNumber;  ///< RMS distance of the two over the motion, of the chain's length.
};

[[nodiscard]] inline Columns<SwingRow> swing_columns() {
  using Row = SwingRow;
  return {{"chain", &Row::chain, {"chain"}, {"chain", -24}},
          {"length_mm", &Row::length_mm, {"length mm"}, {"mm", 6, "{:.0f}"}},
          {"thrown_pct", &Row::thrown_pct, {"thrown %"}, {"thrown %", 10, "{:.0f}"}},
          {"overshoot_pct", &Row::overshoot_pct, {"overshoot %"}, {"overshoot %", 13, "{:.0f}"}},
          {"settling_s", &Row::settling_s, {"settles in s"}, {"settles s", 11, "{:.2f}"}},
          {"artist_overshoot_pct",
           &Row::artist_overshoot_pct,
           {"Algorithm 1: overshoot %"},
           {"Algorithm 1: %", 16, "{:.0f}"}},
          {"artist_settling_s", &Row::artist_settling_s, {"Algorithm 1: settles in s"}, {"s", 7, "{:.2f}"}},
          {"apart_pct", &Row::apart_pct, {"apart %"}, {"apart %", 9, "{:.0f}"}}};
}

/// The path of a tip relative to the head: how many metres it is behind its place at the start, or before it, in the
/// head's direction.
struct SwingPath {
  std::string chain;
  double seconds_per_frame = 0;  ///< The first frame ends after one.
  std::vector<double> behind_m;
  std::vector<double> artist_behind_m;  ///< By Algorithm 1.
};

struct Swings {
  std::vector<SwingRow> rows;  ///< One for each tip, longest chain first.
  SwingPath longest;           ///< The longest chain's path.
};

/// Measures chains with at most 128 of the asset's bones together, evenly chosen.
[[nodiscard]] Swings measure_swings(const Asset& asset);

}  // namespace coif::report
