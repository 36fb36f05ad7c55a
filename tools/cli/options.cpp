#include "cli/options.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace coif {
namespace {

constexpr Choice<OutputFormat> kFormats[] = {{"text", OutputFormat::kText}, {"json", OutputFormat::kJson}};

template <typename Number>
std::optional<Number> parse_number(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

template <typename Number>
std::optional<std::pair<Number, Number>> parse_pair(std::string_view text, char separator) {
  const std::size_t split = text.find(separator);
  if (split == std::string_view::npos) return std::nullopt;
  const auto first = parse_number<Number>(text.substr(0, split));
  const auto second = parse_number<Number>(text.substr(split + 1));
  if (!first || !second) return std::nullopt;
  return std::pair{*first, *second};
}

bool is_drawable(std::uint32_t pixels) { return pixels >= 16 && pixels <= 8192; }

}  // namespace

void add_format(CLI::App& app, OutputFormat& format) {
  add_choice<OutputFormat>(app, "--format", format, kFormats, "How results are printed (default text)");
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

}  // namespace coif
