#include "import/source_file.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <system_error>
#include <vector>

namespace coif {

namespace fs = std::filesystem;

tl::expected<void, ToolError> check_readable(const fs::path& path, std::uint64_t max_bytes) {
  using Kind = ToolError::Kind;
  std::error_code code;
  const fs::file_status status = fs::status(path, code);
  if (!fs::exists(status)) {
    return tl::unexpected(
        file_error(Kind::kFileAccess, path, "cannot open: {}; check the path", code ? code.message() : "no such file"));
  }
  if (fs::is_directory(status)) {
    return tl::unexpected(file_error(Kind::kFileAccess, path, "is a folder; name the model file in it"));
  }
  if (!fs::is_regular_file(status)) return tl::unexpected(file_error(Kind::kFileAccess, path, "is not a regular file"));
  if (!std::ifstream(path, std::ios::binary)) {
    return tl::unexpected(
        file_error(Kind::kFileAccess, path, "cannot open: {}; check its permissions", std::strerror(errno)));
  }
  const std::uintmax_t size = fs::file_size(path, code);
  if (code) return tl::unexpected(file_error(Kind::kFileAccess, path, "cannot open: {}", code.message()));
  if (size == 0) return tl::unexpected(file_error(Kind::kBadInput, path, "the file is empty; {}", kReexport));
  if (size > max_bytes) {
    return tl::unexpected(
        file_error(Kind::kBadInput, path, "{} bytes, and the limit is {}; {}", size, max_bytes, kReduce));
  }
  return {};
}

namespace {

constexpr std::string_view kBlanks = " \t\r\n";
constexpr std::uint64_t kMostArrayNumbers = std::uint64_t{1} << 32;  // more are in no file that is read

/// One start tag, without its brackets.
struct Tag {
  std::string_view text;

  std::string_view name() const { return text.substr(0, text.find_first_of(" \t\r\n/>")); }

  /// Empty where there is none.
  std::string_view attribute(std::string_view wanted) const {
    for (std::size_t at = text.find(wanted); at != text.npos; at = text.find(wanted, at + 1)) {
      const bool starts = at > 0 && kBlanks.find(text[at - 1]) != kBlanks.npos;
      const std::size_t equals = text.find_first_not_of(kBlanks, at + wanted.size());
      if (!starts || equals == text.npos || text[equals] != '=') continue;
      const std::size_t quote = text.find_first_not_of(kBlanks, equals + 1);
      if (quote == text.npos || (text[quote] != '"' && text[quote] != '\'')) return {};
      const std::size_t end = text.find(text[quote], quote + 1);
      return end == text.npos ? std::string_view{} : text.substr(quote + 1, end - quote - 1);
    }
    return {};
  }

  /// `absent` where there is none, or no number.
  std::uint64_t number(std::string_view wanted, std::uint64_t absent) const {
    const std::string_view digits = attribute(wanted);
    std::uint64_t value = absent;
    const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return result.ec == std::errc::result_out_of_range ? kMostArrayNumbers : std::min(value, kMostArrayNumbers);
  }
};

/// Takes the next start tag off the front of `rest`; a tag without text at the end.
Tag next_tag(std::string_view& rest) {
  for (;;) {
    const std::size_t open = rest.find('<');
    if (open == rest.npos) return {};
    rest.remove_prefix(open + 1);
    if (rest.starts_with("!--")) {
      const std::size_t end = rest.find("-->");
      rest.remove_prefix(end == rest.npos ? rest.size() : end);
      continue;
    }
    const std::size_t close = rest.find('>');
    if (close == rest.npos) return {};
    const Tag tag{rest.substr(0, close)};
    rest.remove_prefix(close);
    if (!tag.name().empty()) return tag;
  }
}

bool is_array(std::string_view name) { return name == "float_array" || name == "Name_array" || name == "IDREF_array"; }

/// How many numbers of its array the accessor's reader may touch.
std::uint64_t reach(const Tag& accessor) {
  const std::uint64_t count = accessor.number("count", 0), stride = accessor.number("stride", 1);
  if (count == 0) return 0;
  return std::min(count * std::min(stride, kMostArrayNumbers / count) + accessor.number("offset", 0), kMostArrayNumbers);
}

}  // namespace

std::optional<std::string> overrun_array(std::string_view document) {
  std::map<std::string_view, std::uint64_t> sizes;
  std::vector<Tag> accessors;
  for (Tag tag = next_tag(document); !tag.text.empty(); tag = next_tag(document)) {
    if (is_array(tag.name())) sizes.emplace(tag.attribute("id"), tag.number("count", 0));
    if (tag.name() == "accessor") accessors.push_back(tag);
  }
  for (const Tag& accessor : accessors) {
    const std::string_view source = accessor.attribute("source");
    const auto array = sizes.find(source.substr(source.starts_with('#') ? 1 : 0));
    if (array == sizes.end() || reach(accessor) <= array->second) continue;
    return fmt::format("an accessor reads {} numbers of the array '{}', which has {}", reach(accessor),
                       printable_text(array->first, 100), array->second);
  }
  return {};
}

}  // namespace coif
