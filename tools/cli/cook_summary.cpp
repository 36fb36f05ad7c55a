#include "cli/cook_summary.h"

#include "cli/json_text.h"
#include "cli/results.h"
#include "counted.h"

#include <fmt/format.h>

namespace coif {
namespace {

double total_ms(const CookReport& report) {
  double sum = 0;
  for (const PassTime& pass : report.passes) sum += pass.ms;
  return sum;
}

std::string next_step(const CookSummary& summary) {
  const CookReport& report = summary.report;
  if (report.simulated_bones == 0) {
    return "nothing will move: 'coif cook SOURCE --list' prints the bones; name the hair's in a recipe "
           "('coif cook --print-recipe')";
  }
  if (report.triangles == 0) return fmt::format("coif simulate {} --motion turn -o turn.csv", summary.output);
  return fmt::format("coif render {} -o picture.png", summary.output);
}

/// Up to a colon: what a line is about.
std::string subject_of(const std::string& line) { return line.substr(0, line.find_first_of(":'")); }

/// One line each, but no more than a few in a row about one subject; the JSON result has all.
std::string folded(const std::vector<std::string>& lines, const char* prefix) {
  constexpr std::size_t kMostInARow = 4;
  std::string text;
  for (std::size_t first = 0, end = 0; first < lines.size(); first = end) {
    while (end < lines.size() && subject_of(lines[end]) == subject_of(lines[first])) ++end;
    const std::size_t count = end - first, shown = count <= kMostInARow + 1 ? count : kMostInARow;
    for (std::size_t i = first; i < first + shown; ++i) text += fmt::format("  {}{}\n", prefix, lines[i]);
    if (shown < count)
      text += fmt::format("  {}... and {} more like this (all with --format json)\n", prefix, count - shown);
  }
  return text;
}

nlohmann::ordered_json left_out_json(const CookReport& report) {
  auto list = nlohmann::ordered_json::array();
  for (const LeftOut& left_out : report.left_out) {
    list.push_back({{"what", left_out.what},
                    {"why", left_out.why},
                    {"bytes", left_out.bytes},
                    {"bytes_per_head", left_out.bytes_per_head},
                    {"ns_per_frame", left_out.ns_per_frame}});
  }
  return list;
}

std::vector<std::string> left_out_lines(const CookReport& report) {
  std::vector<std::string> lines;
  for (const LeftOut& left_out : report.left_out) lines.push_back(left_out.text());
  return lines;
}

}  // namespace

std::string cook_json(const CookSummary& summary) {
  const CookReport& report = summary.report;
  auto passes = nlohmann::ordered_json::array();
  for (const PassTime& pass : report.passes) passes.push_back({{"name", pass.name}, {"ms", pass.ms}});
  return json_text({{"output", summary.output},
                    {"bytes", summary.bytes},
                    {"from_cache", summary.from_cache},
                    {"passes", std::move(passes)},
                    {"warnings", report.warnings},
                    {"triangles", report.triangles},
                    {"vertices", report.vertices},
                    {"patches", report.patches},
                    {"patches_by_index", report.patches_by_index},
                    {"patches_by_position", report.patches_by_position},
                    {"chains", report.chains},
                    {"bones", report.bones},
                    {"simulated_bones", report.simulated_bones},
                    {"notes", report.notes},
                    {"left_out", left_out_json(report)}});
}

std::string cook_text(const CookSummary& summary) {
  const CookReport& report = summary.report;
  std::string text =
      fmt::format("{}: {} in {} ({} by index, {} by position)\n", summary.output,
                  counted(report.triangles, "triangle", "triangles"), counted(report.patches, "patch", "patches"),
                  report.patches_by_index, report.patches_by_position);
  text += fmt::format("  {} of {}, {} of them simulated\n", counted(report.chains, "chain", "chains"),
                      counted(report.bones, "bone", "bones"), report.simulated_bones);
  text += fmt::format("  {} bytes {} {:.0f} ms, {}\n", summary.bytes,
                      summary.from_cache ? "from the cache, once cooked in" : "in", total_ms(report),
                      counted(report.warnings.size(), "warning", "warnings"));
  text += folded(report.notes, "");
  text += folded(left_out_lines(report), "left out: ");
  return text + fmt::format("  next: {}\n", next_step(summary));
}

}  // namespace coif
