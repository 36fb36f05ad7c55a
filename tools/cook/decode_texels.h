#pragma once

#include "cook/image.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <span>
#include <string>

namespace coif {

/// decode_image() in this process: what a hostile image breaks, it breaks here. Dimensions are read and checked first, and no
/// single block of memory that decoding asks for is larger than an image within the limits of image.h needs.
tl::expected<Image, std::string> decode_texels(std::span<const std::uint8_t> bytes);

}  // namespace coif
