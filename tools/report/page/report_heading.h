#pragma once

// Shared by all reports.

#include "base/json.h"
#include "report/page/report_page.h"

#include <coif/asset.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace coif::report {

/// A number that does not exist: printed as "-", null in JSON.
inline constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// The present measurement, for people: "coif, turn at 60 per second". Called from the measuring thread.
using ReportProgress = std::function<void(const std::string& step)>;

/// The subject of a report, and the machine of its times.
struct ReportHeading {
  std::string asset;  ///< File name, as the user gave it.
  std::uint32_t bones = 0;
  std::uint32_t simulated_bones = 0;
  std::uint32_t chains = 0;
  /// Longest way from a chain's root to one of its tips, metres; over the chains.
  double shortest_chain = 0, median_chain = 0, longest_chain = 0;
  std::string machine;       ///< Processor and cores, one line; empty where the system does not say.
  double seconds_taken = 0;  ///< Time of the whole measurement.
  std::string view{};        ///< The page of `coif view` of this asset: a relative URL; empty: none.
  std::string view_name{};   ///< The page's name for people.
};

/// Everything except the time it took.
[[nodiscard]] ReportHeading heading_of(const Asset& asset, std::string name);

/// "AMD EPYC 9B14, 2 cores"; empty where /proc/cpuinfo does not say.
[[nodiscard]] std::string describe_machine();

/// "bob.coif: 24 bones, 18 of them simulated, in 6 chains of 0.12 to 0.31 m. Measured in 42 s on ...": one line.
[[nodiscard]] std::string heading_text(const ReportHeading& heading);

/// The keys that every report begins with.
[[nodiscard]] nlohmann::ordered_json heading_json(const ReportHeading& heading);

/// Adds the keys that every report ends with: `subject` as "report", the page's "title", the heading and `finding` as
/// sentences ("about", "finding"), "view", a list with one link to the page of `coif view` with the settings of `shown`
/// if there is such a page, and "columns", which define how lists are shown.
void end_report(nlohmann::ordered_json& report, const ReportHeading& heading, const std::string& subject,
                const std::string& title, const std::string& finding, const ViewLink& shown = {});

/// Pictures side by side, for the page.
struct ReportSheet {
  std::string caption;
  std::vector<std::uint8_t> png;
};

/// Adds them as "sheets", each with a "caption" and the picture, a "png" in base64.
void add_sheets(nlohmann::ordered_json& report, const std::vector<ReportSheet>& sheets);

/// The names in one member of the records, each once, in the order in which they first occur.
template <typename Record>
[[nodiscard]] std::vector<std::string> names_of(const std::vector<Record>& records, std::string Record::*name) {
  std::vector<std::string> names;
  for (const Record& record : records) {
    if (std::ranges::find(names, record.*name) == names.end()) names.push_back(record.*name);
  }
  return names;
}

/// The device's name, and a remark where the processor draws.
[[nodiscard]] std::string device_text(const std::string& device);

}  // namespace coif::report
