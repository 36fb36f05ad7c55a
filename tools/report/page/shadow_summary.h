#pragma once

#include "report/shadow_report.h"

#include <string>

namespace coif {

/// "deep, 4 layers, 512".
[[nodiscard]] std::string technique_text(const std::string& technique, std::uint32_t layers, std::uint32_t size);

/// Which technique is nearest to the truth, and which costs least within half as much again, in a sentence.
[[nodiscard]] std::string shadow_summary(const ShadowReport& report);

/// What was compared with what, in a sentence.
[[nodiscard]] std::string shadow_method(const ShadowReport& report);

}  // namespace coif
