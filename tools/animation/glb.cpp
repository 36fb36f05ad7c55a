#include "animation/glb_file.h"
#include "animation/recording.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <iterator>
#include <string_view>

namespace coif {
namespace {

using Eigen::Isometry3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using nlohmann::json;

Isometry3d from_pose(const HeadPose& pose) {
  const Quat& q = pose.rotation;
  Isometry3d world_from_head = Isometry3d::Identity();
  world_from_head.linear() =
      Quaterniond(double(q.w), double(q.x), double(q.y), double(q.z)).normalized().toRotationMatrix();
  world_from_head.translation() = Eigen::Map<const Vector3d>(pose.position);
  return world_from_head;
}

Isometry3d from_palette(const Mat34& matrix) {
  Isometry3d transform = Isometry3d::Identity();
  transform.affine() = Eigen::Map<const Eigen::Matrix<float, 3, 4, Eigen::RowMajor>>(&matrix.m[0][0]).cast<double>();
  return transform;
}

Vector3d joint(const BoneRecord& bone) { return Eigen::Map<const Eigen::Vector3f>(bone.joint).cast<double>(); }

/// Where the bone's own frame is: a rest pose frame has the axes of head space and stands at the joint.
Isometry3d head_from_bone(const BoneRecord& bone, const Mat34& palette) {
  return from_palette(palette) * Eigen::Translation3d(joint(bone));
}

/// Keys of one animated node, relative to its parent.
struct NodeTrack {
  std::vector<Eigen::Vector3f> translations;
  std::vector<Eigen::Vector4f> rotations;  ///< (x, y, z, w).

  void add(const Isometry3d& parent_from_node) {
    translations.emplace_back(parent_from_node.translation().cast<float>());
    Eigen::Vector4f rotation = Quaterniond(parent_from_node.linear()).normalized().coeffs().cast<float>();
    // Both signs are the same rotation; viewers interpolate the numbers, so keep neighbours on one side.
    if (!rotations.empty() && rotations.back().dot(rotation) < 0) rotation = -rotation;
    rotations.push_back(rotation);
  }
};

NodeTrack track_of(const Asset& asset, const Recording& recording, std::size_t bone) {
  const BoneRecord& record = asset.bones()[bone];
  NodeTrack track;
  for (const RecordedFrame& frame : recording.frames) {
    const Isometry3d head_from_node = head_from_bone(record, frame.palette[bone]);
    const Isometry3d parent_from_head =
        record.parent == kNone ? from_pose(frame.head)
                               : head_from_bone(asset.bones()[record.parent], frame.palette[record.parent]).inverse();
    track.add(parent_from_head * head_from_node);
  }
  return track;
}

void add_channels(GlbFile& file, json& animation, std::size_t times, std::size_t node, const NodeTrack& track) {
  const auto add = [&](const char* path, std::size_t values) {
    animation["samplers"].push_back({{"input", times}, {"output", values}, {"interpolation", "LINEAR"}});
    animation["channels"].push_back(
        {{"sampler", animation["samplers"].size() - 1}, {"target", {{"node", node}, {"path", path}}}});
  };
  add("translation", file.add(track.translations, {.type = "VEC3"}));
  add("rotation", file.add(track.rotations, {.type = "VEC4"}));
}

void add_animation(GlbFile& file, const Asset& asset, const Recording& recording) {
  std::vector<float> seconds;
  for (const RecordedFrame& frame : recording.frames) seconds.push_back(static_cast<float>(frame.seconds));
  const std::size_t times = file.add(seconds, {.type = "SCALAR"});
  file.add_bounds(times, seconds, 1);

  json animation = {{"name", "recording"}};
  for (std::size_t bone = 0; bone < asset.bones().size(); ++bone) {
    if (asset.bones()[bone].kind == BoneKind::kScalp) continue;  // rigid with the head: never leaves its rest pose
    add_channels(file, animation, times, bone, track_of(asset, recording, bone));
  }
  file.document["animations"] = json::array({std::move(animation)});
}

/// One node per bone, of the same index, in the rest pose.
json bone_nodes(const Asset& asset) {
  json nodes = json::array();
  for (std::uint32_t bone = 0; bone < asset.bones().size(); ++bone) {
    const BoneRecord& record = asset.bones()[bone];
    Vector3d offset = joint(record);
    if (record.parent != kNone) {
      offset -= joint(asset.bones()[record.parent]);
      nodes[record.parent]["children"].push_back(bone);
    }
    nodes.push_back({{"name", asset.bone_name(bone)}, {"translation", {offset.x(), offset.y(), offset.z()}}});
  }
  return nodes;
}

json hair_skin(GlbFile& file, const Asset& asset) {
  std::vector<Eigen::Matrix4f> inverse_bind;
  json joints = json::array();
  for (std::size_t bone = 0; bone < asset.bones().size(); ++bone) {
    Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
    matrix.topRightCorner<3, 1>() = -joint(asset.bones()[bone]).cast<float>();
    inverse_bind.push_back(matrix);
    joints.push_back(bone);
  }
  return {{"joints", joints}, {"skeleton", 0}, {"inverseBindMatrices", file.add(inverse_bind, {.type = "MAT4"})}};
}

}  // namespace

std::vector<std::byte> to_glb(const Asset& asset, const Recording& recording,
                              std::span<const std::uint8_t> base_color_png) {
  if (recording.frames.empty()) return {};
  GlbFile file;
  file.document = {{"asset", {{"version", "2.0"}, {"generator", "coif"}}}, {"scene", 0}};
  json nodes = bone_nodes(asset);
  json roots = json::array({0});
  if (!asset.vertices().empty()) {
    add_hair_mesh(file, asset, base_color_png);
    json node = {{"name", "hair"}, {"mesh", 0}};
    if (!asset.skin().empty()) {
      file.document["skins"] = json::array({hair_skin(file, asset)});
      node["skin"] = 0;
    }
    roots.push_back(nodes.size());
    nodes.push_back(std::move(node));
  }
  file.document["scenes"] = json::array({{{"nodes", std::move(roots)}}});
  file.document["nodes"] = std::move(nodes);
  add_animation(file, asset, recording);
  return file.bytes();
}

namespace {

// RFC 4180: a field with a comma, a quote or a line end is quoted, quotes inside are doubled.
std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

Eigen::Vector3d to_world(const HeadPose& head, const Vec3& point) {
  const Quat& q = head.rotation;
  const Eigen::Quaterniond rotation(double(q.w), double(q.x), double(q.y), double(q.z));
  return rotation * Eigen::Vector3f(point.x, point.y, point.z).cast<double>() +
         Eigen::Map<const Eigen::Vector3d>(head.position);
}

}  // namespace

std::string to_csv(const Asset& asset, const Recording& recording) {
  std::vector<std::string> names;
  for (std::uint32_t bone = 0; bone < asset.bones().size(); ++bone) names.push_back(csv_field(asset.bone_name(bone)));

  std::string text = "frame,seconds,bone,name,x,y,z,world_x,world_y,world_z\n";
  auto out = std::back_inserter(text);
  for (std::size_t f = 0; f < recording.frames.size(); ++f) {
    const RecordedFrame& frame = recording.frames[f];
    for (std::size_t bone = 0; bone < frame.bone_ends.size(); ++bone) {
      const Vec3& p = frame.bone_ends[bone];
      const Eigen::Vector3d world = to_world(frame.head, p);
      fmt::format_to(out, "{},{:.6f},{},{},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f}\n", f, frame.seconds, bone,
                     names[bone], p.x, p.y, p.z, world.x(), world.y(), world.z());
    }
  }
  return text;
}

}  // namespace coif
