#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace coif::render {

/// How a picture shows light that a screen cannot: radiance (linear, 0 or more) -> 0..1. What is darker than three
/// quarters of white stays as it is; above that the brightest channel nears white without reaching it, and the others
/// keep their ratio to it, so that highlights keep their hue and their form.
void apply_tone_curve(std::span<float, 3> radiance);

/// Pixels of a picture from `oversampling` times as many each way: RGBA, linear, rows top to bottom, `width` * `height`
/// blocks of them -> sRGB. Each sample gets its tone first, so that an edge before a highlight is as smooth as any.
[[nodiscard]] std::vector<std::uint8_t> develop(std::span<const float> samples, std::uint32_t width,
                                                std::uint32_t height, std::uint32_t oversampling);

}  // namespace coif::render
