#include "base/encodings.h"

#include <zlib.h>

#include <iterator>
#include <string_view>

namespace coif {
namespace {

constexpr std::uint8_t kSignature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
constexpr std::uint8_t kRgb = 2, kRgba = 6;  ///< Colour types of PNG.
constexpr std::uint8_t kUp = 2;              ///< The filter that stores differences from the row above.
constexpr int kLevel = 2;                    ///< zlib: 1 is fast, 9 small.

void append_number(std::uint32_t number, std::vector<std::uint8_t>& bytes) {
  for (const int shift : {24, 16, 8, 0}) bytes.push_back(std::uint8_t(number >> shift));
}

void append_chunk(std::string_view type, std::span<const std::uint8_t> data, std::vector<std::uint8_t>& png) {
  append_number(std::uint32_t(data.size()), png);
  const std::size_t begin = png.size();
  png.insert(png.end(), type.begin(), type.end());
  png.insert(png.end(), data.begin(), data.end());
  append_number(std::uint32_t(crc32(0, &png[begin], uInt(png.size() - begin))), png);
}

bool is_opaque(std::span<const std::uint8_t> rgba) {
  std::uint8_t all = 255;
  for (std::size_t alpha = 3; alpha < rgba.size(); alpha += 4) all &= rgba[alpha];
  return all == 255;
}

/// The row's filter and `channels` bytes for each pixel.
void filter_row(const std::uint8_t* row, const std::uint8_t* above, std::size_t channels,
                std::vector<std::uint8_t>& filtered) {
  std::uint8_t* out = filtered.data();
  *out++ = kUp;
  for (const std::uint8_t* const end = out + (filtered.size() - 1); out != end; row += 4, above += 4) {
    for (std::size_t k = 0; k < channels; ++k) *out++ = std::uint8_t(row[k] - above[k]);
  }
}

/// A stream of zlib's format.
class Deflater {
 public:
  Deflater() { is_open_ = deflateInit(&stream_, kLevel) == Z_OK; }
  Deflater(const Deflater&) = delete;
  Deflater& operator=(const Deflater&) = delete;
  ~Deflater() { deflateEnd(&stream_); }

  /// False when out of memory.
  bool add(std::span<std::uint8_t> bytes, bool is_last) {
    if (!is_open_) return false;
    stream_.next_in = bytes.data();
    stream_.avail_in = uInt(bytes.size());
    int status = Z_OK;
    do {
      std::uint8_t block[1 << 14];
      stream_.next_out = block;
      stream_.avail_out = sizeof block;
      status = deflate(&stream_, is_last ? Z_FINISH : Z_NO_FLUSH);
      bytes_.insert(bytes_.end(), block, stream_.next_out);
    } while (status == Z_OK && stream_.avail_out == 0);
    // Without room in the block, and nothing left for it, the last call says Z_BUF_ERROR.
    return status == Z_STREAM_END || (!is_last && (status == Z_OK || status == Z_BUF_ERROR));
  }

  [[nodiscard]] std::span<const std::uint8_t> bytes() const { return bytes_; }

 private:
  z_stream stream_{};
  bool is_open_ = false;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace

std::vector<std::uint8_t> encode_png_quickly(std::span<const std::uint8_t> rgba, std::uint32_t width,
                                             std::uint32_t height) {
  const bool opaque = is_opaque(rgba);
  const std::size_t row = std::size_t{4} * width, channels = opaque ? 3 : 4;
  const std::vector<std::uint8_t> nothing(row);
  std::vector<std::uint8_t> filtered(1 + channels * width);
  Deflater data;
  for (std::size_t y = 0; y < height; ++y) {
    const std::uint8_t* const pixels = rgba.data() + y * row;
    filter_row(pixels, y > 0 ? pixels - row : nothing.data(), channels, filtered);
    if (!data.add(filtered, y + 1 == height)) return {};
  }
  std::vector<std::uint8_t> png(std::begin(kSignature), std::end(kSignature)), header;
  append_number(width, header);
  append_number(height, header);
  header.insert(header.end(), {8, opaque ? kRgb : kRgba, 0, 0, 0});
  png.reserve(data.bytes().size() + 64);
  append_chunk("IHDR", header, png);
  append_chunk("IDAT", data.bytes(), png);
  append_chunk("IEND", {}, png);
  return png;
}

}  // namespace coif
