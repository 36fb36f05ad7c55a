#pragma once

#include "base/tool_error.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace coif::cook {

/// Something that is not in the asset.
struct LeftOut {
  std::string what;                  ///< With its number, name or place.
  std::string why;                   ///< The rule, or the recipe's key.
  std::uint64_t bytes = 0;           ///< That the asset would have for it; 0 for what no asset has, such as a body.
  std::uint64_t bytes_per_head = 0;  ///< Of the runtime's memory that each head of a crowd would take for it.
  double ns_per_frame = 0;  ///< Nominal nanoseconds per head that it would have cost; 0 where it would have cost none.

  /// "what: why (12 bytes, 40 bytes a head, 175 ns a frame)", without what is 0.
  [[nodiscard]] std::string text() const;
};

/// What passes have to say: the one place that all of them write to, each list in the order in which they ran.
struct Findings {
  std::vector<std::string> notes;  ///< What was chosen, and why.
  std::vector<Warning> warnings;   ///< What the artist may not have meant.
  std::vector<LeftOut> left_out;   ///< What of the source is not in the asset, and why.

  void note(std::string text) { notes.push_back(std::move(text)); }
  void warn(const char* code, std::string text) { warnings.emplace_back(code, std::move(text)); }
  /// Warnings of these codes become notes: somebody has seen them, and means it.
  void acknowledge(std::span<const std::string> codes);
  void leave_out(LeftOut part) { left_out.push_back(std::move(part)); }

  /// What was found meanwhile comes behind what is here.
  void append(const Findings& later);
};

/// Nominal nanoseconds per head and frame of so many simulated bones without twist, with a step in so many parts: a
/// fixed figure, so that cooking again gives the same bytes.
[[nodiscard]] double nominal_cost(std::size_t bones, std::uint32_t parts);
/// What the passive model adds to that.
[[nodiscard]] double nominal_passive_cost(std::size_t bones, std::uint32_t parts);
/// What a twist adds to that for each bone that carries one.
[[nodiscard]] double nominal_twist_cost(std::size_t bones, std::uint32_t parts);

}  // namespace coif::cook
