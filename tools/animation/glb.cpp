#include "animation/recording.h"

#include "base/glb_file.h"

#include <Eigen/Geometry>

#include <array>

namespace coif::animation {
namespace {

using Eigen::Isometry3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using nlohmann::json;
using HairGlb = GlbFile<json>;

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

/// The bone's own frame: in the rest pose it has the axes of head space and stands at the joint.
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
    // Both signs are the same rotation; viewers interpolate the numbers, so neighbours must be on one side.
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

void add_channels(HairGlb& file, json& animation, std::size_t times, std::size_t node, const NodeTrack& track) {
  const auto add = [&](const char* path, std::size_t values) {
    animation["samplers"].push_back({{"input", times}, {"output", values}, {"interpolation", "LINEAR"}});
    animation["channels"].push_back(
        {{"sampler", animation["samplers"].size() - 1}, {"target", {{"node", node}, {"path", path}}}});
  };
  add("translation", file.add(track.translations, {.type = "VEC3"}));
  add("rotation", file.add(track.rotations, {.type = "VEC4"}));
}

void add_animation(HairGlb& file, const Asset& asset, const Recording& recording) {
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

/// One node per bone, with the bone's index, in the rest pose.
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

json hair_skin(HairGlb& file, const Asset& asset) {
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

using Byte4 = std::array<std::uint8_t, 4>;
using Short4 = std::array<std::uint16_t, 4>;

struct VertexArrays {
  std::vector<Eigen::Vector3f> positions;
  std::vector<Eigen::Vector3f> normals;
  std::vector<Eigen::Vector2f> uvs;
  std::vector<Short4> joints;
  std::vector<Byte4> weights;
};

Eigen::Vector3f unit_normal(const VertexRecord& vertex) {
  const Eigen::Vector3f normal(vertex.normal[0], vertex.normal[1], vertex.normal[2]);
  // glTF demands unit length; a mesh may still have a vertex without a direction.
  return normal.squaredNorm() > 0 ? normal.normalized() : Eigen::Vector3f::UnitY();
}

VertexArrays unpack(const Asset& asset) {
  VertexArrays arrays;
  for (const VertexRecord& vertex : asset.vertices()) {
    arrays.positions.emplace_back(vertex.position[0], vertex.position[1], vertex.position[2]);
    arrays.normals.push_back(unit_normal(vertex));
    arrays.uvs.emplace_back(vertex.uv[0], vertex.uv[1]);
  }
  for (const SkinRecord& skin : asset.skin()) {
    Short4 joints{};
    Byte4 weights{};
    for (std::size_t k = 0; k < 4; ++k) {
      weights[k] = skin.weight[k];
      joints[k] = skin.weight[k] > 0 ? skin.bone[k] : std::uint16_t{0};  // glTF: an unused joint is joint 0
    }
    arrays.joints.push_back(joints);
    arrays.weights.push_back(weights);
  }
  return arrays;
}

json attributes(HairGlb& file, const VertexArrays& arrays, std::size_t bones) {
  json result;
  const std::size_t positions = file.add(arrays.positions, vertex_floats("VEC3"));
  file.add_bounds(positions, {arrays.positions.data()->data(), arrays.positions.size() * 3}, 3);
  result["POSITION"] = positions;
  result["NORMAL"] = file.add(arrays.normals, vertex_floats("VEC3"));
  result["TEXCOORD_0"] = file.add(arrays.uvs, vertex_floats("VEC2"));
  if (!arrays.joints.empty()) {
    const GlbArray shares{GlbComponent::kUnsignedByte, "VEC4", GlbTarget::kVertices, true};
    result["JOINTS_0"] = file.add_joints(arrays.joints, bones <= 256);
    result["WEIGHTS_0"] = file.add(arrays.weights, shares);
  }
  return result;
}

json hair_material(HairGlb& file, const MaterialRecord* record, std::span<const std::uint8_t> base_color_png) {
  json surface = {{"metallicFactor", 0}, {"roughnessFactor", 0.6}};
  if (record) surface["baseColorFactor"] = record->base_color;
  json material = {{"name", "hair"}, {"doubleSided", !record || (record->flags & kMaterialDoubleSided) != 0}};
  if (!base_color_png.empty()) {
    const std::size_t view = file.add_view(std::as_bytes(base_color_png));
    file.document["images"] = json::array({{{"bufferView", view}, {"mimeType", "image/png"}}});
    file.document["textures"] = json::array({{{"source", 0}}});
    surface["baseColorTexture"] = {{"index", 0}};
    // Viewers do not draw patches in the cooked order, so blending would show the far side through the near one.
    material["alphaMode"] = "MASK";
  }
  material["pbrMetallicRoughness"] = std::move(surface);
  return material;
}

/// The finest level with its skin attributes and one material, as mesh 0.
void add_hair_mesh(HairGlb& file, const Asset& asset, std::span<const std::uint8_t> base_color_png) {
  json primitive = {{"attributes", attributes(file, unpack(asset), asset.bones().size())}, {"material", 0}};
  primitive["indices"] =
      file.add(asset.lod_indices(0), {GlbComponent::kUnsignedInt, "SCALAR", GlbTarget::kIndices, false});
  file.document["meshes"] = json::array({{{"name", "hair"}, {"primitives", json::array({std::move(primitive)})}}});
  file.document["materials"] = json::array({hair_material(file, asset.material(), base_color_png)});
}

}  // namespace

std::vector<std::byte> to_glb(const Asset& asset, const Recording& recording,
                              std::span<const std::uint8_t> base_color_png) {
  if (recording.frames.empty()) return {};
  HairGlb file;
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

}  // namespace coif::animation
