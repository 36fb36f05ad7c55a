#include "report/page/shadow_summary.h"

#include "report/page/number_text.h"

#include <fmt/format.h>

#include <cmath>

namespace coif {
namespace {

constexpr double kNearly = 1.5;  // of the least error

bool is_map(const ShadowTotal& total) { return total.size > 0 && std::isfinite(total.hair.rmse); }

const ShadowTotal* find_best(const ShadowReport& report) {
  const ShadowTotal* best = nullptr;
  for (const ShadowTotal& total : report.totals) {
    if (is_map(total) && (best == nullptr || total.hair.rmse < best->hair.rmse)) best = &total;
  }
  return best;
}

/// By bytes, which are the same everywhere; times are not.
const ShadowTotal* find_small(const ShadowReport& report, double most) {
  const ShadowTotal* small = nullptr;
  for (const ShadowTotal& total : report.totals) {
    if (!is_map(total) || total.hair.rmse > most) continue;
    if (small == nullptr || total.bytes < small->bytes) small = &total;
  }
  return small;
}

std::string total_text(const ShadowTotal& total) {
  return fmt::format("{} (RMS {}, {} KiB, {} ms)", technique_text(total.technique, total.layers, total.size),
                     number_text(total.hair.rmse), total.bytes / 1024, number_text(total.ms));
}

}  // namespace

std::string technique_text(const std::string& technique, std::uint32_t layers, std::uint32_t size) {
  std::string text = technique;
  if (layers > 0) text += fmt::format(", {} layers", layers);
  if (size > 0) text += fmt::format(", {}", size);
  return text;
}

std::string shadow_summary(const ShadowReport& report) {
  const ShadowTotal* best = find_best(report);
  if (best == nullptr) return "There is no hair in the light: nothing was compared.";
  const ShadowTotal* small = find_small(report, kNearly * best->hair.rmse);
  std::string text = fmt::format("Nearest to the truth: {}.", total_text(*best));
  if (small != best) text += fmt::format(" The smallest that is nearly as good: {}.", total_text(*small));
  return text;
}

std::string shadow_method(const ShadowReport& report) {
  return fmt::format(
      "The share of a light that reaches a point, 0 to 1, at {} points of hair and {} of the head, under {} lights, "
      "against "
      "the product of 1 - alpha of all that lies between, along lines {:.1f} mm apart.",
      report.hair_points, report.head_points, report.lights.size(), 1000 * report.spacing);
}

}  // namespace coif
