#include "groom/strand_files.h"

#include <algorithm>
#include <cmath>

namespace coif::groom {
namespace {

using TfxBytes = std::span<const std::byte>;

// In both versions all words have four bytes: the version, counts, offsets of arrays from the file's start (0: absent).
constexpr std::size_t kLeastHeader = 160;
constexpr std::size_t kHeaderOf3 = 296;
constexpr std::uint32_t kMostPointsOfStrand = 4096;  // 64 in all that TressFX draws

struct TfxHeader {
  float version = 0;
  std::uint32_t strands = 0, points_of_strand = 0, follow_hairs = 0;
  std::uint32_t positions = 0, thickness = 0, colors = 0;
  std::uint32_t numbers_of_place = 3;
};

tl::expected<TfxHeader, std::string> tfx_header(TfxBytes bytes) {
  if (bytes.size() < kLeastHeader) {
    return tl::unexpected(fmt::format("cut off in the header: {} of {} bytes", bytes.size(), kLeastHeader));
  }
  const auto word = [&](std::size_t i) { return number_at<std::uint32_t>(bytes, 4 * i); };
  TfxHeader header;
  header.version = number_at<float>(bytes, 0);
  header.strands = word(1);
  header.points_of_strand = word(2);
  if (header.version >= 4 && header.version < 5) {
    header.positions = word(3);
    header.thickness = word(6);
    header.colors = word(7);
    header.numbers_of_place = 4;
  } else if (header.version >= 3 && header.version < 4) {
    if (bytes.size() < kHeaderOf3) {
      return tl::unexpected(fmt::format("cut off in the header: {} of {} bytes", bytes.size(), kHeaderOf3));
    }
    header.follow_hairs = word(3);
    header.positions = word(36);
    header.thickness = word(37);
    header.colors = word(39);
  } else {
    return tl::unexpected(fmt::format("is of version {:g}; 3 and 4 can be read", header.version));
  }
  if (header.strands == 0) return tl::unexpected(std::string("has no strand"));
  if (header.points_of_strand < 2 || header.points_of_strand > kMostPointsOfStrand) {
    return tl::unexpected(
        fmt::format("says that a strand has {} points; it has 2 to {}", header.points_of_strand, kMostPointsOfStrand));
  }
  return header;
}

/// One colour for each point of all strands.
std::vector<Eigen::Vector3f> tfx_colors(const std::vector<float>& numbers) {
  std::vector<Eigen::Vector3f> colors;
  colors.reserve(numbers.size() / 4);
  for (std::size_t i = 0; i + 3 < numbers.size(); i += 4) {
    const Eigen::Vector3f color(&numbers[i]);
    colors.push_back(color.allFinite() ? color.cwiseMax(0).cwiseMin(1).eval() : Eigen::Vector3f::Zero());
  }
  return colors;
}

}  // namespace

tl::expected<Groom, std::string> read_tressfx(TfxBytes bytes) {
  const auto header = tfx_header(bytes);
  if (!header) return tl::unexpected(header.error());
  const std::uint64_t count = std::uint64_t{header->strands} * header->points_of_strand;
  const auto places = numbers_at<float>(bytes, header->positions, count * header->numbers_of_place, "points");
  if (!places) return tl::unexpected(places.error());
  tl::expected<std::vector<float>, std::string> widths, colors;
  if (header->thickness != 0) widths = numbers_at<float>(bytes, header->thickness, header->strands, "thickness");
  if (header->colors != 0) colors = numbers_at<float>(bytes, header->colors, 4 * count, "colours");
  if (!widths) return tl::unexpected(widths.error());
  if (!colors) return tl::unexpected(colors.error());

  Groom groom;
  groom.format = fmt::format("TressFX {:.1f}", header->version);
  groom.root_first = true;
  groom.follow_hairs = header->follow_hairs;
  groom.space.up = importer::Statement::kUsual;
  groom.space.up_words = "files of this format mostly have Y up";
  groom.space.unit = importer::Statement::kUnsaid;
  groom.space.unit_words = "the format has no unit";
  const std::vector<Eigen::Vector3f> all_colors = tfx_colors(*colors);
  std::vector<Eigen::Vector3f> points(header->points_of_strand);
  std::vector<float> thickness;
  GroomBuilder builder(groom);
  for (std::size_t i = 0; i < header->strands; ++i) {
    for (std::size_t p = 0; p < points.size(); ++p) {
      points[p] = Eigen::Vector3f(&(*places)[(i * points.size() + p) * header->numbers_of_place]);
    }
    GroomBuilder::Attributes attributes;
    if (!widths->empty()) {
      const float width = (*widths)[i];
      thickness.assign(points.size(), width >= 0 && width <= 1e6f ? width : 0.0f);
      attributes.widths = thickness;
    }
    if (!all_colors.empty()) attributes.colors = std::span(all_colors).subspan(i * points.size(), points.size());
    builder.add(points, attributes);
  }
  if (std::string fault = builder.finish(); !fault.empty()) return tl::unexpected(std::move(fault));
  return groom;
}

}  // namespace coif::groom
