#include "cli/options.h"

#include "base/text.h"
#include "import/clip_file.h"
#include "motion/head_path.h"
#include "validate/issue_codes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace coif::cli {
namespace {

constexpr Choice<OutputFormat> kFormats[] = {{"text", OutputFormat::kText}, {"json", OutputFormat::kJson}};

bool is_drawable(std::uint32_t pixels) { return pixels >= 16 && pixels <= 8192; }

}  // namespace

void add_format(CLI::App& app, OutputFormat& format) {
  add_choice<OutputFormat>(app, "--format", format, kFormats, "How results are printed (default text)");
}

CLI::Option* add_ignored(CLI::App& app, std::vector<std::string>& codes) {
  return app.add_option("--ignore", codes, "A warning or note that does not count; may be repeated")
      ->type_name("CODE")
      ->allow_extra_args(false);
}

tl::expected<void, ToolError> check_ignored(const std::vector<std::string>& codes, const std::string& who) {
  for (const std::string& code : codes) {
    if (!validate::may_ignore(code))
      return usage(fmt::format("{}: '{}' is no warning or note; 'coif validate --list-codes' lists them", who, code));
  }
  return {};
}

CLI::Option* add_roots(CLI::App& app, std::vector<std::filesystem::path>& roots) {
  return app
      .add_option("--root", roots,
                  "Files that a source names may lie in this folder, too, as where links lead; once for each folder")
      ->type_name("DIR")
      ->allow_extra_args(false)
      ->check(CLI::Validator(CLI::ExistingDirectory).description(""));
}

CLI::Option* add_size(CLI::App& app, PixelSize& size) {
  const auto parse = [&size](const std::string& text) {
    const auto pair = parse_pair<std::uint32_t>(text, 'x');
    if (!pair || !is_drawable(pair->first) || !is_drawable(pair->second)) {
      throw CLI::ValidationError("--size",
                                 fmt::format("'{}' is not WIDTHxHEIGHT within 16 .. 8192, for example 1024x768", text));
    }
    size = {pair->first, pair->second};
  };
  return app
      .add_option_function<std::string>("--size", parse, fmt::format("Pixels (default {}x{})", size.width, size.height))
      ->type_name("WxH");
}

CLI::Option* add_solver(CLI::App& app, const Solver*& solver) {
  static constexpr Choice<const Solver*> kSolvers[] = {
      {"coif", &kCoifSolver}, {"cascade", &kCascadeSolver}, {"passive", &kPassiveSolver}, {"thesis", &kThesisSolver}};
  return add_choice<const Solver*>(app, "--solver", solver, kSolvers, "Which method moves the bones");
}

CLI::Option* add_wind(CLI::App& app, Vec3& wind) {
  const auto parse = [&wind](const std::string& text) {
    constexpr float kStrongest = 1000;
    const auto numbers = parse_numbers<float>(text);
    const auto is_wind = [](float v) { return std::abs(v) <= kStrongest; };
    if (!numbers || numbers->size() != 3 || !std::ranges::all_of(*numbers, is_wind)) {
      throw CLI::ValidationError("--wind",
                                 fmt::format("'{}' is not X,Y,Z in metres per second, each -1000 to 1000", text));
    }
    wind = {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
  };
  return app
      .add_option_function<std::string>("--wind", parse,
                                        "Velocity of the air, m/s: +X to the model's left, +Y up, +Z forwards")
      ->type_name("X,Y,Z");
}

CLI::Option* add_gusts(CLI::App& app, GustOptions& gusts) {
  const auto parse = [&gusts](const std::string& text) {
    const std::vector<float> numbers = parse_numbers<float>(text).value_or(std::vector<float>{});
    const auto is_within = [&](std::size_t i, float least, float most) {
      return i >= numbers.size() || (numbers[i] >= least && numbers[i] <= most);
    };
    if (numbers.empty() || numbers.size() > 3 || !is_within(0, 0, kMostGust) ||
        !is_within(1, kShortestGust, kLongestGust) || !is_within(2, 0, kMostGust)) {
      throw CLI::ValidationError(
          "--gusts", fmt::format("'{}' is not AMPLITUDE[,LENGTH[,SPEED]]: 0 to {} m/s, {} to {} m, 0 to {} m/s", text,
                                 kMostGust, kShortestGust, kLongestGust, kMostGust));
    }
    gusts.amplitude = numbers[0];
    if (numbers.size() > 1) gusts.length = numbers[1];
    if (numbers.size() > 2) gusts.speed = numbers[2];
  };
  return app
      .add_option_function<std::string>(
          "--gusts", parse,
          "Gusts on top of the wind: the strongest in m/s, how long in metres (default: 1.5), how fast they run in m/s "
          "(default: with the wind, or 3)")
      ->type_name("AMPLITUDE[,LENGTH[,SPEED]]");
}

Gusts gusts_in(const Vec3& wind, const GustOptions& options) {
  Gusts gusts;
  gusts.amplitude = options.amplitude;
  const float blows = std::hypot(wind.x, wind.y, wind.z);
  if (blows > 0) gusts.direction = wind;
  if (blows > 0) gusts.speed = std::min(blows, kMostGust);
  gusts.length = options.length.value_or(gusts.length);
  gusts.speed = options.speed.value_or(gusts.speed);
  return gusts;
}

CLI::Option* add_view(CLI::App& app, ViewAngles& view) {
  const auto parse = [&view](const std::string& text) {
    const auto pair = parse_pair<double>(text, ',');
    if (!pair || !std::isfinite(pair->first) || !(std::abs(pair->second) <= 89)) {
      throw CLI::ValidationError(
          "--view",
          fmt::format("'{}' is not YAW,PITCH in degrees with the pitch within -89 .. 89, for example 30,5", text));
    }
    view = {pair->first, pair->second};
  };
  return app
      .add_option_function<std::string>(
          "--view", parse, "Degrees: 0,0 from the front, yaw towards the model's left, pitch from above (default 30,5)")
      ->type_name("YAW,PITCH");
}

std::optional<ClipChoice> find_clip(std::string_view word) {
  if (word.find_first_of("./") == std::string_view::npos) return std::nullopt;
  const std::size_t colon = word.find(':');
  if (colon == std::string_view::npos) return ClipChoice{word, ""};
  return ClipChoice{word.substr(0, colon), std::string(word.substr(colon + 1))};
}

tl::expected<HeadClip, ToolError> open_clip(const ClipChoice& choice, const Messages& messages) {
  const auto clip = importer::read_clip(choice.file, choice.node);
  if (!clip) return tl::unexpected(clip.error());
  for (const std::string& note : clip->notes) messages.note(note);
  std::vector<motion::ClipKey> keys;
  keys.reserve(clip->keys.size());
  for (const importer::NodeKey& key : clip->keys) keys.push_back({key.seconds, key.position, key.rotation});
  std::shared_ptr<const motion::HeadPath> path = motion::path_of(keys);
  if (path) {
    return HeadClip{printable_text(choice.file.filename().string()) + ":" + clip->node, std::move(path),
                    std::move(keys)};
  }
  return tl::unexpected(ToolError{ToolError::Kind::kInternal, choice.file.string() + ": read keys make no path"});
}

CLI::Option* add_motion(CLI::App& app, HeadMotion& motion, const std::string& help) {
  std::vector<std::string> names;
  for (const motion::MotionInfo& info : motion::all_motions()) names.emplace_back(info.name);
  const std::string list = fmt::format("{}", fmt::join(names, ", "));
  const auto parse = [&motion, list](const std::string& word) {
    if (const auto built_in = motion::find_motion(word)) {
      motion = {*built_in};
    } else if (const auto clip = find_clip(word)) {
      motion.clip = clip;
    } else {
      throw CLI::ValidationError("--motion", fmt::format("'{}' is not one of {}, and no file", word, list));
    }
  };
  return app
      .add_option_function<std::string>("--motion", parse,
                                        fmt::format("{}: {}, or a node's animation in a glTF", help, list))
      ->type_name("NAME|CLIP[:NODE]");
}

void add_recording(CLI::App& app, animation::RecordingSettings& recording, const std::string& what) {
  add_number(app, "--fps", recording.fps, 10.0, 1000.0, "Steps and frames per second");
  add_number(app, "--seconds", recording.seconds, 0.0, 3600.0, "Length of " + what);
}

std::string motion_help() {
  std::string text = "Motions:\n";
  for (const motion::MotionInfo& info : motion::all_motions())
    text += fmt::format("  {:<10}{}\n", info.name, info.description);
  return text;
}

}  // namespace coif::cli
