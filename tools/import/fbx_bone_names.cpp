#include "import/fbx_objects.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace coif::importer {
namespace {

/// Models that a cluster binds a mesh to, by name, each once.
std::map<std::string_view, std::vector<const FbxObject*>> bones_by_name(const FbxObjects& objects) {
  std::map<std::string_view, std::vector<const FbxObject*>> bones;
  std::set<const FbxObject*> known;
  for (const FbxObject& cluster : objects.all()) {
    if (cluster.kind != FbxKind::kCluster) continue;
    for (const FbxConnection& connection : objects.below(cluster.id)) {
      const FbxObject* const model = objects.find(connection.from);
      if (model != nullptr && model->kind == FbxKind::kModel && known.insert(model).second)
        bones[model->name].push_back(model);
    }
  }
  return bones;
}

/// Names of the same length as `name` that nobody has, one after the other.
class OtherNames {
 public:
  OtherNames(std::string_view name, std::set<std::string, std::less<>>& taken) : name_(name), taken_(taken) {}

  /// "" where none is left.
  std::string next() {
    constexpr std::string_view kDigits = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ";
    constexpr std::size_t kMostIdDigits = 3;
    const std::size_t digits = std::min(kMostIdDigits, name_.size());
    for (std::string other = name_;;) {
      std::size_t rest = number_++;
      for (std::size_t k = 0; k < digits; ++k, rest /= kDigits.size())
        other[other.size() - 1 - k] = kDigits[rest % kDigits.size()];
      if (rest != 0) return {};
      if (taken_.insert(other).second) return other;
    }
  }

 private:
  std::string name_;
  std::set<std::string, std::less<>>& taken_;
  std::size_t number_ = 0;
};

}  // namespace

std::optional<UniqueFbxBones> with_unique_bones(const FbxObjects& objects, std::string_view file) {
  std::set<std::string, std::less<>> taken;
  for (const FbxObject& object : objects.all()) taken.emplace(object.name);
  UniqueFbxBones out;
  for (const auto& [name, bones] : bones_by_name(objects)) {
    OtherNames others(name, taken);
    for (std::size_t i = 1; i < bones.size(); ++i) {
      const std::string other = others.next();
      if (other.empty()) break;
      if (out.file.empty()) out.file = file;
      out.file.replace(std::size_t(bones[i]->name.data() - file.data()), other.size(), other);
      out.names.emplace(bones[i]->id, name);
    }
  }
  return out.names.empty() ? std::nullopt : std::optional(std::move(out));
}

}  // namespace coif::importer
