#pragma once
// What the processor that this runs on can do at most. One thread; best of many short runs, so that other programs do
// not count.

#include <cstddef>

namespace coif {

/// Width of a vector register that the processor has; 4 floats where it has no other.
enum class VectorWidth : int { k4 = 4, k8 = 8, k16 = 16 };

[[nodiscard]] bool has_width(VectorWidth width);

/// Instructions that do nothing, per nanosecond: as many as the processor takes in. 0 where this is not known how to
/// ask.
[[nodiscard]] double peak_instructions();

/// Vector multiplications and additions per nanosecond, half of them each, none of them fused or waiting for another.
[[nodiscard]] double peak_arithmetic(VectorWidth width);

/// Vector divisions per nanosecond. Square roots take about as long.
[[nodiscard]] double peak_divisions(VectorWidth width);

/// Bytes per nanosecond of a = b + s * c over arrays of `bytes` in all: two parts read, one written.
[[nodiscard]] double peak_traffic(std::size_t bytes);

}  // namespace coif
