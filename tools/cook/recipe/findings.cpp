#include "cook/recipe/findings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace coif::cook {

std::string LeftOut::text() const {
  std::vector<std::string> savings;
  if (bytes > 0) savings.push_back(fmt::format("{} bytes", bytes));
  if (bytes_per_head > 0) savings.push_back(fmt::format("{} bytes a head", bytes_per_head));
  if (ns_per_frame > 0) savings.push_back(fmt::format("{:.0f} ns a frame", ns_per_frame));
  return fmt::format("{}: {}{}", what, why, savings.empty() ? "" : fmt::format(" ({})", fmt::join(savings, ", ")));
}

void Findings::decide(Decision decision) {
  if (decision.probability >= kSureEnough) return say(std::move(decision));
  warn(code_of_doubt(decision), decision.doubt());
  decisions.push_back(std::move(decision));
}

void Findings::say(Decision decision) {
  note(decision.text());
  decisions.push_back(std::move(decision));
}

const Decision* Findings::question(std::span<const std::string> acknowledged) const {
  const auto found = std::ranges::find_if(decisions, [&](const Decision& decision) {
    return decision.asks() && std::ranges::find(acknowledged, code_of_doubt(decision)) == acknowledged.end();
  });
  return found == decisions.end() ? nullptr : &*found;
}

void Findings::append(const Findings& later) {
  notes.insert(notes.end(), later.notes.begin(), later.notes.end());
  warnings.insert(warnings.end(), later.warnings.begin(), later.warnings.end());
  left_out.insert(left_out.end(), later.left_out.begin(), later.left_out.end());
  decisions.insert(decisions.end(), later.decisions.begin(), later.decisions.end());
}

void Findings::acknowledge(std::span<const std::string> codes) {
  const auto is_known = [&](const Diagnostic& warning) {
    return std::ranges::find(codes, warning.code) != codes.end();
  };
  for (const Diagnostic& warning : warnings) {
    if (is_known(warning)) note(fmt::format("acknowledged: {} [{}]", warning.message, warning.code));
  }
  std::erase_if(warnings, is_known);
}

namespace {

/// Nanoseconds per bone on a single core: per frame (matrices, the head's path), per part of its step, for a twist in
/// each part, and for what the passive model adds; scalar, on a 2.1 GHz server core. A yardstick, not a promise: it
/// never changes, so that budgets and bytes stay the same.
constexpr double kFrameCost = 45, kPartCost = 105, kTwistCost = 25, kPassiveCost = 155;

}  // namespace

double nominal_cost(std::size_t bones, std::uint32_t parts) { return double(bones) * (kFrameCost + kPartCost * parts); }

double nominal_passive_cost(std::size_t bones, std::uint32_t parts) { return double(bones) * kPassiveCost * parts; }

double nominal_twist_cost(std::size_t bones, std::uint32_t parts) { return double(bones) * kTwistCost * parts; }

}  // namespace coif::cook
