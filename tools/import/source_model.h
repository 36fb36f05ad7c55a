#pragma once
// What every supported file becomes: a plain model in metres, Y up, right-handed, in its rest pose.

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstdint>
#include <string>
#include <vector>

namespace coif {

inline constexpr std::uint32_t kNoIndex = 0xFFFFFFFFu;

struct SourceNode {
  std::string name;
  std::uint32_t parent = kNoIndex;                                ///< An earlier node; kNoIndex for the root.
  Eigen::Affine3d model_from_node = Eigen::Affine3d::Identity();  ///< Rest pose, metres, Y up.
};

struct SourceInfluence {
  std::uint32_t node = 0;
  float weight = 0;  ///< > 0; a vertex's influences add up to one.
};

/// One triangle mesh with one material. Arrays are per vertex and either empty or of one size.
struct SourceMesh {
  std::string name;
  std::uint32_t node = 0;  ///< The node that carries it.
  std::uint32_t material = kNoIndex;
  std::vector<Eigen::Vector3f> positions;  ///< Model space, rest pose (skinning applied), metres.
  std::vector<Eigen::Vector3f> normals;    ///< Model space, unit; empty when the file has none.
  std::vector<Eigen::Vector2f> uvs;        ///< V grows downwards in the image, as in glTF; empty when none.
  /// positions.size() + 1 entries into `influences`, or empty: rigid to `node`.
  std::vector<std::uint32_t> influence_begin;
  std::vector<SourceInfluence> influences;
  std::vector<std::uint32_t> triangles;  ///< Three indices each, counter-clockwise seen from outside.
};

struct SourceTexture {
  std::string path;                ///< As written in the file; for messages, and for finding it beside the source.
  std::uint32_t image = kNoIndex;  ///< Into SourceModel::images when embedded.
};

struct SourceMaterial {
  std::string name;
  Eigen::Vector4f base_color{1, 1, 1, 1};  ///< Linear, alpha in w.
  SourceTexture base_texture;              ///< Empty path and kNoIndex: none.
  bool double_sided = false;
};

/// An image as stored in the file: encoded bytes (PNG, JPEG, TGA), not decoded here.
struct SourceImage {
  std::string name;
  std::vector<std::uint8_t> bytes;
};

struct SourceModel {
  std::string path;
  std::string importer;  ///< Name and version, for example "assimp 5.2.4".
  std::uint16_t importer_version[3] = {0, 0, 0};
  std::vector<SourceNode> nodes;  ///< Parents first.
  std::vector<SourceMesh> meshes;
  std::vector<SourceMaterial> materials;
  std::vector<SourceImage> images;
  std::vector<std::string> warnings;  ///< What was repaired or dropped, one sentence each.
};

}  // namespace coif
