#pragma once

#include "report/shadow/measure_shadows.h"
#include "report/shadow/shadow_report.h"

#include <span>
#include <vector>

namespace coif {

/// `light`: one per point, what a technique says. Over the points of the head, or of the hair.
[[nodiscard]] ShadowError shadow_error(std::span<const ShadowPoint> points, std::span<const float> light, bool of_head);

/// Each technique over its rows, which count alike: the root of the mean of squared errors, the mean of biases. Bytes are 0.
[[nodiscard]] std::vector<ShadowTotal> shadow_totals(std::span<const ShadowRow> rows);

}  // namespace coif
