#include "import/clip_track.h"

#include "base/text.h"
#include "gltf/accessors.h"
#include "gltf/buffers.h"
#include "gltf/document.h"
#include "import/import.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <utility>

namespace coif::importer {
namespace {

constexpr std::uint64_t kMostClipBytes = std::uint64_t{1} << 30;

using Eigen::Quaterniond;
using Eigen::Vector3d;
using nlohmann::json;

constexpr const char* kNames[] = {"translation", "rotation", "scale"};

/// Two keys and how far from the first to the second a time is.
struct Place {
  std::size_t before, after;
  double share;
};

Place place_of(const std::vector<float>& seconds, double time) {
  const auto next = std::ranges::upper_bound(seconds, time, {}, [](float key) { return double(key); });
  const auto after = std::size_t(next - seconds.begin());
  if (after == 0) return {0, 0, 0};
  if (after == seconds.size()) return {after - 1, after - 1, 0};
  const double begin = seconds[after - 1], end = seconds[after];
  return {after - 1, after, (time - begin) / (end - begin)};
}

std::string fault_of_times(const std::vector<float>& seconds) {
  if (seconds.front() < 0) return fmt::format("begins at {} s, before 0", seconds.front());
  const auto bad = std::ranges::adjacent_find(seconds, [](float a, float b) { return !(a < b); });
  if (bad == seconds.end()) return "";
  return fmt::format("has key {} at {} s and the next at {} s", bad - seconds.begin(), bad[0], bad[1]);
}

/// A spline's key is its incoming slope, its value and its outgoing slope.
std::vector<float> values_of_spline(const std::vector<float>& triples, std::size_t width) {
  std::vector<float> values;
  values.reserve(triples.size() / 3);
  for (std::size_t i = 0; i < triples.size(); ++i) {
    if (i / width % 3 == 1) values.push_back(triples[i]);
  }
  return values;
}

bool has_lost_rotation(const std::vector<float>& values) {
  for (std::size_t i = 0; i < values.size(); i += 4) {
    if (Eigen::Map<const Eigen::Vector4f>(&values[i]).cast<double>().norm() < 1.0e-3) return true;
  }
  return false;
}

}  // namespace

tl::expected<nlohmann::json, ToolError> read_clip_document(const std::filesystem::path& path) {
  using Kind = ToolError::Kind;
  if (auto readable = check_readable(path, kMostClipBytes); !readable) return tl::unexpected(readable.error());
  const auto suffix = find_suffix(path);
  if (!suffix || suffix->format != SourceFormat::kGltf) {
    return file_failure(Kind::kUnsupported, path,
                        "clips are read from .glb, .gltf and .vrm only; convert it to glTF in a modelling tool");
  }
  auto document = gltf::read_gltf_json(path);
  if (!document)
    return file_failure(Kind::kBadInput, path, "cannot be read as glTF 2.0: {}; {}", document.error(), kExportAgain);
  return std::move(*document);
}

std::optional<NodeProperty> find_node_property(const json& name) {
  for (const NodeProperty property : {NodeProperty::kTranslation, NodeProperty::kRotation, NodeProperty::kScale}) {
    if (name == name_of(property)) return property;
  }
  return std::nullopt;
}

const char* name_of(NodeProperty property) { return kNames[std::size_t(property)]; }

Vector3d ClipTrack::vector_at(double time) const {
  const Place place = place_of(seconds, time);
  const auto key = [this](std::size_t i) { return Eigen::Map<const Eigen::Vector3f>(&values[3 * i]).cast<double>(); };
  return key(place.before) + place.share * (key(place.after) - key(place.before));
}

Quaterniond ClipTrack::rotation_at(double time) const {
  const Place place = place_of(seconds, time);
  const auto key = [this](std::size_t i) {
    return Quaterniond(Eigen::Map<const Eigen::Vector4f>(&values[4 * i]).cast<double>().eval()).normalized();
  };
  return key(place.before).slerp(place.share, key(place.after)).normalized();
}

tl::expected<ClipTrack, std::string> read_track(const json& document, gltf::GltfBuffers& buffers, const json& sampler,
                                                NodeProperty property) {
  const json& interpolation = member(sampler, "interpolation");
  const bool is_spline = interpolation == "CUBICSPLINE";
  ClipTrack track;
  track.was_linear = interpolation.is_null() || interpolation == "LINEAR";
  auto seconds = gltf::read_gltf_numbers(document, buffers, member(sampler, "input"), {"SCALAR", 1, kMostClipKeys});
  if (!seconds) return tl::unexpected("key times: " + seconds.error());
  if (const std::string bad = fault_of_times(*seconds); !bad.empty()) return tl::unexpected("key times: " + bad);

  const bool turns = property == NodeProperty::kRotation;
  const std::size_t width = turns ? 4 : 3;
  auto values = gltf::read_gltf_numbers(document, buffers, member(sampler, "output"),
                                        {turns ? "VEC4" : "VEC3", width, 3 * kMostClipKeys});
  if (!values) return tl::unexpected("values: " + values.error());
  if (values->size() != seconds->size() * width * (is_spline ? 3 : 1)) {
    return gltf::fault("{} values for {} key times", values->size() / width, seconds->size());
  }
  track.seconds = std::move(*seconds);
  track.values = is_spline ? values_of_spline(*values, width) : std::move(*values);
  if (turns && has_lost_rotation(track.values)) return tl::unexpected(std::string("a rotation of length 0"));
  return track;
}

using Eigen::Affine3d;

std::optional<ClipNode> ClipNode::from(const json& node) {
  const auto place = gltf::gltf_place(node);
  if (!place) return std::nullopt;
  ClipNode out;
  out.rest_ = *place;
  return out;
}

bool ClipNode::animate(NodeProperty property, ClipTrack track) {
  auto& slot = tracks_[std::size_t(property)];
  if (rest_.is_matrix || slot) return false;
  slot = std::move(track);
  return true;
}

const std::optional<ClipTrack>& ClipNode::track(NodeProperty property) const { return tracks_[std::size_t(property)]; }

Affine3d ClipNode::at(double seconds) const {
  const auto &moves = track(NodeProperty::kTranslation), &turns = track(NodeProperty::kRotation),
             &grows = track(NodeProperty::kScale);
  if (!moves && !turns && !grows) return rest_.parent_from_node;
  return gltf::gltf_placed(moves ? moves->vector_at(seconds) : rest_.translation,
                           turns ? turns->rotation_at(seconds) : rest_.rotation,
                           grows ? grows->vector_at(seconds) : rest_.scale);
}

}  // namespace coif::importer
