#pragma once

#include "report/accuracy_report.h"

#include <string>

namespace coif {

/// What to use and what it costs, in sentences for who sets up hair and has never heard of an integrator.
[[nodiscard]] std::string accuracy_summary(const AccuracyReport& report);

/// How far the reference can be trusted, as a sentence.
[[nodiscard]] std::string reference_summary(const AccuracyReport& report);

}  // namespace coif
