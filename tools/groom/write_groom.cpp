#include "groom/read_groom.h"

#include "base/files.h"
#include "base/text.h"

#include <fmt/format.h>

#include <cstring>
#include <iterator>
#include <limits>

namespace coif::groom {
namespace {

/// Numbers one after the other, as this machine has them.
class HairBytesWriter {
 public:
  template <class Number>
  void add(Number number) {
    const std::size_t end = bytes_.size();
    bytes_.resize(end + sizeof number);
    std::memcpy(&bytes_[end], &number, sizeof number);
  }
  /// Converts to axes with Z up.
  void add_place(const Eigen::Vector3f& p) {
    add(p.x());
    add(-p.z());
    add(p.y());
  }
  void fill_to(std::size_t size) { bytes_.resize(size); }
  void reserve(std::size_t size) { bytes_.reserve(size); }
  [[nodiscard]] std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  std::vector<std::byte> bytes_;
};

}  // namespace

tl::expected<std::vector<std::byte>, std::string> hair_file_of(const Groom& groom) {
  constexpr std::uint32_t kSegmentsBit = 1, kPointsBit = 2, kThicknessBit = 4, kTransparencyBit = 8, kColorsBit = 16;
  constexpr std::size_t kHeaderBytes = 128, kMostSegments = std::numeric_limits<std::uint16_t>::max();
  for (std::size_t i = 0; i < groom.strand_count(); ++i) {
    if (groom.strand(i).size() - 1 > kMostSegments)
      return tl::unexpected(fmt::format("strand {} has more than {} segments", i, kMostSegments));
  }
  const std::uint32_t arrays = kSegmentsBit | kPointsBit | (groom.widths.empty() ? 0 : kThicknessBit) |
                               (groom.opacities.empty() ? 0 : kTransparencyBit) |
                               (groom.colors.empty() ? 0 : kColorsBit);
  HairBytesWriter out;
  out.reserve(kHeaderBytes + 2 * groom.strand_count() + 32 * groom.points.size());
  for (const char letter : {'H', 'A', 'I', 'R'}) out.add(letter);
  out.add(std::uint32_t(groom.strand_count()));
  out.add(std::uint32_t(groom.points.size()));
  out.add(arrays);
  out.add(std::uint32_t{0});  // segments, thickness, transparency and colour of strands without
  for (int i = 0; i < 5; ++i) out.add(0.0f);
  out.fill_to(kHeaderBytes);
  for (std::size_t i = 0; i < groom.strand_count(); ++i) out.add(std::uint16_t(groom.strand(i).size() - 1));
  for (const Eigen::Vector3f& p : groom.points) out.add_place(p);
  for (const float width : groom.widths) out.add(width);
  for (const float opacity : groom.opacities) out.add(1 - opacity);
  for (const Eigen::Vector3f& color : groom.colors) {
    for (int k = 0; k < 3; ++k) out.add(color[k]);
  }
  return out.take();
}

std::string obj_lines_of(const Groom& groom) {
  std::string text = "# metres, Y up; lines from root to tip\n";
  auto end = std::back_inserter(text);
  std::size_t point = 0;
  for (const StrandGroup& group : groom.groups) {
    fmt::format_to(end, "o {}\n", group.name.empty() ? "hair" : printable_text(group.name));
    for (std::size_t i = group.first_strand; i < group.first_strand + std::size_t{group.strand_count}; ++i) {
      for (const Eigen::Vector3f& p : groom.strand(i))
        fmt::format_to(end, "v {:.6f} {:.6f} {:.6f}\n", p.x(), p.y(), p.z());
      text += 'l';
      for (std::size_t k = 0; k < groom.strand(i).size(); ++k) fmt::format_to(end, " {}", ++point);
      text += '\n';
    }
  }
  return text;
}

tl::expected<std::vector<std::byte>, ToolError> encode_strands(const Groom& groom, const std::filesystem::path& path) {
  const auto suffix = choose_suffix(path, {".obj", ".hair"});
  if (!suffix) return tl::unexpected(suffix.error());
  if (*suffix == ".obj") {
    const std::string text = obj_lines_of(groom);
    const auto bytes = std::as_bytes(std::span(text));
    return std::vector<std::byte>(bytes.begin(), bytes.end());
  }
  return hair_file_of(groom).map_error([&](const std::string& fault) {
    return ToolError{ToolError::Kind::kBadInput, path.string() + ": " + fault};
  });
}

}  // namespace coif::groom
