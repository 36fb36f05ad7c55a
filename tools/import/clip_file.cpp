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
#include <fmt/ranges.h>

#include <algorithm>
#include <new>
#include <set>
#include <utility>

namespace coif::importer {
namespace {

namespace fs = std::filesystem;
using Eigen::Affine3d;
using nlohmann::json;

template <class T>
using Expected = tl::expected<T, std::string>;  ///< The error without the file's name.

constexpr double kLeastSpan = 1.0e-4;  ///< Seconds; the promise of ClipFile::keys.

/// Reads a clip: one node and its parents, and the channels that move them.
class ClipReader {
 public:
  ClipReader(const fs::path& path, const json& document)
      : document_(document),
        animations_(list_of(member(document, "animations"))),
        tree_(document),
        buffers_(path, document) {}

  Expected<ClipFile> read(std::string_view name) {
    const auto index = find(name);
    if (!index) return tl::unexpected(index.error());
    clip_.node = tree_.label(*index);
    auto chain = tree_.with_parents(*index);
    if (!chain) return tl::unexpected(chain.error());
    chain_ = std::move(*chain);
    if (auto read = read_nodes(); !read) return tl::unexpected(read.error());
    if (auto read = read_tracks(); !read) return tl::unexpected(read.error());
    if (auto sampled = sample(); !sampled) return tl::unexpected(sampled.error());
    return std::move(clip_);
  }

 private:
  /// The property of a node's transform that a channel moves.
  struct Target {
    std::uint32_t node;
    NodeProperty property;
  };
  [[nodiscard]] std::optional<Target> target_of(const json& channel) const {
    const json& target = member(channel, "target");
    const auto node = index_of(member(target, "node"), tree_.size());
    const auto property = find_node_property(member(target, "path"));
    return node && property ? std::optional(Target{*node, *property}) : std::nullopt;
  }

  [[nodiscard]] std::set<std::uint32_t> animated_nodes() const {
    std::set<std::uint32_t> nodes;
    for (const json& animation : animations_) {
      for (const json& channel : list_of(member(animation, "channels"))) {
        if (const auto target = target_of(channel)) nodes.insert(target->node);
      }
    }
    return nodes;
  }

  /// Some of the labels, for a message.
  [[nodiscard]] std::string list_of_labels(const std::set<std::uint32_t>& nodes) const {
    constexpr std::size_t kShown = 8;
    std::vector<std::string> labels;
    for (const std::uint32_t node : nodes) {
      labels.push_back(labels.size() < kShown ? fmt::format("'{}'", tree_.label(node)) : "...");
      if (labels.size() > kShown) break;
    }
    return fmt::format("{}", fmt::join(labels, ", "));
  }

  [[nodiscard]] Expected<std::uint32_t> find(std::string_view name) const {
    const std::set<std::uint32_t> animated = animated_nodes();
    if (animated.empty()) return gltf::fault("no animation moves a node; {} with its animation", kExportAgain);
    if (name.empty()) {
      if (animated.size() == 1) return *animated.begin();
      return gltf::fault("{} nodes are animated: {}; name the head's, as in CLIP:NODE", animated.size(),
                         list_of_labels(animated));
    }
    const std::vector<std::uint32_t> named = tree_.named(name);
    if (named.size() == 1) return named.front();
    const std::string shown = printable_text(name, 100);
    if (named.empty()) {
      return gltf::fault("no node '{}'; animated are {}", shown, list_of_labels(animated));
    }
    return gltf::fault("{} nodes are called '{}'; rename all but the head's", named.size(), shown);
  }

  Expected<void> read_nodes() {
    for (const std::uint32_t index : chain_) {
      auto node = ClipNode::from(tree_.node(index));
      if (!node) {
        return gltf::fault("node '{}' has a place that is not made of finite numbers; {}", tree_.label(index),
                           kExportAgain);
      }
      nodes_.push_back(std::move(*node));
    }
    return {};
  }

  [[nodiscard]] bool moves_chain(const json& channel) const {
    const auto target = target_of(channel);
    return target && std::ranges::find(chain_, target->node) != chain_.end();
  }
  [[nodiscard]] std::string animation_label(std::size_t index) const {
    const std::string name = printable_text_of(member(animations_[index], "name"));
    return name.empty() ? fmt::format("animation {}", index) : fmt::format("animation '{}'", name);
  }

  Expected<void> read_tracks() {
    std::optional<std::size_t> used;
    for (std::size_t i = 0; i < animations_.size(); ++i) {
      const json& channels = list_of(member(animations_[i], "channels"));
      if (std::ranges::none_of(channels, [this](const json& channel) { return moves_chain(channel); })) continue;
      if (used) {
        clip_.notes.push_back(fmt::format("{} moves '{}' too; only the first, {}, is used", animation_label(i),
                                          clip_.node, animation_label(*used)));
        break;
      }
      used = i;
      for (const json& channel : channels) {
        if (!moves_chain(channel)) continue;
        if (auto read = read_channel(i, channel); !read) return read;
      }
    }
    for (const Respelled& name : buffers_.respelled()) clip_.notes.push_back(told_of(name));
    if (used) return {};
    return gltf::fault("node '{}' does not move; animated are {}", clip_.node, list_of_labels(animated_nodes()));
  }

  Expected<void> read_channel(std::size_t animation, const json& channel) {
    const Target target = *target_of(channel);
    const std::string where = fmt::format("{}, {} of node '{}'", animation_label(animation), name_of(target.property),
                                          tree_.label(target.node));
    const json& samplers = list_of(member(animations_[animation], "samplers"));
    const auto sampler = index_of(member(channel, "sampler"), samplers.size());
    if (!sampler) return gltf::fault("{}: no such sampler among {}; {}", where, samplers.size(), kExportAgain);
    auto track = read_track(document_, buffers_, samplers[*sampler], target.property);
    if (!track) return gltf::fault("{}: {}; {}", where, track.error(), kExportAgain);
    numbers_ += track->seconds.size() + track->values.size();
    if (numbers_ > kMostClipNumbers)
      return gltf::fault("more than {} numbers of animation; export a shorter clip", kMostClipNumbers);
    if (!track->was_linear) {
      clip_.notes.push_back(
          where + ": steps or splines are read as straight lines between their values; bake the clip for other curves");
    }
    const auto place = std::size_t(std::ranges::find(chain_, target.node) - chain_.begin());
    if (nodes_[place].animate(target.property, std::move(*track))) return {};
    return gltf::fault("{}: animated twice, or given as a matrix; {}", where, kExportAgain);
  }

  /// Keys of one track differ from another's by rounding, and so near ones are one.
  [[nodiscard]] std::vector<double> key_times() const {
    std::vector<double> times;
    for (const ClipNode& node : nodes_) {
      for (const NodeProperty property : {NodeProperty::kTranslation, NodeProperty::kRotation, NodeProperty::kScale}) {
        const auto& track = node.track(property);
        if (track) times.insert(times.end(), track->seconds.begin(), track->seconds.end());
      }
    }
    std::ranges::sort(times);
    std::vector<double> apart;
    for (const double time : times) {
      if (apart.empty() || time - apart.back() >= kLeastSpan) apart.push_back(time);
    }
    return apart;
  }

  template <class Local>
  [[nodiscard]] Affine3d world(Local local) const {
    Affine3d place = Affine3d::Identity();
    for (const ClipNode& node : nodes_) place = local(node) * place;
    return place;
  }

  /// A mirrored or flattened node has no rotation.
  [[nodiscard]] static std::optional<Eigen::Quaterniond> rotation_of(const Affine3d& place) {
    if (!place.matrix().allFinite() || !(place.linear().determinant() > 1.0e-30)) return std::nullopt;
    return Eigen::Quaterniond(rotation_part(place)).normalized();
  }

  Expected<void> sample() {
    const std::vector<double> times = key_times();
    if (times.size() > kMostClipKeys) {
      return gltf::fault("{} keys, and the limit is {}; export a shorter clip", times.size(), kMostClipKeys);
    }
    const auto rest = rotation_of(world([](const ClipNode& node) { return node.at_rest(); }));
    for (const double time : times) {
      const Affine3d place = world([time](const ClipNode& node) { return node.at(time); });
      const auto rotation = rotation_of(place);
      if (!rest || !rotation) {
        return gltf::fault(
            "node '{}' is mirrored, or scaled to nothing, at {} s; apply the scale in the modelling tool", clip_.node,
            time);
      }
      clip_.keys.push_back({time, place.translation(), (*rotation * rest->conjugate()).normalized()});
    }
    return {};
  }

  const json& document_;
  const json& animations_;
  gltf::GltfTree tree_;
  gltf::GltfBuffers buffers_;
  std::vector<std::uint32_t> chain_;
  std::vector<ClipNode> nodes_;  ///< The nodes of chain_.
  std::size_t numbers_ = 0;
  ClipFile clip_;
};

}  // namespace

tl::expected<ClipFile, ToolError> read_clip(const fs::path& path, std::string_view node) try {
  const auto document = read_clip_document(path);
  if (!document) return tl::unexpected(document.error());
  auto clip = ClipReader(path, *document).read(node);
  if (!clip) return file_failure(ToolError::Kind::kBadInput, path, "{}", clip.error());
  for (std::string& note : clip->notes) note = path.string() + ": " + note;
  return std::move(*clip);
} catch (const std::bad_alloc&) {
  return file_failure(ToolError::Kind::kBadInput, path, "not enough memory for this clip");
}

}  // namespace coif::importer
