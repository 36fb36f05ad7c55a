#include "groom/strand_files.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

namespace coif::groom {
namespace {

constexpr std::size_t kMostVertices = kMostStrandPoints;

/// The words of one line of the document, from its left.
class Words {
 public:
  explicit Words(std::string_view line) : left_(line) {}

  /// Empty at the end.
  std::string_view next() {
    const std::size_t begin = left_.find_first_not_of(" \t\r");
    if (begin == left_.npos) return left_ = {};
    const std::size_t end = std::min(left_.find_first_of(" \t\r", begin), left_.size());
    const std::string_view word = left_.substr(begin, end - begin);
    left_.remove_prefix(end);
    return word;
  }

  [[nodiscard]] std::string_view rest() const {
    const std::size_t begin = left_.find_first_not_of(" \t\r");
    return begin == left_.npos ? std::string_view() : left_.substr(begin, left_.find_last_not_of(" \t\r") + 1 - begin);
  }

 private:
  std::string_view left_;
};

template <class Number>
std::optional<Number> number(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size() && !word.empty() ? std::optional(value)
                                                                                   : std::nullopt;
}

/// Vertices and, by objects and groups, lines.
class LineDocument {
 public:
  /// The error names the line of text.
  tl::expected<void, std::string> read(std::string_view text) {
    std::size_t number_of_line = 0;
    std::string joined;  // Joins lines that end in a backslash.
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      std::string_view line = text.substr(0, end);
      text.remove_prefix(std::min(end + 1, text.size()));
      ++number_of_line;
      if (line.ends_with('\r')) line.remove_suffix(1);
      if (line.ends_with('\\') && !text.empty()) {
        joined.append(line.substr(0, line.size() - 1)).append(" ");
        continue;
      }
      if (!joined.empty()) line = joined.append(line);
      if (std::string fault = read_line(line); !fault.empty()) {
        return tl::unexpected(fmt::format("line {}: {}", number_of_line, fault));
      }
      joined.clear();
    }
    return {};
  }

  [[nodiscard]] const std::vector<Eigen::Vector3f>& vertices() const { return vertices_; }
  [[nodiscard]] const VertexLines& lines() const { return lines_; }
  /// The object or group of a line.
  [[nodiscard]] std::uint32_t part_of(std::uint32_t line) const { return part_of_line_[line]; }
  [[nodiscard]] const std::string& part_name(std::uint32_t part) const { return part_names_[part]; }

 private:
  std::string read_line(std::string_view line) {
    Words words(line);
    const std::string_view what = words.next();
    if (what == "v") return read_vertex(words);
    if (what == "l") return read_vertices_of_line(words);
    if (what == "o" || what == "g") begin_part(words.rest());
    return {};
  }

  std::string read_vertex(Words& words) {
    if (vertices_.size() >= kMostVertices) return fmt::format("more than {} vertices", kMostVertices);
    Eigen::Vector3f vertex;
    for (int k = 0; k < 3; ++k) {
      const std::string_view word = words.next();
      const auto value = number<float>(word);
      if (!value) return fmt::format("a vertex needs three numbers, not '{}'", printable_text(word, 40));
      vertex[k] = *value;
    }
    vertices_.push_back(vertex);
    return {};
  }

  std::string read_vertices_of_line(Words& words) {
    line_.clear();
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
      const auto index = number<std::int64_t>(word.substr(0, word.find('/')));  // behind it a texture's coordinate
      const auto count = std::int64_t(vertices_.size());
      if (!index || *index == 0 || *index > count || *index < -count) {
        return fmt::format("'{}' is none of the {} vertices so far", printable_text(word, 40), count);
      }
      line_.push_back(std::uint32_t(*index > 0 ? *index - 1 : count + *index));
    }
    if (line_.size() < 2) return "a line needs two vertices";
    if (lines_.vertices.size() + line_.size() > kMostVertices)
      return fmt::format("lines of more than {} vertices", kMostVertices);
    lines_.add(line_);
    part_of_line_.push_back(std::uint32_t(part_names_.size() - 1));
    return {};
  }

  /// The name of one without lines is taken by the next.
  void begin_part(std::string_view name) {
    const bool is_used = !part_of_line_.empty() && part_of_line_.back() + 1 == part_names_.size();
    if (is_used) part_names_.emplace_back();
    part_names_.back() = printable_text(name, 200);
  }

  std::vector<Eigen::Vector3f> vertices_;
  VertexLines lines_;
  std::vector<std::uint32_t> part_of_line_;
  std::vector<std::string> part_names_{std::string()};
  std::vector<std::uint32_t> line_;
};

}  // namespace

tl::expected<Groom, std::string> read_obj_lines(std::string_view text) {
  LineDocument document;
  if (auto read = document.read(text); !read) return tl::unexpected(read.error());
  Groom groom;
  groom.format = "Wavefront OBJ";
  groom.space.up = importer::Statement::kUnsaid;
  groom.space.up_words = "OBJ says nothing of its axes";
  groom.space.unit = importer::Statement::kUnsaid;
  groom.space.unit_words = "OBJ has no unit";
  GroomBuilder builder(groom);
  const JoinedLines joined = joined_lines(document.lines(), document.vertices().size());
  std::uint32_t part = importer::kNoIndex;
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = 0; i < joined.strands.count(); ++i) {
    if (document.part_of(joined.first_line[i]) != part) {
      part = document.part_of(joined.first_line[i]);
      builder.begin_group(document.part_name(part));
    }
    points.clear();
    for (const std::uint32_t v : joined.strands.line(i)) points.push_back(document.vertices()[v]);
    builder.add(points);
  }
  if (std::string fault = builder.finish(); !fault.empty()) return tl::unexpected(std::move(fault));
  return groom;
}

}  // namespace coif::groom
