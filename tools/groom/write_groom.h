#pragma once

#include "base/tool_error.h"
#include "groom/groom.h"

#include <tl/expected.hpp>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace coif::groom {

/// As Cem Yuksel's .hair (strand_files.h), with all that the strands have; Z up, as such files mostly are, in metres.
/// The error is a sentence without the file's name: a strand of more segments than the format counts.
[[nodiscard]] tl::expected<std::vector<std::byte>, std::string> hair_file_of(const Groom& groom);

/// As lines of a Wavefront OBJ, Y up, in metres, an object for each group. It has no place for widths and colours.
[[nodiscard]] std::string obj_lines_of(const Groom& groom);

/// Either, by the suffix of `path`, as the bytes of a file. Errors: kUsage for another suffix, kBadInput as above.
[[nodiscard]] tl::expected<std::vector<std::byte>, ToolError> encode_strands(const Groom& groom,
                                                                             const std::filesystem::path& path);

}  // namespace coif::groom
