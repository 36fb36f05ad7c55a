#include "report/page/report_heading.h"

#include "base/encodings.h"
#include "base/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

namespace coif::report {
namespace {

/// Way from the rigid bone to each bone's tail, metres; 0 for rigid bones.
std::vector<double> ways_to_tails(const Asset& asset) {
  const auto bones = asset.bones();
  std::vector<double> ways(bones.size(), 0.0);
  for (std::size_t i = 0; i < bones.size(); ++i) {
    if (bones[i].kind == BoneKind::kSimulated) ways[i] = ways[bones[i].parent] + double(bones[i].length);
  }
  return ways;
}

std::vector<double> sorted_chain_lengths(const Asset& asset) {
  const std::vector<double> ways = ways_to_tails(asset);
  std::vector<double> lengths;
  for (const ChainRecord& chain : asset.chains()) {
    if (chain.bone_count == 0) continue;
    const auto first = ways.begin() + chain.first_bone;
    lengths.push_back(*std::max_element(first, first + chain.bone_count));
  }
  std::ranges::sort(lengths);
  return lengths;
}

}  // namespace

ReportHeading heading_of(const Asset& asset, std::string name) {
  ReportHeading heading;
  heading.asset = std::move(name);
  heading.bones = asset.skeleton().bone_count;
  heading.simulated_bones = asset.skeleton().simulated_count;
  heading.chains = asset.skeleton().chain_count;
  heading.machine = describe_machine();
  const std::vector<double> lengths = sorted_chain_lengths(asset);
  if (lengths.empty()) return heading;
  heading.shortest_chain = lengths.front();
  heading.median_chain = lengths[lengths.size() / 2];
  heading.longest_chain = lengths.back();
  return heading;
}

std::string describe_machine() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const std::size_t value = line.find(": ");
    if (!line.starts_with("model name") || value == std::string::npos) continue;
    const unsigned cores = std::thread::hardware_concurrency();
    return line.substr(value + 2) + ", " + std::to_string(cores) + (cores == 1 ? " core" : " cores");
  }
  return "";
}

std::string heading_text(const ReportHeading& heading) {
  std::string text = fmt::format("{}: {} bones, {} of them simulated, in {} chain{} of {} to {} m (median {})",
                                 heading.asset, heading.bones, heading.simulated_bones, heading.chains,
                                 heading.chains == 1 ? "" : "s", number_text(heading.shortest_chain),
                                 number_text(heading.longest_chain), number_text(heading.median_chain));
  text += fmt::format("; measured in {:.1f} s", heading.seconds_taken);
  return heading.machine.empty() ? text : text + " on " + heading.machine;
}

nlohmann::ordered_json heading_json(const ReportHeading& heading) {
  return {
      {"asset", heading.asset},
      {"bones", heading.bones},
      {"simulated_bones", heading.simulated_bones},
      {"chains", heading.chains},
      {"chain_length_m",
       {{"shortest", heading.shortest_chain}, {"median", heading.median_chain}, {"longest", heading.longest_chain}}},
      {"machine", heading.machine},
      {"seconds_taken", heading.seconds_taken}};
}

void end_report(nlohmann::ordered_json& report, const ReportHeading& heading, const std::string& subject,
                const std::string& title, const std::string& finding, const ViewLink& shown) {
  const auto columns = report["columns"];
  report.erase("columns");
  report["report"] = subject;
  report["title"] = title + ": " + clean_text(heading.asset);
  report["about"] = heading_text(heading);
  report["finding"] = finding;
  report["view"] = nlohmann::ordered_json::array();
  if (!heading.view.empty()) {
    report["view"].push_back({{"text", heading.view_name}, {"url", view_url(heading.view, shown)}});
  }
  report["columns"] = columns;
}

std::string device_text(const std::string& device) {
  return device.starts_with("llvmpipe") ? device + ", which draws on the processor, not on a graphics card" : device;
}

void add_sheets(nlohmann::ordered_json& report, const std::vector<ReportSheet>& sheets) {
  report["sheets"] = nlohmann::ordered_json::array();
  for (const ReportSheet& sheet : sheets)
    report["sheets"].push_back({{"caption", sheet.caption}, {"png", base64(sheet.png)}});
}

}  // namespace coif::report
