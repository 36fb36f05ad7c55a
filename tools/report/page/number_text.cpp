#include "report/page/number_text.h"

#include <fmt/format.h>

#include <cmath>

namespace coif {

std::string number_text(double number) {
  if (!std::isfinite(number)) return "-";
  const double size = std::abs(number);
  if (size == 0) return "0";
  if (size < 1.0e-4) return "<0.0001";
  if (size >= 1.0e6 || size < 1.0e-3) return fmt::format("{:.1e}", number);
  if (size >= 100) return fmt::format("{:.0f}", number);
  if (size >= 10) return fmt::format("{:.1f}", number);
  if (size >= 1) return fmt::format("{:.2f}", number);
  return size >= 0.1 ? fmt::format("{:.3f}", number) : fmt::format("{:.4f}", number);
}

std::string percent_text(double percent) {
  return std::isfinite(percent) ? number_text(percent) + " %" : number_text(percent);
}

nlohmann::ordered_json number_json(double number) {
  return std::isfinite(number) ? nlohmann::ordered_json(number) : nlohmann::ordered_json(nullptr);
}

}  // namespace coif
