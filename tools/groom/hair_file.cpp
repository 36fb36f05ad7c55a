#include "groom/strand_files.h"
#include "import/source_warnings.h"

#include <algorithm>
#include <array>
#include <utility>

namespace coif::groom {
namespace {

using HairBytes = std::span<const std::byte>;

constexpr std::size_t kHairHeader = 128;

// Arrays that the header's bits announce, in their order in the file.
enum Arrays : std::uint32_t { kSegments = 1, kPoints = 2, kThickness = 4, kTransparency = 8, kColors = 16 };

struct HairHeader {
  std::uint32_t strands, points, arrays, usual_segments;
  float usual_thickness, usual_transparency;
};

HairHeader hair_header(HairBytes bytes) {
  return {number_at<std::uint32_t>(bytes, 4),  number_at<std::uint32_t>(bytes, 8), number_at<std::uint32_t>(bytes, 12),
          number_at<std::uint32_t>(bytes, 16), number_at<float>(bytes, 20),        number_at<float>(bytes, 24)};
}

/// The arrays behind the header, each read where the one before it ends.
class ArrayReader {
 public:
  ArrayReader(HairBytes bytes, std::uint32_t announced) : bytes_(bytes), announced_(announced) {}

  /// Empty where the file has no such array.
  template <class Number>
  std::vector<Number> read(Arrays which, std::uint64_t count, const char* what) {
    if ((announced_ & which) == 0 || !fault_.empty()) return {};
    auto numbers = numbers_at<Number>(bytes_, at_, count, what);
    if (!numbers) {
      fault_ = numbers.error();
      return {};
    }
    at_ += count * sizeof(Number);
    return std::move(*numbers);
  }

  [[nodiscard]] const std::string& fault() const { return fault_; }

 private:
  HairBytes bytes_;
  std::uint32_t announced_;
  std::uint64_t at_ = kHairHeader;
  std::string fault_;
};

std::vector<Eigen::Vector3f> vectors(const std::vector<float>& numbers) {
  std::vector<Eigen::Vector3f> out(numbers.size() / 3);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = Eigen::Vector3f(&numbers[3 * i]);
  return out;
}

float within(float value, float low, float high) { return value >= low ? std::min(value, high) : low; }

/// Attributes in a groom's form; invalid numbers become the nearest valid one, NaN the smallest.
struct PointArrays {
  std::vector<Eigen::Vector3f> points, colors;
  std::vector<float> widths, opacities;

  void tidy(const HairHeader& header, Diagnostics& warnings) {
    if (widths.empty() && header.usual_thickness > 0) widths.assign(points.size(), header.usual_thickness);
    if (opacities.empty() && header.usual_transparency > 0) opacities.assign(points.size(), header.usual_transparency);
    std::size_t bad = 0;
    const auto limit = [&bad](float& value, float high) {
      const float kept = within(value, 0, high);
      if (!(kept == value)) ++bad;
      value = kept;
    };
    for (float& width : widths) limit(width, 1e6f);
    for (float& transparency : opacities) {
      limit(transparency, 1);
      transparency = 1 - transparency;
    }
    for (Eigen::Vector3f& color : colors) {
      for (int k = 0; k < 3; ++k) limit(color[k], 1);
    }
    if (bad != 0)
      importer::warn(warnings, importer::source_code::kStrands,
                     "{} thicknesses, transparencies or colours out of their range set to its end", bad);
  }

  [[nodiscard]] GroomBuilder::Attributes of(std::size_t begin, std::size_t count) const {
    const auto part = [=](const auto& array) {
      return array.empty() ? std::span(array.data(), 0) : std::span(array).subspan(begin, count);
    };
    return {part(widths), part(colors), part(opacities)};
  }
};

/// Number of points of each strand. The error: they do not add up to those of the file.
tl::expected<std::vector<std::uint32_t>, std::string> strand_sizes(const HairHeader& header,
                                                                   const std::vector<std::uint16_t>& segments) {
  std::uint64_t end = 0;
  std::vector<std::uint32_t> sizes;
  sizes.reserve(std::min<std::size_t>(header.strands, header.points));
  for (std::uint32_t i = 0; i < header.strands; ++i) {
    const std::uint32_t size = (segments.empty() ? header.usual_segments : segments[i]) + 1;
    end += size;
    if (size == 0 || end > header.points) {
      return tl::unexpected(
          fmt::format("strand {} of {} ends at point {}, and the file has {}", i, header.strands, end, header.points));
    }
    sizes.push_back(size);
  }
  if (end != header.points) {
    return tl::unexpected(
        fmt::format("the {} strands have {} points, and the file {}", header.strands, end, header.points));
  }
  return sizes;
}

}  // namespace

tl::expected<Groom, std::string> read_hair_file(HairBytes bytes) {
  if (bytes.size() < kHairHeader)
    return tl::unexpected(fmt::format("cut off in the header: {} of {} bytes", bytes.size(), kHairHeader));
  if (std::memcmp(bytes.data(), "HAIR", 4) != 0) return tl::unexpected(std::string("does not begin with 'HAIR'"));
  const HairHeader header = hair_header(bytes);
  if ((header.arrays & kPoints) == 0) return tl::unexpected(std::string("has no points"));
  ArrayReader arrays(bytes, header.arrays);
  const auto segments = arrays.read<std::uint16_t>(kSegments, header.strands, "segments");
  PointArrays values;
  values.points = vectors(arrays.read<float>(kPoints, std::uint64_t{3} * header.points, "points"));
  values.widths = arrays.read<float>(kThickness, header.points, "thickness");
  values.opacities = arrays.read<float>(kTransparency, header.points, "transparency");
  values.colors = vectors(arrays.read<float>(kColors, std::uint64_t{3} * header.points, "colours"));
  if (!arrays.fault().empty()) return tl::unexpected(arrays.fault());
  const auto sizes = strand_sizes(header, segments);
  if (!sizes) return tl::unexpected(sizes.error());

  Groom groom;
  groom.format = "HAIR";
  groom.root_first = true;
  groom.space.up_axis = 'z';
  groom.space.up = importer::Statement::kUsual;
  groom.space.up_words = "files of this format mostly have Z up";
  groom.space.unit = importer::Statement::kUnsaid;
  groom.space.unit_words = "the format has no unit";
  values.tidy(header, groom.warnings);
  GroomBuilder builder(groom);
  std::size_t begin = 0;
  for (const std::uint32_t size : *sizes) {
    builder.add(std::span(values.points).subspan(begin, size), values.of(begin, size));
    begin += size;
  }
  if (std::string fault = builder.finish(); !fault.empty()) return tl::unexpected(std::move(fault));
  return groom;
}

}  // namespace coif::groom
