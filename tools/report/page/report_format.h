#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace coif::report {

/// The format of a value in a terminal and on the page (script/format.mjs has the same rules).
///
/// A pattern is text around one place for the value:
/// - {} all digits of a count, text unchanged, a list's values one after the other
/// - {number}, {percent}, {time} of nanoseconds, {bytes}: as number_text() and its neighbours in base/text.h
/// - {:.2f}, {:+.0f}: this many digits behind the point, with a sign for positive numbers too
/// - "yes|no", without a place: the words for true and false
class Format {
 public:
  Format() = default;
  /// `missing`: text for a number that does not exist. `scale`: factor on the value.
  Format(const char* value_pattern, std::string missing_text = "-", double value_scale = 1)
      : pattern(value_pattern), missing(std::move(missing_text)), scale(value_scale) {}

  [[nodiscard]] std::string text(const nlohmann::ordered_json& value) const;

  /// With rules for the colour of the cell on the page: a list of {"look": "good", "neutral", "warning" or "bad"}, each
  /// with "least", "most" or "is". The first that fits counts, and one without any of them always fits.
  [[nodiscard]] Format colored(nlohmann::ordered_json rules) const;

  std::string pattern;  ///< Empty: as the value's type suggests.
  std::string missing = "-";
  double scale = 1;
  nlohmann::ordered_json looks;
};

/// time_text() of microseconds and of milliseconds; its pattern "{time}" is of nanoseconds.
[[nodiscard]] std::string microseconds_text(double us);
[[nodiscard]] std::string milliseconds_text(double ms);

/// Common formats.
[[nodiscard]] inline Format us_format() { return {"{time}", "-", 1e3}; }
[[nodiscard]] inline Format ms_format(std::string missing = "-") { return {"{time}", std::move(missing), 1e6}; }

/// Half the width of the middle half of samples, which the value is, in % of their median; coloured where the machine
/// was not steady: samples that differ by a quarter are of one that had other work.
[[nodiscard]] Format half_spread();

}  // namespace coif::report
