#include "groom/strand_files.h"

#include <array>
#include <limits>

namespace coif::groom {
namespace {

constexpr std::uint32_t kNothing = std::numeric_limits<std::uint32_t>::max();

/// One of a line's two ends: twice its number, plus one for its last vertex.
using LineEnd = std::uint32_t;

class Joiner {
 public:
  Joiner(const VertexLines& lines, std::size_t vertex_count)
      : lines_(lines), ends_(vertex_count, {kNothing, kNothing}), uses_(vertex_count, 0), done_(lines.count(), false) {
    for (std::uint32_t i = 0; i < lines.count(); ++i) {
      const auto line = lines.line(i);
      for (const std::uint32_t v : line) {
        if (uses_[v] < 3) ++uses_[v];
      }
      note(line.front(), 2 * i);
      note(line.back(), 2 * i + 1);
    }
  }

  JoinedLines join() {
    JoinedLines out;
    std::vector<std::uint32_t> strand;
    for (std::uint32_t i = 0; i < lines_.count(); ++i) {
      if (done_[i]) continue;
      strand.clear();
      LineEnd at = first_of(2 * i);
      do {
        append(at, strand);
        at = other_at(vertex_of(at ^ 1), at ^ 1);
      } while (at != kNothing && !done_[at / 2]);
      out.strands.add(strand);
      out.first_line.push_back(i);
    }
    return out;
  }

 private:
  void note(std::uint32_t vertex, LineEnd end) {
    auto& ends = ends_[vertex];
    (ends[0] == kNothing ? ends[0] : ends[1]) = end;
  }

  [[nodiscard]] std::uint32_t vertex_of(LineEnd end) const {
    const auto line = lines_.line(end / 2);
    return (end & 1) != 0 ? line.back() : line.front();
  }

  /// The end of the other line that continues at this end.
  [[nodiscard]] LineEnd other_at(std::uint32_t vertex, LineEnd end) const {
    const auto& ends = ends_[vertex];
    if (uses_[vertex] != 2 || ends[1] == kNothing) return kNothing;
    const LineEnd other = ends[0] == end ? ends[1] : ends[0];
    return other / 2 == end / 2 ? kNothing : other;  // A line whose ends are one vertex.
  }

  /// Back from the beginning of a line to the first of its strand, which is given by the end that it begins with.
  [[nodiscard]] LineEnd first_of(LineEnd begin) const {
    const LineEnd home = begin;
    for (LineEnd before = other_at(vertex_of(begin), begin); before != kNothing;
         before = other_at(vertex_of(begin), begin)) {
      begin = before ^ 1;
      if (begin / 2 == home / 2) return home;  // a ring
    }
    return begin;
  }

  void append(LineEnd from, std::vector<std::uint32_t>& strand) {
    const auto line = lines_.line(from / 2);
    done_[from / 2] = true;
    const std::size_t skipped = strand.empty() ? 0 : 1;  // The vertex where they meet.
    for (std::size_t k = skipped; k < line.size(); ++k)
      strand.push_back((from & 1) != 0 ? line[line.size() - 1 - k] : line[k]);
  }

  const VertexLines& lines_;
  std::vector<std::array<LineEnd, 2>> ends_;  ///< The first and the last line end noted at each vertex.
  std::vector<std::uint8_t> uses_;            ///< Uses by all lines, three for three or more.
  std::vector<bool> done_;
};

}  // namespace

JoinedLines joined_lines(const VertexLines& lines, std::size_t vertex_count) {
  return Joiner(lines, vertex_count).join();
}

}  // namespace coif::groom
