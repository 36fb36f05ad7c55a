#include "render/picture.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

namespace coif {

std::vector<std::uint8_t> encode_png(const Picture& picture) {
  const auto append = [](void* context, void* data, int size) {
    const auto* bytes = static_cast<const std::uint8_t*>(data);
    static_cast<std::vector<std::uint8_t>*>(context)->insert(
        static_cast<std::vector<std::uint8_t>*>(context)->end(), bytes, bytes + size);
  };
  std::vector<std::uint8_t> png;
  const int width = static_cast<int>(picture.width);
  const int height = static_cast<int>(picture.height);
  const int written = stbi_write_png_to_func(append, &png, width, height, 4, picture.rgba.data(), 4 * width);
  if (written == 0) png.clear();
  return png;
}

}  // namespace coif
