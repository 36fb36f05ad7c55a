#include "import/clip_file.h"

#include "base/geometry.h"
#include "base/text.h"
#include "gltf/buffers.h"
#include "gltf/document.h"
#include "gltf/tree.h"
#include "import/clip_track.h"
#include "import/import.h"
#include "import/source_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <new>
#include <optional>
#include <utility>

namespace coif::importer {
namespace {

namespace fs = std::filesystem;
using Eigen::Quaterniond;
using nlohmann::json;

Quaterniond turn_of(const Eigen::Affine3d& place) { return Quaterniond(rotation_part(place)).normalized(); }

}  // namespace

std::vector<Quaterniond> PoseClip::turns(double seconds) const {
  std::vector<Quaterniond> world;
  world.reserve(nodes_.size());
  for (const Node& node : nodes_) {
    const Quaterniond own = turn_of(node.moves.at(seconds));
    world.push_back(node.parent == kNoNode ? own : Quaterniond(world[node.parent] * own));
  }
  for (std::size_t i = 0; i < rests_.size(); ++i) world[i] = world[i] * rests_[i].conjugate();
  return world;
}

std::vector<Quaterniond> PoseClip::at(double seconds) const {
  const std::vector<Quaterniond> turned = turns(seconds);
  std::vector<Quaterniond> rotations(of_bone_.size(), Quaterniond::Identity());
  for (std::size_t i = 0; i < of_bone_.size(); ++i) {
    if (of_bone_[i] == kNoNode) continue;
    rotations[i] = turned[of_bone_[i]];
    if (from_[i] != kNoNode) rotations[i] = turned[from_[i]].conjugate() * rotations[i];
    rotations[i].normalize();
  }
  return rotations;
}

std::size_t PoseClip::found() const { return of_bone_.size() - std::size_t(std::ranges::count(of_bone_, kNoNode)); }

/// Fills a PoseClip. Errors are sentences without the file's name.
class PoseReader {
 public:
  PoseReader(const fs::path& path, const json& document)
      : document_(document), tree_(document), buffers_(path, document), clip_(std::make_shared<PoseClip>()) {}

  tl::expected<std::shared_ptr<const PoseClip>, std::string> read(std::span<const PosedBone> bones) {
    for (const PosedBone& bone : bones) {
      if (auto found = find(bone); !found) return tl::unexpected(found.error());
    }
    if (clip_->found() == 0) {
      return gltf::fault(
          "no node has the name of one of the hair's {}; name the clip's nodes as 'coif info -v' names the bones",
          counted(bones.size(), "bone", "bones"));
    }
    for (std::size_t i = 0; i < bones.size(); ++i) clip_->from_.push_back(parent_frame(bones, i));
    if (auto read = read_animation(); !read) return tl::unexpected(read.error());
    for (const Respelled& name : buffers_.respelled()) clip_->notes_.push_back(told_of(name));
    clip_->rests_.clear();
    std::vector<Quaterniond> rests;
    for (const PoseClip::Node& node : clip_->nodes_) {
      const Quaterniond own = turn_of(node.moves.at_rest());
      rests.push_back(node.parent == PoseClip::kNoNode ? own : Quaterniond(rests[node.parent] * own));
    }
    clip_->rests_ = std::move(rests);
    return std::move(clip_);
  }

 private:
  /// The node of the bone, and all that it hangs on.
  tl::expected<void, std::string> find(const PosedBone& bone) {
    clip_->of_bone_.push_back(PoseClip::kNoNode);
    if (bone.name.empty()) return {};
    const std::vector<std::uint32_t> named = tree_.named(bone.name);
    if (named.size() > 1) {
      clip_->notes_.push_back(fmt::format("{} nodes are called '{}'; none of them is followed", named.size(),
                                          printable_text(bone.name, 100)));
    }
    if (named.size() != 1) return {};
    const auto chain = tree_.with_parents(named.front());
    if (!chain) return tl::unexpected(chain.error());
    std::uint32_t parent = PoseClip::kNoNode;
    for (std::size_t i = chain->size(); i-- > 0;) {
      const std::uint32_t index = (*chain)[i];
      auto [place, is_new] = places_.try_emplace(index, std::uint32_t(clip_->nodes_.size()));
      if (is_new) {
        auto moves = ClipNode::from(tree_.node(index));
        if (!moves) {
          return gltf::fault("node '{}' has a place that is not made of finite numbers; {}", tree_.label(index),
                             kExportAgain);
        }
        clip_->nodes_.push_back({parent, std::move(*moves)});
      }
      parent = place->second;
    }
    clip_->of_bone_.back() = parent;
    return {};
  }

  [[nodiscard]] std::uint32_t parent_frame(std::span<const PosedBone> bones, std::size_t bone) const {
    const std::uint32_t node = clip_->of_bone_[bone];
    if (node == PoseClip::kNoNode) return node;
    const int parent = bones[bone].parent;
    const std::uint32_t of_parent = parent < 0 ? PoseClip::kNoNode : clip_->of_bone_[std::size_t(parent)];
    return of_parent != PoseClip::kNoNode ? of_parent : clip_->nodes_[node].parent;
  }

  /// Index in the clip's nodes of the node that a channel turns; none for other channels.
  [[nodiscard]] std::optional<std::uint32_t> turned_by(const json& channel) const {
    const json& target = member(channel, "target");
    if (find_node_property(member(target, "path")) != NodeProperty::kRotation) return std::nullopt;
    const auto node = index_of(member(target, "node"), tree_.size());
    const auto found = node ? places_.find(*node) : places_.end();
    return found == places_.end() ? std::nullopt : std::optional(found->second);
  }

  [[nodiscard]] bool turns_bones(const json& animation) const {
    return std::ranges::any_of(list_of(member(animation, "channels")), [this](const json& channel) {
      const auto node = turned_by(channel);
      return node && std::ranges::find(clip_->of_bone_, *node) != clip_->of_bone_.end();
    });
  }

  tl::expected<void, std::string> read_animation() {
    const json& animations = list_of(member(document_, "animations"));
    const auto used = std::ranges::find_if(animations, [this](const json& one) { return turns_bones(one); });
    if (used == animations.end()) return gltf::fault("no animation turns a bone of the hair; {}", kExportAgain);
    for (const json& channel : list_of(member(*used, "channels"))) {
      const auto node = turned_by(channel);
      if (!node) continue;
      if (auto read = read_channel(*used, channel, clip_->nodes_[*node]); !read) return read;
    }
    return {};
  }

  tl::expected<void, std::string> read_channel(const json& animation, const json& channel, PoseClip::Node& node) {
    const json& samplers = list_of(member(animation, "samplers"));
    const auto sampler = index_of(member(channel, "sampler"), samplers.size());
    if (!sampler) return gltf::fault("no such sampler among {}; {}", samplers.size(), kExportAgain);
    auto track = read_track(document_, buffers_, samplers[*sampler], NodeProperty::kRotation);
    if (!track) return gltf::fault("a bone's rotation: {}; {}", track.error(), kExportAgain);
    numbers_ += track->seconds.size() + track->values.size();
    if (numbers_ > kMostClipNumbers) {
      return gltf::fault("more than {} numbers of animation; export a shorter clip", kMostClipNumbers);
    }
    if (node.moves.animate(NodeProperty::kRotation, std::move(*track))) return {};
    return gltf::fault("a bone is animated twice, or given as a matrix; {}", kExportAgain);
  }

  const json& document_;
  gltf::GltfTree tree_;
  gltf::GltfBuffers buffers_;
  std::shared_ptr<PoseClip> clip_;
  std::map<std::uint32_t, std::uint32_t> places_;  ///< From the document's nodes to the clip's.
  std::size_t numbers_ = 0;
};

tl::expected<std::shared_ptr<const PoseClip>, ToolError> read_pose_clip(const fs::path& path,
                                                                        std::span<const PosedBone> bones) try {
  const auto document = read_clip_document(path);
  if (!document) return tl::unexpected(document.error());
  auto clip = PoseReader(path, *document).read(bones);
  if (!clip) return file_failure(ToolError::Kind::kBadInput, path, "{}", clip.error());
  return std::move(*clip);
} catch (const std::bad_alloc&) {
  return file_failure(ToolError::Kind::kBadInput, path, "not enough memory for this clip");
}

}  // namespace coif::importer
