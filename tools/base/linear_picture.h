#pragma once

#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace coif {

/// Light rather than what a screen shows: linear, more than white too.
struct LinearPicture {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<float> rgba;  ///< Rows top to bottom; colours are premultiplied with alpha, which is coverage.
};

/// A picture with a `factor`th of the pixels each way, each the mean of those it replaces; what is left over at the
/// right and below is cut off.
[[nodiscard]] LinearPicture reduced(const LinearPicture& picture, std::uint32_t factor);

/// OpenEXR, 16-bit floats: what other renderers and picture editors read.
[[nodiscard]] tl::expected<std::vector<std::byte>, std::string> encode_exr(const LinearPicture& picture);

/// OpenEXR with one part, channels R, G, B and perhaps A (1 where it is missing), at most 8192 pixels each way. The
/// error is what is wrong with it, a part of a sentence.
[[nodiscard]] tl::expected<LinearPicture, std::string> decode_exr(std::span<const std::byte> bytes);

}  // namespace coif
