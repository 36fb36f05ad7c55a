#include "groom/read_groom.h"

#include "base/files.h"
#include "base/text.h"
#include "groom/strand_files.h"
#include "import/reader_process.h"
#include "platform/stop.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <new>
#include <optional>

namespace coif::groom {
namespace {

namespace fs = std::filesystem;
using Read = tl::expected<Groom, std::string>;

tl::expected<Groom, std::string> with_bytes(const fs::path& path, Read (*read)(std::span<const std::byte>)) {
  const auto bytes = FileBytes::read(path);
  return bytes ? read(bytes->span()) : tl::unexpected(bytes.error().message);
}

using Roots = std::span<const fs::path>;

Read read_hair(const fs::path& path, Roots) { return with_bytes(path, read_hair_file); }
Read read_tfx(const fs::path& path, Roots) { return with_bytes(path, read_tressfx); }
Read read_obj(const fs::path& path, Roots) {
  return with_bytes(path, [](std::span<const std::byte> bytes) {
    return read_obj_lines({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  });
}

struct StrandFormat {
  const char* suffix;
  const char* name;
  Read (*read)(const fs::path& path, Roots roots);
};
constexpr StrandFormat kFormats[] = {{".hair", "HAIR", read_hair},
                                     {".tfx", "TressFX", read_tfx},
                                     {".obj", "lines of a Wavefront OBJ", read_obj},
                                     {".gltf", "lines of a glTF 2.0", read_gltf_lines},
                                     {".glb", "lines of a glTF 2.0", read_gltf_lines}};

const StrandFormat* format_of(const fs::path& path) {
  std::string suffix = path.extension().string();
  for (char& letter : suffix) letter = letter >= 'A' && letter <= 'Z' ? char(letter - 'A' + 'a') : letter;
  const auto* const found =
      std::ranges::find_if(kFormats, [&](const StrandFormat& format) { return suffix == format.suffix; });
  return found == std::end(kFormats) ? nullptr : found;
}

importer::UpAxis axis_of(char letter) {
  return letter == 'x' ? importer::UpAxis::kX : letter == 'z' ? importer::UpAxis::kZ : importer::UpAxis::kY;
}

/// Converts from the file's unit and axes to metres, Y up.
void place(Groom& groom, const importer::ImportSettings& settings) {
  if (settings.metres_per_unit) {
    groom.space.metres_per_unit = *settings.metres_per_unit;
    groom.space.unit = importer::Statement::kGiven;
    groom.space.unit_words = "the caller";
  }
  if (settings.up_axis) {
    groom.space.up_axis = *settings.up_axis == importer::UpAxis::kX   ? 'x'
                          : *settings.up_axis == importer::UpAxis::kY ? 'y'
                                                                      : 'z';
    groom.space.up = importer::Statement::kGiven;
    groom.space.up_words = "the caller";
  }
  const auto scale = float(groom.space.metres_per_unit);
  const Eigen::Matrix3f turn = importer::y_up_from(axis_of(groom.space.up_axis)).cast<float>();
  for (Eigen::Vector3f& point : groom.points) point = scale * (turn * point);
  for (float& width : groom.widths) width *= scale;
}

GroomOutcome read_here(const fs::path& path, const StrandFormat& format, const importer::ImportSettings& settings) {
  auto groom = format.read(path, settings.roots);
  if (!groom) {
    return file_failure(ToolError::Kind::kBadInput, path, "cannot be read as {}: {}", format.name, groom.error());
  }
  groom->path = path.string();
  place(*groom, settings);
  leave_out_strays(*groom);
  if (const std::string fault = find_groom_fault(*groom); !fault.empty()) {
    return file_failure(ToolError::Kind::kBadInput, path, "cannot be read as {}: {}", format.name, fault);
  }
  return std::move(*groom);
}

/// Their suffix is one of kFormats.
const platform::Job kReadStrands("read strands", [](const platform::JobCall& call) {
  return importer::answer_read(call, [](const fs::path& path, const importer::ImportSettings& settings) {
    return encode_groom(read_here(path, *format_of(path), settings));
  });
});

tl::expected<Groom, ToolError> read_checked(const fs::path& path, const importer::ImportSettings& settings) {
  if (auto checked = importer::check_readable(path, settings.max_file_bytes); !checked)
    return tl::unexpected(checked.error());
  const StrandFormat* const format = format_of(path);
  if (format == nullptr) {
    return file_failure(ToolError::Kind::kUnsupported, path,
                        "'{}' holds no strands that can be read; export as one of {}", path.extension().string(),
                        strand_suffixes());
  }
  const auto answer = importer::read_in_child(kReadStrands, path, settings);
  if (!answer) return tl::unexpected(answer.error());
  GroomOutcome outcome;
  if (!decode_groom(*answer, outcome)) return importer::senseless_answer(path);
  return outcome;
}

}  // namespace

bool has_strand_suffix(const fs::path& path) { return format_of(path) != nullptr; }

std::string strand_suffixes() {
  std::string list;
  for (const StrandFormat& format : kFormats) list.append(list.empty() ? "" : ", ").append(format.suffix);
  return list;
}

tl::expected<Groom, ToolError> read_groom(const fs::path& path, const importer::ImportSettings& settings) try {
  return read_checked(path, settings);
} catch (const std::bad_alloc&) {
  return file_failure(ToolError::Kind::kBadInput, path, "not enough memory for these strands");
} catch (const platform::Stopped&) {
  throw;
} catch (const std::exception& thrown) {
  return file_failure(ToolError::Kind::kInternal, path, "{}", thrown.what());
}

}  // namespace coif::groom
