// How far two pictures are apart: picture_difference A B BALD LEAST_DB
//
// PSNR over all pixels, and over those where A is not BALD, which is A without its hair. The exit code is 0 where the
// hair's is LEAST_DB or more, of at least a thousand pixels.

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_PNM
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

struct Pixels {
  explicit Pixels(const char* path) {
    unsigned char* const data = stbi_load(path, &width, &height, nullptr, 3);
    if (data == nullptr) {
      std::fprintf(stderr, "%s: %s\n", path, stbi_failure_reason());
      std::exit(2);
    }
    rgb.assign(data, data + 3 * width * height);
    stbi_image_free(data);
  }
  int width = 0, height = 0;
  std::vector<unsigned char> rgb;
};

struct Error {
  double squares = 0;
  long pixels = 0;

  void add(const unsigned char* a, const unsigned char* b) {
    for (int k = 0; k < 3; ++k) squares += double(a[k] - b[k]) * (a[k] - b[k]);
    ++pixels;
  }
  /// 99 where there is no difference.
  [[nodiscard]] double decibel() const {
    return squares == 0 ? 99 : std::fmin(99, 10 * std::log10(255.0 * 255 * 3 * double(pixels) / squares));
  }
};

}  // namespace

int main(int argument_count, char** arguments) {
  if (argument_count != 5) return std::fputs("usage: picture_difference A B BALD LEAST_DB\n", stderr), 2;
  const Pixels a(arguments[1]), b(arguments[2]), bald(arguments[3]);
  if (a.width != b.width || a.rgb.size() != b.rgb.size() || a.rgb.size() != bald.rgb.size()) {
    return std::fputs("pictures of different sizes\n", stderr), 2;
  }
  Error all, hair;
  for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
    const unsigned char *const one = &a.rgb[i], *const other = &b.rgb[i], *const behind = &bald.rgb[i];
    all.add(one, other);
    if (one[0] != behind[0] || one[1] != behind[1] || one[2] != behind[2]) hair.add(one, other);
  }
  std::printf("%.1f dB over %ld pixels of hair, %.1f dB over all\n", hair.decibel(), hair.pixels, all.decibel());
  const bool is_near = hair.pixels >= 1000 && hair.decibel() >= std::atof(arguments[4]);
  return is_near ? 0 : 1;
}
