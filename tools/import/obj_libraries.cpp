#include "base/text.h"
#include "import/asked_files.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <system_error>
#include <utility>

namespace coif::importer {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBlanks = " \t\r";
// The keywords in the spelling that assimp knows.
constexpr std::string_view kKeywords[] = {"newmtl", "map_Kd", "map_Ka",   "map_Ks", "map_Ke",
                                          "map_Ns", "map_d",  "map_bump", "map_Tr"};
constexpr std::string_view kOfNumbers[] = {"Ka", "Kd", "Ks", "Ke", "Tf", "Ns", "Ni", "Tr", "d", "illum"};

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

bool names_image(std::string_view keyword) {
  return keyword.starts_with("map_") || keyword == "bump" || keyword == "norm" || keyword == "disp" ||
         keyword == "decal" || keyword == "refl";
}

const std::string_view* find_keyword(std::span<const std::string_view> keywords, const std::string& word) {
  const auto found = std::ranges::find_if(
      keywords, [&](std::string_view name) { return lower_case(std::string(name)) == lower_case(word); });
  return found == keywords.end() ? nullptr : &*found;
}

bool begins_with_number(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  if (text.starts_with('.')) text.remove_prefix(1);
  return !text.empty() && text.front() >= '0' && text.front() <= '9';
}

std::string plain_statement(std::string_view line) {
  line = trimmed(line);
  const std::size_t end = std::min(line.find_first_of(kBlanks), line.size());
  std::string keyword(line.substr(0, end)), rest(line.substr(end));
  if (const auto* const known = find_keyword(kKeywords, keyword)) keyword = *known;
  if (names_image(lower_case(keyword))) std::erase(rest, '"');
  if (const auto* const known = find_keyword(kOfNumbers, keyword)) {
    keyword = *known;
    constexpr std::string_view kHalo = "-halo";
    if (trimmed(rest).starts_with(kHalo)) rest = ' ' + std::string(trimmed(trimmed(rest).substr(kHalo.size())));
    if (!begins_with_number(trimmed(rest))) return {};
  }
  return keyword + rest;
}

/// The end of the line that begins at `at`, and the start of the next one.
std::pair<std::size_t, std::size_t> end_of_line(std::string_view text, std::size_t at) {
  const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
  const bool is_pair = text.substr(end).starts_with("\r\n");
  return {end, std::min(end + (is_pair ? 2 : 1), text.size())};
}

std::string_view without_quotes(std::string_view name) {
  const bool is_quoted = name.size() > 1 && name.front() == '"' && name.back() == '"';
  return is_quoted ? name.substr(1, name.size() - 2) : name;
}

/// "a.mtl my b.mtl": each name ends with the suffix.
std::vector<std::string> names_in(std::string_view written) {
  constexpr std::string_view kSuffix = ".mtl";
  std::vector<std::string> names;
  const std::string low = lower_case(std::string(written));
  std::size_t begin = 0;
  for (std::size_t at = low.find(kSuffix); at != std::string::npos; at = low.find(kSuffix, at + 1)) {
    std::size_t end = at + kSuffix.size();
    if (end < low.size() && low[end] == '"') ++end;
    if (end < low.size() && kBlanks.find(low[end]) == std::string_view::npos) continue;
    names.emplace_back(without_quotes(trimmed(written.substr(begin, end - begin))));
    begin = end;
  }
  return names;
}

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

}  // namespace

std::string plain_library_text(std::string_view bytes) {
  if (bytes.starts_with(kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());
  std::string text, statement;
  for (std::size_t at = 0; at < bytes.size();) {
    const auto [end, next] = end_of_line(bytes, at);
    std::string_view line = trimmed(bytes.substr(at, end - at));
    at = next;
    const bool goes_on = line.ends_with('\\');
    if (goes_on) line.remove_suffix(1);
    statement += line;
    if (goes_on) {
      statement += ' ';
      continue;
    }
    text += plain_statement(statement) + '\n';
    statement.clear();
  }
  return statement.empty() ? text : text + plain_statement(statement) + '\n';
}

ObjLibraries find_libraries(const fs::path& folder, std::string_view written) {
  const std::string_view name = without_quotes(trimmed(written));
  for (const std::string& spelling : {std::string(written), std::string(name)}) {
    if (is_file(folder / spelling)) return {{folder / spelling}};
  }
  std::vector<std::string> names = names_in(written);
  if (names.size() < 2) names = {std::string(name)};
  ObjLibraries out;
  for (const std::string& each : names) {
    for (const std::string& spelling : {each, utf8_of(each)}) {
      const SideFile found = find_side_file(folder, spelling);
      if (!is_file(found.path)) continue;
      out.paths.push_back(found.path);
      out.is_respelled = out.is_respelled || found.is_respelled || spelling != each;
      break;
    }
  }
  return out;
}

}  // namespace coif::importer
