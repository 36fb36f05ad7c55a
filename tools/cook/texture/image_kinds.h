#pragma once

#include "cook/texture/image.h"

namespace coif::cook {

/// "a KTX2 image, which is not read; make a PNG of it: ...", with the command that does; empty where the bytes begin
/// like no kind of image that artists have and that is not read.
[[nodiscard]] std::string foreign_kind(std::span<const std::uint8_t> bytes);

[[nodiscard]] bool is_webp(std::span<const std::uint8_t> bytes);

/// In this process, as decode_texels(). Its size is checked before memory is asked for.
tl::expected<Image, std::string> decode_webp(std::span<const std::uint8_t> bytes);

/// What is wrong with an image's size, a sentence; empty: nothing.
[[nodiscard]] std::string size_fault(int width, int height);

}  // namespace coif::cook
