#include "import/raw_mesh.h"
#include "import/source_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coif::importer {
namespace {

constexpr float kRounding = 1e-4f;  // Exporters leave values this far below 0 for a weight of 0.

}  // namespace

SkinBinding::SkinBinding(const RawMesh& mesh, std::uint32_t mesh_node, std::span<const SourceNode> nodes,
                         const std::string& label, Diagnostics& warnings)
    : model_from_node_(nodes[mesh_node].model_from_node * mesh.node_from_mesh) {
  if (mesh.bones.empty()) return;
  palette_.assign(nodes.size(), Eigen::Affine3d::Identity());
  for (const RawBone& bone : mesh.bones) palette_[bone.node] = nodes[bone.node].model_from_node * bone.bone_from_mesh;
  std::vector<Weight> weights = collect_weights(mesh, label, warnings);
  if (weights.empty()) {
    warn(warnings, source_code::kSkin, "{}: no usable bone weight; the mesh is taken as rigid", label);
    return;
  }
  build_table(weights, mesh.positions.size(), mesh_node, label, warnings);
}

std::vector<SkinBinding::Weight> SkinBinding::collect_weights(const RawMesh& mesh, const std::string& label,
                                                              Diagnostics& warnings) {
  std::vector<Weight> weights;
  std::size_t without_vertex = 0;
  std::size_t without_bone = 0;
  std::size_t unusable = 0;
  for (const RawWeight& weight : mesh.weights) {
    if (weight.vertex >= mesh.positions.size()) {
      ++without_vertex;
    } else if (!std::isfinite(weight.weight) || weight.weight < -kRounding) {
      ++unusable;
    } else if (weight.weight > 0) {  // exporters pad with zeros, of any bone; not worth a warning
      if (weight.bone >= mesh.bones.size()) {
        ++without_bone;
      } else {
        weights.push_back({weight.vertex, {mesh.bones[weight.bone].node, weight.weight}});
      }
    }
  }
  warn_count(warnings, source_code::kSkin, without_vertex, label, "bone weights of absent vertices dropped");
  warn_count(warnings, source_code::kSkin, without_bone, label, "bone weights of absent bones dropped");
  warn_count(warnings, source_code::kSkin, unusable, label, "bone weights below zero or not finite dropped");
  return weights;
}

void SkinBinding::build_table(std::vector<Weight>& weights, std::size_t vertex_count, std::uint32_t mesh_node,
                              const std::string& label, Diagnostics& warnings) {
  // Stable: equal weights keep the file's order on every platform.
  std::ranges::stable_sort(weights, {}, [](const Weight& w) { return std::pair(w.vertex, w.influence.node); });
  begin_.reserve(vertex_count + 1);
  unweighted_.assign(vertex_count, false);
  begin_.push_back(0);
  std::size_t first = 0;
  std::size_t without = 0;
  for (std::uint32_t vertex = 0; vertex < vertex_count; ++vertex) {
    std::size_t last = first;
    while (last < weights.size() && weights[last].vertex == vertex) ++last;
    if (first == last) {
      influences_.push_back({mesh_node, 1.0f});
      unweighted_[vertex] = true;
      ++without;
    } else {
      append_vertex({&weights[first], last - first});
    }
    begin_.push_back(static_cast<std::uint32_t>(influences_.size()));
    first = last;
  }
  warn_count(warnings, source_code::kSkin, without, label, "vertices without a bone weight follow the mesh's node");
}

// `weights` of one vertex, by node: merges the entries of one node, normalises, sorts the heaviest first.
void SkinBinding::append_vertex(std::span<const Weight> weights) {
  const std::size_t start = influences_.size();
  double sum = 0;
  for (const Weight& weight : weights) sum += double{weight.influence.weight};
  for (const Weight& weight : weights) {
    const auto share = static_cast<float>(double{weight.influence.weight} / sum);
    if (influences_.size() > start && influences_.back().node == weight.influence.node) {
      influences_.back().weight += share;
    } else if (share > 0) {  // One that is tiny relative to the others rounds to zero.
      influences_.push_back({weight.influence.node, share});
    }
  }
  const auto own = std::span(influences_).subspan(start);
  std::ranges::stable_sort(own, std::ranges::greater{}, &SourceInfluence::weight);
}

std::span<const SourceInfluence> SkinBinding::influences(std::size_t vertex) const {
  if (begin_.empty()) return {};
  return std::span(influences_).subspan(begin_[vertex], begin_[vertex + 1] - begin_[vertex]);
}

Eigen::Affine3d SkinBinding::model_from_mesh(std::size_t vertex) const {
  if (begin_.empty() || unweighted_[vertex]) return model_from_node_;
  Eigen::Affine3d blended;
  blended.matrix().setZero();
  for (const SourceInfluence& influence : influences(vertex)) {
    blended.matrix() += double{influence.weight} * palette_[influence.node].matrix();
  }
  blended.makeAffine();
  return blended;
}

}  // namespace coif::importer
