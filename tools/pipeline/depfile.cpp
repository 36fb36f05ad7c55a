#include "pipeline/depfile.h"

#include <set>

namespace coif {
namespace {

namespace fs = std::filesystem;

/// As Make and Ninja read it back: a backslash is itself unless it precedes a blank or a hash, where each of a row of them
/// counts half.
std::string escaped(const std::string& path) {
  std::string text;
  std::size_t backslashes = 0;
  for (const char c : path) {
    if (c == ' ' || c == '#') text.append(backslashes + 1, '\\');
    if (c == '$') text += '$';
    text += c;
    backslashes = c == '\\' ? backslashes + 1 : 0;
  }
  return text;
}

}  // namespace

tl::expected<std::string, ToolError> depfile_text(const fs::path& target, std::span<const fs::path> inputs) {
  std::set<std::string> seen;
  std::string text = escaped(target.string()) + ":";
  std::string all = target.string();
  for (const fs::path& input : inputs) {
    std::error_code error;
    if (!fs::exists(input, error) || !seen.insert(input.string()).second) continue;
    text += " \\\n  " + escaped(input.string());
    all += input.string();
  }
  if (all.find_first_of("\r\n") == std::string::npos) return text + "\n";
  return tl::unexpected(ToolError{ToolError::Kind::kUsage,
                                  target.string() + ": a path with a line break cannot stand in a depfile; rename it"});
}

}  // namespace coif
