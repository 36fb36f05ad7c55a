#include "import/gltf_document.h"

#include "import/source_model.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <unordered_map>

namespace coif {
namespace {

using nlohmann::json;

struct Pair {
  std::uint32_t in_file;
  std::uint32_t in_source;
};

class NodeMatcher {
 public:
  NodeMatcher(const json& document, const std::vector<SourceNode>& nodes)
      : document_(document),
        in_file_(list_of(member(document, "nodes"))),
        nodes_(nodes),
        children_(nodes.size()),
        source_of_(in_file_.size(), kNoIndex) {
    for (std::uint32_t n = 0; n < nodes.size(); ++n) {
      if (nodes[n].parent != kNoIndex) children_[nodes[n].parent].push_back(n);
    }
  }

  std::vector<std::uint32_t> match() && {
    if (nodes_.empty()) return std::move(source_of_);
    start_at_roots();
    while (!pending_.empty()) {
      const Pair next = pending_.back();
      pending_.pop_back();
      follow(next);
    }
    match_rest_by_name();
    return std::move(source_of_);
  }

 private:
  void start_at_roots() {
    const json& scenes = list_of(member(document_, "scenes"));
    const json& chosen = member(document_, "scene");
    const std::optional<std::uint32_t> scene = chosen.is_null() ? 0 : index_of(chosen, scenes.size());
    if (!scene || *scene >= scenes.size()) return;
    const json& roots = list_of(member(scenes[*scene], "nodes"));
    if (roots.size() != 1) return pair_up(roots, children_[0]);
    if (const auto root = index_of(roots[0], in_file_.size())) pending_.push_back({*root, 0});
  }

  void pair_up(const json& in_file, const std::vector<std::uint32_t>& in_source) {
    if (in_file.size() != in_source.size()) return;
    for (std::size_t i = 0; i < in_source.size(); ++i) {
      const auto index = index_of(in_file[i], in_file_.size());
      if (index) pending_.push_back({*index, in_source[i]});
    }
  }

  // Each node of the source is followed once, so a document whose nodes contain each other ends here too.
  void follow(const Pair& pair) {
    const json& node = in_file_[pair.in_file];
    const std::string name = printable_text_of(member(node, "name"));
    if (!name.empty() && name != nodes_[pair.in_source].name) return;
    if (source_of_[pair.in_file] == kNoIndex) source_of_[pair.in_file] = pair.in_source;
    pair_up(list_of(member(node, "children")), children_[pair.in_source]);
  }

  void match_rest_by_name() {
    std::unordered_map<std::string, std::uint32_t> in_source;  // looked up only; kNoIndex: several
    for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
      const auto [entry, is_new] = in_source.emplace(nodes_[n].name, n);
      if (!is_new) entry->second = kNoIndex;
    }
    std::unordered_map<std::string, std::uint32_t> times_in_file;
    for (const json& node : in_file_) ++times_in_file[printable_text_of(member(node, "name"))];
    for (std::size_t i = 0; i < source_of_.size(); ++i) {
      const std::string name = printable_text_of(member(in_file_[i], "name"));
      const auto found = in_source.find(name);
      const bool unmistakable = !name.empty() && times_in_file[name] == 1 && found != in_source.end();
      if (source_of_[i] == kNoIndex && unmistakable) source_of_[i] = found->second;
    }
  }

  const json& document_;
  const json& in_file_;
  const std::vector<SourceNode>& nodes_;
  std::vector<std::vector<std::uint32_t>> children_;
  std::vector<std::uint32_t> source_of_;
  std::vector<Pair> pending_;
};

}  // namespace

std::vector<std::uint32_t> match_gltf_nodes(const json& document, const std::vector<SourceNode>& nodes) {
  return NodeMatcher(document, nodes).match();
}

}  // namespace coif
