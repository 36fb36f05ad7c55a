#pragma once

// What the reports have in common.

#include "base/json.h"

#include <coif/asset.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <string>

namespace coif {

/// A number that does not exist: printed as "-", null in JSON.
inline constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// What is being measured, for people: "coif, turn at 60 per second". Called from the measuring thread.
using ReportProgress = std::function<void(const std::string& step)>;

/// What a report is about, and where its times were taken.
struct ReportHeading {
  std::string asset;  ///< File name, as the user gave it.
  std::uint32_t bones = 0;
  std::uint32_t simulated_bones = 0;
  std::uint32_t chains = 0;
  /// Longest way from a chain's root to one of its tips, metres; over the chains.
  double shortest_chain = 0, median_chain = 0, longest_chain = 0;
  std::string machine;       ///< Processor and cores, one line; empty where the system does not tell.
  double seconds_taken = 0;  ///< By the whole measurement.
};

/// All but the time it took.
[[nodiscard]] ReportHeading heading_of(const Asset& asset, std::string name);

/// "AMD EPYC 9B14, 2 cores"; empty where /proc/cpuinfo does not tell.
[[nodiscard]] std::string describe_machine();

/// "bob.coif: 24 bones, 18 of them simulated, in 6 chains of 0.12 to 0.31 m. Measured in 42 s on ...": one line.
[[nodiscard]] std::string heading_text(const ReportHeading& heading);

/// The keys that every report begins with.
[[nodiscard]] nlohmann::ordered_json heading_json(const ReportHeading& heading);

/// The device's name, and that it is none where the processor draws.
[[nodiscard]] std::string device_text(const std::string& device);

}  // namespace coif
