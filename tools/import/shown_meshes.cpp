#include "import/shown_meshes.h"

#include "base/text.h"
#include "import/source_warnings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <map>
#include <optional>
#include <string_view>

namespace coif {
namespace {

constexpr std::size_t kShownNames = 6;

std::string list_of_names(std::span<const std::string> names) {
  return fmt::format("'{}'{}", fmt::join(names.first(std::min(names.size(), kShownNames)), "', '"),
                     names.size() > kShownNames ? " ..." : "");
}

char lower(char letter) { return char(std::tolower(static_cast<unsigned char>(letter))); }
bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }
bool is_letter(char letter) { return std::isalpha(static_cast<unsigned char>(letter)) != 0; }

/// "hair" and 1 of "Hair_LOD1": what the name says of a level of detail. The three letters stand alone, and digits follow them.
struct LevelName {
  std::string thing;
  unsigned level = 0;
};
std::optional<LevelName> level_in(std::string_view name) {
  std::string low(name);
  std::ranges::transform(low, low.begin(), lower);
  for (std::size_t at = low.find("lod"); at != std::string::npos; at = low.find("lod", at + 1)) {
    const bool begins_word =
        at == 0 || !is_letter(name[at - 1]) || (name[at] == 'L' && name[at - 1] == lower(name[at - 1]));
    std::size_t digit = at + 3;
    while (digit < low.size() && (low[digit] == '_' || low[digit] == ' ' || low[digit] == '-' || low[digit] == '.'))
      ++digit;
    if (!begins_word || digit == low.size() || !is_digit(low[digit])) continue;
    std::size_t end = at;
    while (end > 0 && !is_letter(low[end - 1]) && !is_digit(low[end - 1])) --end;
    LevelName found{low.substr(0, end)};
    std::from_chars(&low[digit], low.data() + std::min(digit + 2, low.size()), found.level);
    return found;
  }
  return std::nullopt;
}

/// By the node that carries it, those above that one, or its own name.
std::optional<LevelName> level_of(const SourceModel& model, const SourceMesh& mesh) {
  for (std::uint32_t node = mesh.node; node != kNoIndex; node = model.nodes[node].parent) {
    if (auto level = level_in(model.nodes[node].name)) return level;
  }
  return level_in(mesh.name);
}

}  // namespace

void warn_of_hidden(std::span<const std::string> nodes, std::vector<Warning>& warnings) {
  if (nodes.empty()) return;
  warn(warnings, source_code::kHidden,
       "{} left out, since the file hides {}: {}; show {} and export again where {} hair",
       counted(nodes.size(), "mesh", "meshes"), nodes.size() == 1 ? "it" : "them", list_of_names(nodes),
       nodes.size() == 1 ? "it" : "them", nodes.size() == 1 ? "it is" : "they are");
}

void warn_of_coarser(std::span<const std::string> meshes, std::vector<Warning>& warnings) {
  if (meshes.empty()) return;
  warn(warnings, source_code::kCoarser,
       "{} left out as coarser levels of detail of what is there in a finer one: {}; the "
       "cook makes levels of its own",
       counted(meshes.size(), "mesh", "meshes"), list_of_names(meshes));
}

void warn_of_shape_keys(const std::string& mesh, std::span<const std::string> on, std::vector<Warning>& warnings) {
  if (on.empty()) return;
  warn(warnings, source_code::kShapeKeys,
       "mesh '{}': shape keys are on ({}) and are part of the hair's shape; turn them off and export again "
       "where that is not meant",
       mesh, fmt::join(on, ", "));
}

namespace {

using FinestLevels = std::map<std::string, unsigned>;

/// A mesh "Hair" beside "Hair_LOD1" is its level 0, unless there is a "Hair_LOD0".
void find_unnumbered_levels(const SourceModel& model, std::vector<std::optional<LevelName>>& levels,
                            FinestLevels& finest) {
  for (std::size_t m = 0; m < model.meshes.size(); ++m) {
    if (levels[m]) continue;
    const std::string& node = model.nodes[model.meshes[m].node].name;
    std::string name = node.empty() ? model.meshes[m].name : node;
    std::ranges::transform(name, name.begin(), lower);
    const auto known = finest.find(name);
    if (!name.empty() && known != finest.end() && known->second > 0) levels[m] = LevelName{name, 0};
  }
  for (const auto& level : levels) {
    if (level) finest[level->thing] = std::min(finest[level->thing], level->level);
  }
}

void keep_finest_levels(SourceModel& model) {
  std::vector<std::optional<LevelName>> levels;
  FinestLevels finest;
  for (const SourceMesh& mesh : model.meshes) {
    levels.push_back(level_of(model, mesh));
    if (!levels.back()) continue;
    const auto [known, is_new] = finest.emplace(levels.back()->thing, levels.back()->level);
    known->second = std::min(known->second, levels.back()->level);
  }
  find_unnumbered_levels(model, levels, finest);
  std::vector<std::string> dropped;
  std::vector<SourceMesh> kept;
  for (std::size_t m = 0; m < model.meshes.size(); ++m) {
    if (levels[m] && levels[m]->level > finest[levels[m]->thing]) {
      dropped.push_back(model.meshes[m].name);
    } else {
      kept.push_back(std::move(model.meshes[m]));
    }
  }
  model.meshes = std::move(kept);
  warn_of_coarser(dropped, model.warnings);
}

}  // namespace

tl::expected<void, ToolError> keep_shown_meshes(const std::filesystem::path& path, bool hides_all, SourceModel& model) {
  using Kind = ToolError::Kind;
  if (model.meshes.empty() && hides_all)
    return file_failure(Kind::kBadInput, path, "hides all of its meshes; show the hair and export again");
  if (model.meshes.empty()) {
    return file_failure(Kind::kBadInput, path,
                        "no usable triangles; convert curves and hair particles to polygon strips before the export");
  }
  keep_finest_levels(model);
  return {};
}

}  // namespace coif
