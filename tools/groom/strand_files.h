#pragma once

// One reader for each format that strands come in. Each takes the file's bytes, which may be damaged or hostile, and
// fills a groom's strands, attributes, groups, format and space; lengths stay in the file's unit and axes. The error is
// a sentence without the file's name that says what is wrong and where. Nothing is allocated that the file does not
// hold.

#include "groom/groom.h"

#include <tl/expected.hpp>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace coif::groom {

/// Cem Yuksel's .hair. Source: Yuksel, "HAIR File Format", www.cemyuksel.com/research/hairmodels: a header of 128
/// bytes, then the arrays that its bits announce: segments of each strand, points, thickness, transparency, colour.
[[nodiscard]] tl::expected<Groom, std::string> read_hair_file(std::span<const std::byte> bytes);

/// AMD's .tfx of TressFX 3 and 4. Source: GPUOpen, TressFX 3.0 and 4.0, the headers of their files: strands of one
/// number of points each, at offsets that the header names; in 4 a point has a fourth number, 0 where it is fixed.
[[nodiscard]] tl::expected<Groom, std::string> read_tressfx(std::span<const std::byte> bytes);

/// Lines of a Wavefront OBJ; faces, materials and curves are not looked at. Blender writes a curve as segments of two
/// points, others as one line: what meets end to end is one strand. Objects and groups become groups.
[[nodiscard]] tl::expected<Groom, std::string> read_obj_lines(std::string_view text);

/// Primitives of lines and line strips of a glTF 2.0 at rest, of all nodes of its scene; a node is a group. Its buffers
/// may lie in its own folder or those of ImportSettings::roots.
[[nodiscard]] tl::expected<Groom, std::string> read_gltf_lines(const std::filesystem::path& path,
                                                               std::span<const std::filesystem::path> roots);

}  // namespace coif::groom
