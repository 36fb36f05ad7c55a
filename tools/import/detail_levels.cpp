#include "base/geometry.h"
#include "base/text.h"
#include "base/words.h"
#include "import/shown_meshes.h"
#include "import/source_warnings.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace coif::importer {
namespace {

/// "hair" and 1 of "Hair_LOD1", or of "Hair_L1".
struct LevelName {
  std::string thing;
  unsigned level = 0;
  bool is_sure = false;  ///< Has the letters LOD. An L may mean the left side, whose locks are numbered.
};

constexpr std::size_t kMostDigits = 2;

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }
bool is_letter(char letter) { return std::isalpha(static_cast<unsigned char>(letter)) != 0; }
bool is_between(char letter) { return letter == '_' || letter == ' ' || letter == '-' || letter == '.'; }

/// Blender numbers names that are there already: "Hair.001".
std::string_view without_number_of_copy(std::string_view name) {
  const bool is_copy = name.size() > 4 && name[name.size() - 4] == '.' && is_digit(name[name.size() - 3]) &&
                       is_digit(name[name.size() - 2]) && is_digit(name[name.size() - 1]);
  return is_copy ? name.substr(0, name.size() - 4) : name;
}

std::string between_marks(std::string text) {
  const auto is_mark = [](char letter) { return !is_letter(letter) && !is_digit(letter); };
  while (!text.empty() && is_mark(text.back())) text.pop_back();
  text.erase(text.begin(), std::ranges::find_if_not(text, is_mark));
  return text;
}

/// The name around the mark at `begin`..`end`: the part before it, else the part after it.
std::string thing_around(const std::string& low, std::size_t begin, std::size_t end) {
  const std::string before = between_marks(low.substr(0, begin));
  return before.empty() ? between_marks(std::string(
                              without_number_of_copy(low).substr(std::min(end, without_number_of_copy(low).size()))))
                        : before;
}

bool begins_word(std::string_view name, std::size_t at) {
  return at == 0 || !is_letter(name[at - 1]) ||
         (std::isupper(static_cast<unsigned char>(name[at])) != 0 &&
          std::islower(static_cast<unsigned char>(name[at - 1])) != 0);
}

/// "LOD1": the three letters begin a word, and digits follow them.
std::optional<LevelName> level_after_lod(std::string_view name, const std::string& low) {
  for (std::size_t at = low.find("lod"); at != std::string::npos; at = low.find("lod", at + 1)) {
    std::size_t digit = at + 3;
    while (digit < low.size() && is_between(low[digit])) ++digit;
    if (!begins_word(name, at) || digit == low.size() || !is_digit(low[digit])) continue;
    std::size_t end = digit;
    while (end < low.size() && is_digit(low[end])) ++end;
    LevelName found{thing_around(low, at, end), 0, true};
    std::from_chars(&low[digit], low.data() + std::min(digit + kMostDigits, low.size()), found.level);
    return found;
  }
  return std::nullopt;
}

/// A letter that is a word by itself or with digits after it; none otherwise.
struct Mark {
  std::size_t begin, digits, end;
};
std::optional<Mark> find_mark(std::string_view name, const std::string& low, char letter) {
  for (std::size_t at = low.find(letter); at != std::string::npos; at = low.find(letter, at + 1)) {
    std::size_t end = at + 1;
    while (end < low.size() && is_digit(low[end])) ++end;
    const bool ends_word = end == low.size() || is_between(low[end]);
    if (begins_word(name, at) && ends_word) return Mark{at, at + 1, end};
  }
  return std::nullopt;
}

/// In lower case; none where the name has no level.
std::optional<LevelName> level_in(std::string_view name) {
  const std::string low = lower_case(std::string(name));
  if (auto sure = level_after_lod(name, low)) return sure;
  const auto mark = find_mark(name, low, 'l');
  if (!mark || mark->digits == mark->end || mark->end - mark->digits > kMostDigits) return std::nullopt;
  LevelName found{thing_around(low, mark->begin, mark->end)};
  std::from_chars(&low[mark->digits], low.data() + mark->end, found.level);
  return found;
}

/// "lock" of "Lock_R1" or "Lock_R": the name on the right side, so that an L in a similar name means left.
std::optional<std::string> thing_on_the_right(std::string_view name) {
  const std::string low = lower_case(std::string(name));
  const auto mark = find_mark(name, low, 'r');
  return mark ? std::optional(thing_around(low, mark->begin, mark->end)) : std::nullopt;
}

/// A level of detail of one thing.
struct Level {
  std::vector<std::size_t> meshes;
  Eigen::AlignedBox3f box;
  std::size_t triangles = 0;

  void add(const SourceModel& model, std::size_t m) {
    meshes.push_back(m);
    for (const Eigen::Vector3f& position : model.meshes[m].positions) box.extend(position);
    triangles += model.meshes[m].triangles.size() / 3;
  }
};

constexpr int kUnnumbered = -1;

struct Thing {
  std::map<int, Level> levels;  ///< By number, kUnnumbered for "Hair" beside "Hair_LOD1".
  bool is_sure = false;         ///< LevelName::is_sure.
};
using Things = std::map<std::pair<std::string, bool>, Thing>;  // By name and certainty.

const std::string& shown_name(const SourceModel& model, std::size_t m) {
  const std::string& node = model.nodes[model.meshes[m].node].name;
  return node.empty() ? model.meshes[m].name : node;
}

/// By the name of its node, of the nodes above, or its own. Certain names take precedence.
std::optional<LevelName> level_of(const SourceModel& model, const SourceMesh& mesh) {
  std::optional<LevelName> unsure;
  const auto look_at = [&](const std::string& name) {
    auto level = level_in(name);
    if (level && !level->is_sure && !unsure) unsure = level;
    return level && level->is_sure ? level : std::nullopt;
  };
  for (std::uint32_t node = mesh.node; node != kNoIndex; node = model.nodes[node].parent) {
    if (auto level = look_at(model.nodes[node].name)) return level;
  }
  if (auto level = look_at(mesh.name)) return level;
  return unsure;
}

/// Whether two boxes can be those of one shape and its simplification.
bool are_of_one_place(const Eigen::AlignedBox3f& a, const Eigen::AlignedBox3f& b) {
  constexpr float kLeastShare = 0.75f, kLeastExtent = 0.02f;
  const float thin = kLeastExtent * a.merged(b).diagonal().norm();
  return overlap_on_each_axis(a, b, kLeastShare, thin);
}

Things find_things(const SourceModel& model) {
  Things things;
  std::vector<std::size_t> unnumbered;
  for (std::size_t m = 0; m < model.meshes.size(); ++m) {
    const auto level = level_of(model, model.meshes[m]);
    if (!level) {
      unnumbered.push_back(m);
      continue;
    }
    Thing& thing = things[{level->thing, level->is_sure}];
    thing.is_sure = level->is_sure;
    thing.levels[int(level->level)].add(model, m);
  }
  for (const std::size_t m : unnumbered) {
    for (const bool is_sure : {true, false}) {
      const auto found = things.find({lower_case(shown_name(model, m)), is_sure});
      if (found != things.end() && !found->first.first.empty()) found->second.levels[kUnnumbered].add(model, m);
    }
  }
  return things;
}

/// A mesh "Hair" beside "Hair_LOD0" may be another part of the hair.
void leave_other_parts(Thing& thing) {
  const auto unnumbered = thing.levels.find(kUnnumbered), first = thing.levels.find(0);
  if (unnumbered == thing.levels.end() || first == thing.levels.end()) return;
  if (!are_of_one_place(unnumbered->second.box, first->second.box)) thing.levels.erase(unnumbered);
}

/// "Hair_L0", "Hair_L1": levels where they lie in one place and each has clearly fewer triangles than the one before.
bool looks_like_levels(const Thing& thing) {
  constexpr double kMostOfFiner = 0.9;
  const Level* finer = nullptr;
  for (const auto& [number, level] : thing.levels) {
    if (finer != nullptr &&
        (!are_of_one_place(finer->box, level.box) || double(level.triangles) > kMostOfFiner * double(finer->triangles)))
      return false;
    finer = &level;
  }
  return true;
}

bool has_wildcard(const std::string& pattern) { return pattern.find_first_of("*?") != std::string::npos; }

/// The levels of a thing that the caller names.
class Wanted {
 public:
  Wanted(std::span<const std::string> patterns, const SourceModel& model) : model_(model) {
    for (const std::string& pattern : patterns) (has_wildcard(pattern) ? patterns_ : names_).push_back(pattern);
  }
  [[nodiscard]] bool is_named(std::size_t m) const { return matches_any(model_.meshes[m].name, names_); }
  [[nodiscard]] bool is_wanted(const Level& level) const {
    return std::ranges::any_of(
        level.meshes, [&](std::size_t m) { return is_named(m) || matches_any(model_.meshes[m].name, patterns_); });
  }

 private:
  const SourceModel& model_;
  std::vector<std::string> patterns_, names_;
};

std::vector<std::string> names_of(const SourceModel& model, std::span<const std::size_t> meshes) {
  std::vector<std::string> names;
  for (const std::size_t m : meshes) names.push_back(model.meshes[m].name);
  return names;
}

/// In most tools 0 is the finest level, in some the coarsest: the number of triangles decides. Among equals the first.
const Level& finest_of(const Thing& thing, const Wanted& wanted, bool& is_chosen) {
  const Level* finest = nullptr;
  for (const bool is_for_all : {false, true}) {
    for (const auto& [number, level] : thing.levels) {
      if (!is_for_all && !wanted.is_wanted(level)) continue;
      const bool is_finer = finest == nullptr || level.triangles > finest->triangles;
      if (is_finer) finest = &level;
    }
    is_chosen = !is_for_all;
    if (finest != nullptr) break;
  }
  return *finest;
}

}  // namespace

void keep_finest_levels(std::span<const std::string> meshes, SourceModel& model) {
  std::set<std::string> on_the_right;
  for (const SourceNode& node : model.nodes) {
    if (const auto thing = thing_on_the_right(node.name)) on_the_right.insert(*thing);
  }
  const Wanted wanted(meshes, model);
  std::vector<bool> is_dropped(model.meshes.size(), false);
  Things things = find_things(model);
  for (auto& [name, thing] : things) {
    leave_other_parts(thing);
    const bool is_of_levels = thing.is_sure || (!on_the_right.contains(name.first) && looks_like_levels(thing));
    if (thing.levels.size() < 2 || !is_of_levels) continue;
    bool is_chosen = false;
    const Level& finest = finest_of(thing, wanted, is_chosen);
    std::vector<std::size_t> dropped;
    for (const auto& [number, level] : thing.levels) {
      if (&level == &finest) continue;
      std::ranges::copy_if(level.meshes, std::back_inserter(dropped),
                           [&](std::size_t m) { return !wanted.is_named(m); });
    }
    for (const std::size_t m : dropped) is_dropped[m] = true;
    if (!is_chosen) warn_of_coarser(names_of(model, dropped), names_of(model, finest.meshes), model.warnings);
  }
  std::size_t m = 0;
  std::erase_if(model.meshes, [&](const SourceMesh&) { return is_dropped[m++]; });
}

}  // namespace coif::importer
