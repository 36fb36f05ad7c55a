#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace coif::groom {

/// Lines of a document as lists of its vertices, one after the other.
struct VertexLines {
  std::vector<std::uint32_t> vertices;
  std::vector<std::uint32_t> begin{0};  ///< Of each line, and one more.

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
  std::vector<std::uint32_t> first_line;  ///< Of each strand, the smallest number of a line in it.
};

/// What the lines are once those that meet end to end are one: at a vertex that is the end of exactly two lines and in
/// no other, they go on. In the order of the first line of each, and in its direction; a closed ring begins where its
/// first line does. Lines have two vertices or more, each below `vertex_count`.
[[nodiscard]] JoinedLines joined_lines(const VertexLines& lines, std::size_t vertex_count);

}  // namespace coif::groom
