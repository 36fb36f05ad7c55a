#pragma once
// Images that tests paint, as files of every format, and a folder of their own to find them in.

#include "cook/texture/image.h"

#include <Eigen/Core>

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace coif::cook {

using Rgba = std::array<std::uint8_t, 4>;

[[nodiscard]] Image painted(std::uint32_t width, std::uint32_t height,
                            const std::function<Rgba(std::uint32_t x, std::uint32_t y)>& texel);
[[nodiscard]] Image flat(std::uint32_t width, std::uint32_t height, Rgba color);

/// The RGBA texel that holds a texture coordinate; the image repeats.
[[nodiscard]] Rgba texel_at(const Image& image, const Eigen::Vector2f& uv);

/// Largest difference in any channel.
[[nodiscard]] int difference(const Rgba& a, const Rgba& b);

enum class FileFormat { kPng, kTga, kJpeg, kBmp };

/// The file's bytes. Takes RGBA; JPEG keeps no alpha and not every value.
[[nodiscard]] std::vector<std::uint8_t> encoded(const Image& image, FileFormat format);

/// An empty folder "source" for a model and its images, in a folder of its own that is removed with everything in it.
class ImageFolder {
 public:
  ImageFolder();
  ~ImageFolder();
  ImageFolder(const ImageFolder&) = delete;
  ImageFolder& operator=(const ImageFolder&) = delete;

  /// Where the model would be; nothing there is ever read but images.
  [[nodiscard]] std::filesystem::path source(const std::string& name = "wig.fbx") const { return path_ / name; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// Writes a file, and the folders above it; `name` is relative to path(). Returns its path.
  std::filesystem::path write(const std::string& name, std::span<const std::uint8_t> bytes) const;
  /// A PNG of one colour, whatever the suffix: what is found does not depend on it.
  std::filesystem::path write_flat(const std::string& name, Rgba color = {200, 100, 50, 255}) const;

 private:
  std::filesystem::path path_;
};

}  // namespace coif::cook
