#pragma once

#include <coif/asset.h>

#include <cstdint>
#include <string>

namespace coif {

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

}  // namespace coif
