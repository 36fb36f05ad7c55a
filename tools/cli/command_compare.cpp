#include "base/json.h"
#include "cli/command.h"
#include "cli/input_files.h"
#include "cli/messages.h"
#include "cli/options.h"
#include "compare/rig_difference.h"

#include <memory>

namespace coif::cli {
namespace {

struct CompareOptions {
  std::string a;
  std::string b;
  std::vector<motion::Motion> motions;
  animation::RecordingSettings recording;
  OutputFormat format = OutputFormat::kText;
};

struct MotionResult {
  const char* motion;
  compare::RigDifference difference;
};

struct CompareResult {
  double rest_rms = 0;
  double size = 0;
  std::vector<MotionResult> rows;
};

ToolError about_both(const CompareOptions& options, const ToolError& error) {
  return {error.kind, fmt::format("{} and {}: {}", options.a, options.b, error.message)};
}

tl::expected<CompareResult, ToolError> compare(const CompareOptions& options, const Asset& a, const Asset& b) {
  const auto match = compare::match_surfaces(a, b);
  if (!match) return tl::unexpected(about_both(options, match.error()));
  CompareResult result{match->rest_rms, compare::hair_size(a), {}};
  animation::RecordingSettings recording = options.recording;
  for (const motion::MotionInfo& info : motion::all_motions()) {
    const bool wanted =
        options.motions.empty() || std::ranges::find(options.motions, info.motion) != options.motions.end();
    if (!wanted) continue;
    recording.motion = info.motion;
    const auto difference = compare::compare_rigs(a, b, *match, recording);
    if (!difference) return tl::unexpected(about_both(options, difference.error()));
    result.rows.push_back({info.name, *difference});
  }
  return result;
}

double percent(double part, double whole) { return whole > 0 ? 100 * part / whole : 0; }

std::string result_json(const CompareOptions& options, const CompareResult& result) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const MotionResult& row : result.rows) {
    const compare::RigDifference& d = row.difference;
    rows.push_back({{"motion", row.motion},
                    {"rms_mm", 1000 * d.rms},
                    {"max_mm", 1000 * d.max},
                    {"rms_pct", percent(d.rms, result.size)},
                    {"max_pct", percent(d.max, result.size)},
                    {"moved_rms_mm", 1000 * d.moved},
                    {"ratio", d.ratio},
                    {"still_ratio", d.still_ratio}});
  }
  return json_text({{"a", options.a},
                    {"b", options.b},
                    {"fps", options.recording.fps},
                    {"seconds", options.recording.seconds},
                    {"hair_size_mm", 1000 * result.size},
                    {"rest_rms_mm", 1000 * result.rest_rms},
                    {"rows", rows}});
}

std::string result_text(const CompareOptions& options, const CompareResult& result) {
  std::string text = fmt::format(
      "{} against {}: hair of {:.0f} mm, {} s at {} per second; at rest {:.3f} mm apart\n"
      "  {:<10}{:>9}{:>7}{:>10}{:>7}{:>11}{:>8}{:>8}\n",
      options.b, options.a, 1000 * result.size, options.recording.seconds, options.recording.fps,
      1000 * result.rest_rms, "motion", "rms mm", "%", "max mm", "%", "moved mm", "ratio", "still");
  for (const MotionResult& row : result.rows) {
    const compare::RigDifference& d = row.difference;
    text += fmt::format("  {:<10}{:>9.2f}{:>7.2f}{:>10.2f}{:>7.1f}{:>11.2f}{:>8.2f}{:>8.2f}\n", row.motion,
                        1000 * d.rms, percent(d.rms, result.size), 1000 * d.max, percent(d.max, result.size),
                        1000 * d.moved, d.ratio, d.still_ratio);
  }
  return text +
         "  ratio: 0 the same motion, 1 as wrong as hair that does not move; still: that of the first asset's mean "
         "pose\n";
}

tl::expected<Exit, ToolError> run_compare(const CompareOptions& options) {
  const auto a = AssetFile::open(options.a);
  if (!a) return tl::unexpected(a.error());
  const auto b = AssetFile::open(options.b);
  if (!b) return tl::unexpected(b.error());
  const auto result = compare(options, a->asset(), b->asset());
  if (!result) return tl::unexpected(result.error());
  print_result(options.format == OutputFormat::kJson ? result_json(options, *result) : result_text(options, *result));
  return Exit::kOk;
}

void add_motions(CLI::App& app, std::vector<motion::Motion>& motions) {
  const auto parse = [&motions](const std::vector<std::string>& words) {
    for (const std::string& word : words) {
      const auto motion = motion::find_motion(word);
      if (!motion) throw CLI::ValidationError("--motion", fmt::format("'{}' is not a motion; see --help", word));
      motions.push_back(*motion);
    }
  };
  app.add_option_function<std::vector<std::string>>("--motion", parse, "How the head moves, repeatable (default: all)")
      ->type_name("NAME")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

}  // namespace

Command add_compare(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "compare", "Simulate two assets of one source, say a fitted rig and the artist's, and print how far they differ");
  const auto options = std::make_shared<CompareOptions>();
  app->footer(motion_help());
  app->add_option("A", options->a, "A cooked asset: what is right")->required();
  app->add_option("B", options->b, "Another one with the same surface")->required();
  add_motions(*app, options->motions);
  add_recording(*app, options->recording, "each motion");
  add_format(*app, options->format);
  return {app, [options](const Messages&) { return run_compare(*options); }};
}

}  // namespace coif::cli
