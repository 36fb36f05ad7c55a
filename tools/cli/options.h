#pragma once

// Options that several commands share, and the types of values that CLI11 does not know.

#include "animation/recording.h"
#include "base/tool_error.h"
#include "cli/messages.h"
#include "motion/head_path.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>
#include <tl/expected.hpp>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace coif::cli {

enum class OutputFormat { kText, kJson };

/// --format text|json
void add_format(CLI::App& app, OutputFormat& format);

/// A word of the command line and its value.
template <typename Value>
struct Choice {
  const char* name;
  Value value;
};

/// Choices among named things; each name stands for its thing.
template <typename Named>
[[nodiscard]] std::vector<Choice<const char*>> name_choices(std::span<const Named> things) {
  std::vector<Choice<const char*>> choices;
  for (const Named& thing : things) choices.push_back({thing.name, thing.name});
  return choices;
}

/// An option that takes one of the words in `choices`; any other is a usage error that lists them. `value` and
/// `choices` must outlive the parsing.
template <typename Value>
CLI::Option* add_choice(CLI::App& app, const std::string& name, Value& value, std::span<const Choice<Value>> choices,
                        const std::string& help) {
  std::vector<std::string> names;
  for (const auto& choice : choices) names.emplace_back(choice.name);
  const std::string list = fmt::format("{}", fmt::join(names, ", "));
  const auto parse = [&value, choices, name, list](const std::string& word) {
    for (const auto& choice : choices) {
      if (word == choice.name) {
        value = choice.value;
        return;
      }
    }
    throw CLI::ValidationError(name, fmt::format("'{}' is not one of {}", word, list));
  };
  return app.add_option_function<std::string>(name, parse, fmt::format("{}: {}", help, list))->type_name("NAME");
}

/// An option that takes a number within `low` .. `high`, which help shows with the default.
template <typename Number, typename Limit>
CLI::Option* add_number(CLI::App& app, const std::string& name, Number& value, Limit low, Limit high,
                        const std::string& help) {
  return app.add_option(name, value, help)->check(CLI::Range(low, high))->capture_default_str();
}

/// Parses the whole text as a number.
template <typename Number>
std::optional<Number> parse_number(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// Two numbers with `separator` between them and nothing else.
template <typename Number>
std::optional<std::pair<Number, Number>> parse_pair(std::string_view text, char separator) {
  const std::size_t split = text.find(separator);
  if (split == std::string_view::npos) return std::nullopt;
  const auto first = parse_number<Number>(text.substr(0, split));
  const auto second = parse_number<Number>(text.substr(split + 1));
  if (!first || !second) return std::nullopt;
  return std::pair{*first, *second};
}

/// Parses numbers separated by commas; none where one of them is not a number.
template <typename Number>
std::optional<std::vector<Number>> parse_numbers(std::string_view text) {
  std::vector<Number> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const auto number = parse_number<Number>(text.substr(begin, end - begin));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
    begin = end + 1;
  }
  return numbers;
}

struct PixelSize {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
};

/// --ignore CODE, any number.
CLI::Option* add_ignored(CLI::App& app, std::vector<std::string>& codes);

/// Error (kUsage): a code is not that of a warning or note. `who`: the option that names them.
[[nodiscard]] tl::expected<void, ToolError> check_ignored(const std::vector<std::string>& codes,
                                                          const std::string& who);

/// --root DIR, any number: ImportSettings::roots.
CLI::Option* add_roots(CLI::App& app, std::vector<std::filesystem::path>& roots);

/// WIDTHxHEIGHT, 16..8192 each; `size` holds the default.
CLI::Option* add_size(CLI::App& app, PixelSize& size);

/// --solver coif|thesis
CLI::Option* add_solver(CLI::App& app, const Solver*& solver);

/// --wind X,Y,Z: velocity of the air in m/s, world axes, at most 1000.
CLI::Option* add_wind(CLI::App& app, Vec3& wind);

/// The options of --gusts; those left out follow the wind.
struct GustOptions {
  float amplitude = 0;
  std::optional<float> length, speed;
};

/// --gusts AMPLITUDE[,LENGTH[,SPEED]] in the ranges of Gusts.
CLI::Option* add_gusts(CLI::App& app, GustOptions& gusts);

/// By default gusts move with the wind, at its speed, if there is any.
[[nodiscard]] Gusts gusts_in(const Vec3& wind, const GustOptions& options);

struct ViewAngles {
  double yaw_degrees = 0;
  double pitch_degrees = 0;
};

/// YAW,PITCH in degrees; pitch within -89 .. 89.
CLI::Option* add_view(CLI::App& app, ViewAngles& view);

/// An animated node of a model file, as people name it: CLIP or CLIP:NODE.
struct ClipChoice {
  std::filesystem::path file;
  std::string node;  ///< Empty: the file's only animated node.
};

/// None for a word that is no file's name. The first colon ends the file's name: nodes have colons in theirs too.
[[nodiscard]] std::optional<ClipChoice> find_clip(std::string_view word);

/// A clip as a movement of the head.
struct HeadClip {
  std::string name;                              ///< "walk.glb:head", printable.
  std::shared_ptr<const motion::HeadPath> path;  ///< Not null.
  std::vector<motion::ClipKey> keys;             ///< The clip's keys.
};

/// Reads the clip; `messages` gets deviations from the file. Errors: as read_clip().
[[nodiscard]] tl::expected<HeadClip, ToolError> open_clip(const ClipChoice& choice, const Messages& messages);

/// A built-in motion or a clip.
struct HeadMotion {
  motion::Motion motion = motion::Motion::kStill;
  std::optional<ClipChoice> clip{};  ///< Instead of `motion`.
};

/// The file of the clip; empty where there is none.
[[nodiscard]] inline std::filesystem::path clip_file(const HeadMotion& motion) {
  return motion.clip ? motion.clip->file : std::filesystem::path();
}

/// --motion NAME|CLIP[:NODE]; `motion` must outlive the parsing.
CLI::Option* add_motion(CLI::App& app, HeadMotion& motion, const std::string& help);

/// --fps and --seconds; `what`: the thing that is recorded.
void add_recording(CLI::App& app, animation::RecordingSettings& recording, const std::string& what);

/// A paragraph with each motion and its figures, for --help.
[[nodiscard]] std::string motion_help();

}  // namespace coif::cli
