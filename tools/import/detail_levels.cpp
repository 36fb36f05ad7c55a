#include "base/side_file.h"
#include "base/text.h"
#include "import/level_names.h"
#include "import/shown_meshes.h"
#include "import/source_warnings.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <vector>

namespace coif {
namespace {

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
using Things = std::map<std::pair<std::string, bool>, Thing>;  // by name and whether that is sure

const std::string& shown_name(const SourceModel& model, std::size_t m) {
  const std::string& node = model.nodes[model.meshes[m].node].name;
  return node.empty() ? model.meshes[m].name : node;
}

/// By the node that carries it, those above that one, or its own name. What is sure goes before what is not.
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

/// Whether two boxes are those of one shape, one of them simplified.
bool are_of_one_place(const Eigen::AlignedBox3f& a, const Eigen::AlignedBox3f& b) {
  constexpr float kLeastShare = 0.75f, kLeastExtent = 0.02f;
  const float thin = kLeastExtent * a.merged(b).diagonal().norm();
  for (int axis = 0; axis < 3; ++axis) {
    const float common = std::min(a.max()[axis], b.max()[axis]) - std::max(a.min()[axis], b.min()[axis]) + thin;
    const float both = std::max(a.max()[axis], b.max()[axis]) - std::min(a.min()[axis], b.min()[axis]) + thin;
    if (!(common >= kLeastShare * both)) return false;
  }
  return true;
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

/// What the caller names of a thing's levels.
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

/// Numbers begin with 0 for the finest in most tools, and with 0 for the coarsest in some: triangles tell. Of equals the first.
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

}  // namespace coif
