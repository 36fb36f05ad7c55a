#pragma once

#include "base/tool_error.h"
#include "groom/groom.h"
#include "import/import.h"

#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace coif::groom {

/// Whether strands can be read from a file of this suffix: .hair, .tfx, .obj, .gltf, .glb, whatever its case.
[[nodiscard]] bool has_strand_suffix(const std::filesystem::path& path);

/// ".hair, .tfx, ..." for messages.
[[nodiscard]] std::string strand_suffixes();

/// Reads the strands of a file in a child process under the limits of `settings`, whose unit and up axis override the
/// file's. Never throws. Errors: kFileAccess (absent, unreadable), kBadInput (damaged, a limit, no strand),
/// kUnsupported (suffix). Blocks; costs a fork, so call it before starting threads if possible.
tl::expected<Groom, ToolError> read_groom(const std::filesystem::path& path,
                                          const importer::ImportSettings& settings = {});

/// Writes Cem Yuksel's .hair (strand_files.h), with all attributes of the strands; Z up, as in most such files, in
/// metres. The error is a sentence without the file's name: a strand has more segments than the format can count.
[[nodiscard]] tl::expected<std::vector<std::byte>, std::string> hair_file_of(const Groom& groom);

/// Writes lines of a Wavefront OBJ, Y up, in metres, an object for each group. The format has no widths and colours.
[[nodiscard]] std::string obj_lines_of(const Groom& groom);

/// Either, by the suffix of `path`, as the bytes of a file. Errors: kUsage for another suffix, kBadInput as above.
[[nodiscard]] tl::expected<std::vector<std::byte>, ToolError> encode_strands(const Groom& groom,
                                                                             const std::filesystem::path& path);

// What the process that reads strands sends back; as import/reader_process.h has it of models.

using GroomOutcome = tl::expected<Groom, ToolError>;

[[nodiscard]] std::vector<std::uint8_t> encode_groom(const GroomOutcome& outcome);

/// False, with `outcome` untouched, unless the bytes are exactly one outcome whose groom keeps every promise of
/// groom.h. Allocates at most a small multiple of the bytes given.
[[nodiscard]] bool decode_groom(std::span<const std::uint8_t> bytes, GroomOutcome& outcome);

}  // namespace coif::groom
