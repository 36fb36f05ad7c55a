#pragma once

// One reader for each format of strands. Each takes the file's bytes, which may be damaged or hostile, and fills a
// groom's strands, attributes, groups, format and space; lengths stay in the file's unit and axes. The error is a
// sentence without the file's name, with the fault and its place. Memory is bounded by the file's size.

#include "groom/groom.h"

#include <fmt/format.h>
#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace coif::groom {

/// Cem Yuksel's .hair. Source: Yuksel, "HAIR File Format", www.cemyuksel.com/research/hairmodels: a header of 128
/// bytes, then the arrays that its bits announce: segments of each strand, points, thickness, transparency, colour.
[[nodiscard]] tl::expected<Groom, std::string> read_hair_file(std::span<const std::byte> bytes);

/// AMD's .tfx of TressFX 3 and 4. Source: GPUOpen, TressFX 3.0 and 4.0, the headers of their files: strands of one
/// number of points each, at offsets that the header names; in 4 a point has a fourth number, 0 where it is fixed.
[[nodiscard]] tl::expected<Groom, std::string> read_tressfx(std::span<const std::byte> bytes);

/// Lines of a Wavefront OBJ; faces, materials and curves are ignored. Blender writes a curve as segments of two points,
/// others as one line: lines that meet end to end are one strand. Objects and groups become groups.
[[nodiscard]] tl::expected<Groom, std::string> read_obj_lines(std::string_view text);

/// Primitives of lines and line strips of a glTF 2.0 at rest, of all nodes of its scene; a node is a group. Its buffers
/// may lie in its own folder or those of ImportSettings::roots.
[[nodiscard]] tl::expected<Groom, std::string> read_gltf_lines(const std::filesystem::path& path,
                                                               std::span<const std::filesystem::path> roots);

/// Lines of a document as lists of its vertices, one after the other.
struct VertexLines {
  std::vector<std::uint32_t> vertices;
  std::vector<std::uint32_t> begin{0};  ///< First index of each line, and one more.

  [[nodiscard]] std::size_t count() const { return begin.size() - 1; }
  [[nodiscard]] std::span<const std::uint32_t> line(std::size_t i) const {
    return std::span(vertices).subspan(begin[i], begin[i + 1] - begin[i]);
  }
  void add(std::span<const std::uint32_t> line) {
    vertices.insert(vertices.end(), line.begin(), line.end());
    begin.push_back(std::uint32_t(vertices.size()));
  }
};

struct JoinedLines {
  VertexLines strands;
  std::vector<std::uint32_t> first_line;  ///< For each strand the smallest number of a line in it.
};

/// Joins lines that meet end to end: at a vertex that is the end of exactly two lines and in no other. The result has
/// the order of the first line of each, and its direction; a closed ring begins where its first line does. Lines have
/// two vertices or more, each below `vertex_count`.
[[nodiscard]] JoinedLines joined_lines(const VertexLines& lines, std::size_t vertex_count);

// Arrays in a binary file of little-endian numbers, as this machine has them.

/// The number at a place that is known to be in the file.
template <class Number>
[[nodiscard]] Number number_at(std::span<const std::byte> bytes, std::size_t at) {
  Number number;
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}

/// Reads `count` numbers from the byte `at` on; the error names `what` they are where the file ends too early.
template <class Number>
[[nodiscard]] tl::expected<std::vector<Number>, std::string> numbers_at(std::span<const std::byte> bytes,
                                                                        std::uint64_t at, std::uint64_t count,
                                                                        const char* what) {
  if (at > bytes.size() || count > (bytes.size() - at) / sizeof(Number)) {
    return tl::unexpected(fmt::format("cut off in the {}: {} of {} bytes from byte {} on", what,
                                      at > bytes.size() ? 0 : bytes.size() - at, count * sizeof(Number), at));
  }
  std::vector<Number> numbers(static_cast<std::size_t>(count));
  if (count != 0) std::memcpy(numbers.data(), bytes.data() + at, numbers.size() * sizeof(Number));
  return numbers;
}

}  // namespace coif::groom
