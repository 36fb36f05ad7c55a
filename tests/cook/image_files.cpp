#include "cook/image_files.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace coif::cook {
namespace {

namespace fs = std::filesystem;

constexpr int kJpegQuality = 95;

void append_bytes(void* context, void* data, int size) {
  const auto* bytes = static_cast<const std::uint8_t*>(data);
  auto& out = *static_cast<std::vector<std::uint8_t>*>(context);
  out.insert(out.end(), bytes, bytes + size);
}

std::uint32_t wrapped(float coordinate, std::uint32_t size) {
  return std::min(std::uint32_t((coordinate - std::floor(coordinate)) * float(size)), size - 1);
}

}  // namespace

Image painted(std::uint32_t width, std::uint32_t height,
              const std::function<Rgba(std::uint32_t, std::uint32_t)>& texel) {
  Image image{width, height, 4, {}};
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      const Rgba color = texel(x, y);
      image.texels.insert(image.texels.end(), color.begin(), color.end());
    }
  }
  return image;
}

Image flat(std::uint32_t width, std::uint32_t height, Rgba color) {
  return painted(width, height, [&](auto, auto) { return color; });
}

Rgba texel_at(const Image& image, const Eigen::Vector2f& uv) {
  const std::size_t index = std::size_t(wrapped(uv.y(), image.height)) * image.width + wrapped(uv.x(), image.width);
  Rgba color{};
  std::copy_n(&image.texels[4 * index], 4, color.begin());
  return color;
}

int difference(const Rgba& a, const Rgba& b) {
  int largest = 0;
  for (std::size_t i = 0; i < 4; ++i) largest = std::max(largest, std::abs(int(a[i]) - int(b[i])));
  return largest;
}

std::vector<std::uint8_t> encoded(const Image& image, FileFormat format) {
  std::vector<std::uint8_t> out;
  const int width = int(image.width), height = int(image.height);
  const std::uint8_t* texels = image.texels.data();
  switch (format) {
    case FileFormat::kPng: stbi_write_png_to_func(append_bytes, &out, width, height, 4, texels, 4 * width); break;
    case FileFormat::kTga: stbi_write_tga_to_func(append_bytes, &out, width, height, 4, texels); break;
    case FileFormat::kJpeg: stbi_write_jpg_to_func(append_bytes, &out, width, height, 4, texels, kJpegQuality); break;
    case FileFormat::kBmp: stbi_write_bmp_to_func(append_bytes, &out, width, height, 4, texels); break;
  }
  return out;
}

ImageFolder::ImageFolder() {
  std::string pattern = (fs::temp_directory_path() / "coif-images-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("cannot create " + pattern);
  path_ = fs::path(pattern) / "source";
  fs::create_directory(path_);
}

ImageFolder::~ImageFolder() {
  std::error_code ignored;
  fs::remove_all(path_.parent_path(), ignored);
}

fs::path ImageFolder::write(const std::string& name, std::span<const std::uint8_t> bytes) const {
  const fs::path path = path_ / name;
  fs::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
  return path;
}

fs::path ImageFolder::write_flat(const std::string& name, Rgba color) const {
  return write(name, encoded(flat(4, 4, color), FileFormat::kPng));
}

}  // namespace coif::cook
