#include "cli/verb_options.h"

#include "cli/options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace coif::cli {

CLI::Option* add_attitude(CLI::App& app, std::optional<Eigen::Vector3d>& attitude) {
  const auto parse = [&attitude](const std::string& text) {
    constexpr double kFarthest = 1000;
    const auto numbers = parse_numbers<double>(text);
    const auto is_near = [](double v) { return std::abs(v) <= kFarthest; };
    if (!numbers || numbers->size() != 3 || !std::ranges::all_of(*numbers, is_near) ||
        Eigen::Vector3d(numbers->data()).norm() < 1e-3) {
      throw CLI::ValidationError(
          "--attitude", fmt::format("'{}' is not X,Y,Z, a direction, for example 1,0,0 for a head on its side", text));
    }
    attitude = Eigen::Vector3d(numbers->data());
  };
  return app
      .add_option_function<std::string>(
          "--attitude", parse,
          fmt::format(
              "Instead of a motion: within {:g} s the head turns, by the shortest way, until its up axis points in "
              "this direction, and stays there",
              motion::kAttitudeSeconds))
      ->type_name("X,Y,Z");
}

CLI::Option* add_scale(CLI::App& app, float& scale) {
  return add_number(app, "--scale", scale, kSmallestScale, kLargestScale,
                    "Size of the head against the asset's; what the head does stays in metres of the world");
}

namespace {

void add_lengths(CLI::App& app, animation::FrameLengths& lengths) {
  const auto parse = [&lengths](const std::string& text) {
    const auto numbers = parse_numbers<double>(text);
    const auto is_length = [](double s) { return s >= animation::kShortestFrame && s <= animation::kLongestFrame; };
    if (!numbers || !std::ranges::all_of(*numbers, is_length)) {
      throw CLI::ValidationError("--frame-lengths",
                                 fmt::format("'{}' is not a list of seconds, {:g} to {:g} each", text,
                                             animation::kShortestFrame, animation::kLongestFrame));
    }
    lengths.seconds = *numbers;
  };
  app.add_option_function<std::string>("--frame-lengths", parse,
                                       "Seconds that frames take, by turns, in place of --fps; for example "
                                       "0.016,0.033,0.008")
      ->type_name("S[,S...]")
      ->excludes("--fps");
}

void add_jitter(CLI::App& app, animation::FrameLengths& lengths) {
  const auto parse = [&lengths](const std::string& text) {
    const std::string_view word = text;
    const std::size_t comma = std::min(word.find(','), word.size());
    const auto share = parse_number<double>(word.substr(0, comma));
    const auto seed = comma == word.size() ? lengths.seed : parse_number<std::uint32_t>(word.substr(comma + 1));
    if (!share || !(*share >= 0 && *share <= animation::kMostJitter) || !seed) {
      throw CLI::ValidationError("--jitter", fmt::format("'{}' is not SHARE[,SEED]: 0 to {:g}, and a whole number",
                                                         text, animation::kMostJitter));
    }
    lengths.jitter = *share;
    lengths.seed = *seed;
  };
  app.add_option_function<std::string>(
         "--jitter", parse,
         fmt::format("Each frame takes longer or shorter by up to this share of its length, at random; the same SEED "
                     "(default {}) gives the same frames",
                     lengths.seed))
      ->type_name("SHARE[,SEED]");
}

}  // namespace

void add_frame_lengths(CLI::App& app, animation::FrameLengths& lengths) {
  add_lengths(app, lengths);
  add_jitter(app, lengths);
}

std::string pace_text(const animation::RecordingSettings& recording) {
  const animation::FrameLengths& lengths = recording.lengths;
  std::string text = fmt::format("{} per second", recording.fps);
  if (!lengths.seconds.empty()) text = fmt::format("{:g} seconds by turns", fmt::join(lengths.seconds, ", "));
  if (lengths.jitter > 0) text += fmt::format(", each up to {:g} % off (seed {})", 100 * lengths.jitter, lengths.seed);
  return text;
}

}  // namespace coif::cli
