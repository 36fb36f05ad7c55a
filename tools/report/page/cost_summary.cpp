#include "report/page/cost_summary.h"

#include "report/page/cost_rows.h"
#include "report/page/number_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

namespace coif {
namespace {

std::string heads_text(std::uint32_t heads) { return heads == 1 ? "one head" : fmt::format("{} heads", heads); }

std::string simulation_sentences(const CostReport& report) {
  if (report.simulation.empty()) return "The hair is rigid: simulating it costs nothing.";
  const std::string solver = solvers_of(report).front();
  const auto rows = scaling_of(report, solver);
  const SimulationCostRow &least = rows.front(), &most = rows.back();
  std::string text = fmt::format("Simulating {} takes {} of one core a frame ({} with {} step{}, {} a bone)",
                                 heads_text(least.heads), time_text(1e3 * least.us_per_frame), solver, least.substeps,
                                 least.substeps == 1 ? "" : "s", time_text(least.ns_per_bone_frame));
  if (most.heads != least.heads) {
    text += fmt::format("; {} take {} ({} a bone)", heads_text(most.heads), time_text(1e3 * most.us_per_frame),
                        time_text(most.ns_per_bone_frame));
  }
  return text + fmt::format(". Each head of a large crowd takes {} of memory beside the asset.",
                            bytes_text(report.memory.bytes_per_head));
}

std::string drawing_sentence(const CostReport& report) {
  const auto rows = drawings_of(report, "blend", false);
  if (rows.empty()) return "";
  const RenderingCostRow &least = rows.front(), &most = rows.back();
  std::string text =
      fmt::format(" Drawing {} on {} at {} x {} takes {}", heads_text(least.heads), report.rendering.device,
                  report.rendering.width, report.rendering.height, time_text(1e6 * least.ms_per_frame));
  if (most.heads != least.heads) {
    text += fmt::format(", {} {}", heads_text(most.heads), time_text(1e6 * most.ms_per_frame));
  }
  return text + ".";
}

}  // namespace

std::string cost_summary(const CostReport& report) { return simulation_sentences(report) + drawing_sentence(report); }

std::string left_out_text(const CostReport& report, const std::string& what) {
  std::vector<std::uint32_t> sizes;
  std::string why;
  for (const CostLeftOut& crowd : report.left_out) {
    if (crowd.what != what) continue;
    if (sizes.empty()) why = crowd.why;
    sizes.push_back(crowd.heads);
  }
  if (sizes.empty()) return "";
  return fmt::format("Not measured: {} {} {} heads; {}.", what, what == kDrawnCrowd ? "of" : "with",
                     fmt::join(sizes, ", "), why);
}

}  // namespace coif
