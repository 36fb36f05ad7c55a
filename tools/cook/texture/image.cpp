#include "cook/texture/image.h"

#include "base/files.h"
#include "platform/child_process.h"
#include "platform/job.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <new>

// The one home of this header.
#define STB_IMAGE_RESIZE_IMPLEMENTATION
#define STB_IMAGE_RESIZE_STATIC
#include <stb/stb_image_resize.h>

namespace coif::cook {
namespace {

// Memory for an image, the decoder's own copy of it and its input; and more than an honest image takes.
constexpr platform::ChildLimits kDecoderLimits{
    .memory_bytes = std::uint64_t{2} << 30, .seconds = 60, .output_bytes = 4 * kMaxImageTexels + 64};

struct AnswerHead {
  std::uint32_t decoded = 0;  ///< 1: texels follow; 0: a sentence.
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t channels = 0;
};

std::vector<std::uint8_t> encode_answer(const tl::expected<Image, std::string>& image) {
  AnswerHead head;
  if (image) head = {1, image->width, image->height, image->channels};
  const auto* body = image ? image->texels.data() : reinterpret_cast<const std::uint8_t*>(image.error().data());
  const std::size_t size = image ? image->texels.size() : image.error().size();
  std::vector<std::uint8_t> answer(sizeof head + size);
  std::memcpy(answer.data(), &head, sizeof head);
  std::copy_n(body, size, answer.data() + sizeof head);
  return answer;
}

bool is_sentence(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kLongest = 200;
  return !bytes.empty() && bytes.size() <= kLongest &&
         std::ranges::all_of(bytes, [](std::uint8_t byte) { return byte >= ' ' && byte <= '~'; });
}

/// The child may have been taken over by the image, so nothing in its answer is trusted.
tl::expected<Image, std::string> decode_answer(const platform::ChildResult& result) {
  AnswerHead head;
  switch (result.end) {
    case platform::ChildResult::End::kFinished: break;
    case platform::ChildResult::End::kTooSlow:
      return tl::unexpected(std::string("takes too long to decode; save it as PNG"));
    case platform::ChildResult::End::kNotStarted:
      return tl::unexpected(fmt::format("cannot start a process to decode it: {}", std::strerror(result.code)));
    default: return tl::unexpected(std::string("the decoder crashed; save it as PNG"));
  }
  const std::vector<std::uint8_t>& answer = result.output;
  if (answer.size() >= sizeof head) std::memcpy(&head, answer.data(), sizeof head);
  const std::span<const std::uint8_t> body = std::span(answer).subspan(std::min(sizeof head, answer.size()));
  if (head.decoded == 0 && is_sentence(body)) return tl::unexpected(std::string(body.begin(), body.end()));
  Image image{head.width, head.height, head.channels, {}};
  const bool fits = head.decoded == 1 && head.channels == 4 && head.width <= kMaxImageSide &&
                    head.height <= kMaxImageSide && !body.empty() && body.size() == image.texel_count() * 4;
  if (!fits) return tl::unexpected(std::string("the decoder's answer makes no sense; save it as PNG"));
  image.texels.assign(body.begin(), body.end());
  return image;
}

const platform::Job kDecodeImage("decode image", [](const platform::JobCall& call) {
  platform::lock_up({}, {});  // As far as this machine can.
  return encode_answer(decode_texels(call.request()));
});

}  // namespace

tl::expected<Image, std::string> decode_image(std::span<const std::uint8_t> bytes) {
  if (bytes.size() > kMaxImageBytes) {
    return tl::unexpected(fmt::format("larger than {} MiB; reduce it", kMaxImageBytes >> 20));
  }
  return decode_answer(platform::run_in_child(kDecodeImage, bytes, {.limits = kDecoderLimits}));
}

tl::expected<Image, std::string> read_image(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return tl::unexpected(std::string("no such file"));
  if (std::filesystem::file_size(path, error) > kMaxImageBytes) {
    return tl::unexpected(fmt::format("larger than {} MiB; reduce it", kMaxImageBytes >> 20));
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) return tl::unexpected(fmt::format("cannot open: {}", std::strerror(errno)));
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  if (is_lfs_pointer({bytes.data(), bytes.size()})) return tl::unexpected(std::string(kLfsPointer));
  return decode_image({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

namespace {

Image resized(const Image& image, std::uint32_t width, std::uint32_t height, TexelMeaning meaning,
              stbir_filter filter) {
  Image result{width, height, image.channels, {}};
  result.texels.resize(result.texel_count() * image.channels);
  const bool color = meaning == TexelMeaning::kSrgbColorAlpha;
  const int done = stbir_resize_uint8_generic(image.texels.data(), int(image.width), int(image.height), 0,
                                              result.texels.data(), int(width), int(height), 0, int(image.channels),
                                              color ? 3 : STBIR_ALPHA_CHANNEL_NONE, 0, STBIR_EDGE_WRAP, filter,
                                              color ? STBIR_COLORSPACE_SRGB : STBIR_COLORSPACE_LINEAR, nullptr);
  if (done == 0) throw std::bad_alloc();
  return result;
}

}  // namespace

Image shrink(const Image& image, std::uint32_t width, std::uint32_t height, TexelMeaning meaning) {
  return resized(image, width, height, meaning, STBIR_FILTER_BOX);
}

Image enlarge(Image image, std::uint32_t width, std::uint32_t height, TexelMeaning meaning) {
  if (image.width == width && image.height == height) return image;
  return resized(image, width, height, meaning, STBIR_FILTER_TRIANGLE);
}

namespace {

Image half(const Image& image, TexelMeaning meaning) {
  return shrink(image, std::max(1u, image.width / 2), std::max(1u, image.height / 2), meaning);
}

}  // namespace

Image reduce(Image image, std::uint32_t max_size, TexelMeaning meaning) {
  while (std::max(image.width, image.height) > max_size) image = half(image, meaning);
  return image;
}

Image quarter_rows(const Image& image, TexelMeaning meaning) {
  return shrink(image, image.width, std::max(1u, image.height / 4), meaning);
}

std::vector<Image> make_mips(Image image, std::uint32_t max_size, TexelMeaning meaning) {
  std::vector<Image> mips;
  mips.push_back(reduce(std::move(image), max_size, meaning));
  while (mips.back().width > 1 || mips.back().height > 1) mips.push_back(half(mips.back(), meaning));
  return mips;
}

}  // namespace coif::cook
