#pragma once

#include "base/diagnostic.h"
#include "cook/recipe/decision.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace coif::cook {

/// Something that is not in the asset.
struct LeftOut {
  std::string what;         ///< The thing, with its number, name or place.
  std::string why;          ///< The rule, or the recipe's key.
  std::uint64_t bytes = 0;  ///< Bytes that it would take in the asset; 0 for things that no asset has, such as a body.
  std::uint64_t bytes_per_head = 0;  ///< Bytes of the runtime's memory that it would take for each head of a crowd.
  double ns_per_frame = 0;  ///< Nominal nanoseconds per head that it would have cost; 0 where it would have cost none.

  /// "what: why (12 bytes, 40 bytes a head, 175 ns a frame)"; zero values are left out.
  [[nodiscard]] std::string text() const;
};

/// The messages of all passes, each list in the order in which they ran.
struct Findings {
  std::vector<std::string> notes;   ///< Choices, and the reasons for them.
  Diagnostics warnings;             ///< Things that the artist may not have intended.
  std::vector<LeftOut> left_out;    ///< Parts of the source that are not in the asset, and why.
  std::vector<Decision> decisions;  ///< Where nobody said it; also among the notes, or the warnings if in doubt.

  void note(std::string text) { notes.push_back(std::move(text)); }
  void warn(const char* code, std::string text) { warnings.emplace_back(code, std::move(text)); }
  /// Notes a decision, or warns where it is in doubt.
  void decide(Decision decision);
  /// The first decision that is so much in doubt that the cook should ask; null: none. One whose code is in
  /// `acknowledged` is meant.
  [[nodiscard]] const Decision* question(std::span<const std::string> acknowledged) const;
  /// Notes a decision whose doubts have warnings of their own.
  void say(Decision decision);
  /// Warnings of these codes become notes: somebody has seen them, and means it.
  void acknowledge(std::span<const std::string> codes);
  void leave_out(LeftOut part) { left_out.push_back(std::move(part)); }

  /// Appends later findings to these.
  void append(const Findings& later);
};

/// Nominal nanoseconds per head and frame of this many simulated bones without twist, with a step in this many parts. A
/// fixed figure, so that another cook gives the same bytes.
[[nodiscard]] double nominal_cost(std::size_t bones, std::uint32_t parts);
/// Nanoseconds that the passive model adds.
[[nodiscard]] double nominal_passive_cost(std::size_t bones, std::uint32_t parts);
/// Nanoseconds that a twist adds, for the bones that carry one.
[[nodiscard]] double nominal_twist_cost(std::size_t bones, std::uint32_t parts);

}  // namespace coif::cook
