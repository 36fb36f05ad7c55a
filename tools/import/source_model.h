#pragma once

// The common form of every supported file: a plain model in metres, Y up, right-handed, in its rest pose.

#include "base/diagnostic.h"
#include "base/texture_channel.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace coif::importer {

inline constexpr std::uint32_t kNoIndex = 0xFFFFFFFFu;
inline constexpr std::size_t kMaxSourceSprings = 4096;  ///< A whole avatar with skirt and tail has some dozens.
inline constexpr std::size_t kMaxSourceColliders = 1024;

struct SourceNode {
  std::string name;
  std::uint32_t parent = kNoIndex;                                ///< An earlier node; kNoIndex for the root.
  Eigen::Affine3d model_from_node = Eigen::Affine3d::Identity();  ///< Rest pose, metres, Y up.
  /// Its transform belongs to the storage of its mesh's positions as whole numbers (KHR_mesh_quantization), so its
  /// place means nothing.
  bool undoes_quantization = false;
};

struct SourceInfluence {
  std::uint32_t node = 0;
  float weight = 0;  ///< > 0; a vertex's influences add up to one.
};

/// One triangle mesh with one material. Arrays are per vertex; each is empty or has that size.
struct SourceMesh {
  std::string name;
  std::uint32_t node = 0;  ///< The node that carries it.
  std::uint32_t material = kNoIndex;
  std::vector<Eigen::Vector3f> positions;  ///< Model space, rest pose (skinning applied), metres.
  std::vector<Eigen::Vector3f> normals;    ///< Model space, unit; empty when the file has none.
  /// The set that the material's base texture names, with its transform applied; V grows downwards in the image, as
  /// in glTF. Empty when none.
  std::vector<Eigen::Vector2f> uvs;
  std::vector<Eigen::Vector4f> colors;  ///< Linear RGBA, >= 0, that multiply the material's; empty when none.
  /// positions.size() + 1 entries into `influences`, or empty: rigid to `node`.
  std::vector<std::uint32_t> influence_begin;
  std::vector<SourceInfluence> influences;
  std::vector<std::uint32_t> triangles;  ///< Three indices each, counter-clockwise seen from outside.
  /// The bone that has turned farthest since the mesh was bound, relative to the mesh's other bones, and by how many
  /// degrees; kNoIndex where the file was saved in the rest position.
  std::uint32_t posed_node = kNoIndex;
  float posed_degrees = 0;
};

/// The texture outside 0..1: repeated, its edge, or mirrored.
enum class TextureWrap : std::uint8_t { kRepeat, kClamp, kMirror };

struct SourceTexture {
  std::string path;                ///< As written in the file; for messages, and for finding it beside the source.
  std::uint32_t image = kNoIndex;  ///< Into SourceModel::images when embedded.
  TextureWrap wrap[2] = {TextureWrap::kRepeat, TextureWrap::kRepeat};  ///< Along U and V.

  [[nodiscard]] bool is_there() const { return !path.empty() || image != kNoIndex; }
};

/// A material's use of its base colour's alpha, if the file gives it.
enum class AlphaUse { kUnknown, kOpaque, kMask, kBlend };

inline constexpr float kMostNormalStrength = 16;

struct SourceMaterial {
  std::string name;
  Eigen::Vector4f base_color{1, 1, 1, 1};  ///< Linear, alpha in w.
  SourceTexture base_texture;              ///< Empty path and kNoIndex: none.
  SourceTexture normal_texture;            ///< A normal or bump map; the same.
  /// Data about single strands, for cards that were made from them. Red: a number of the strand, 0..1; green: how far
  /// in front of others it is; blue and alpha: its direction, as in TextureRole::kStrandAxis. Embedded or none; no file
  /// format has it.
  SourceTexture strand_texture;
  float normal_strength = 1;  ///< Factor on the map's slopes, 0..kMostNormalStrength.
  /// Another image, which replaces the alpha of the base texture; or none.
  SourceTexture opacity_texture;
  TextureChannel opacity_channel = TextureChannel::kAuto;
  bool opacity_inverted = false;  ///< 1 is transparent.
  /// "occlusion map 'ao.png'": maps of values that are computed here; for messages.
  std::vector<std::string> other_textures;
  AlphaUse alpha_use = AlphaUse::kUnknown;
  float alpha_cutoff = 0.5f;  ///< For kMask.
  float roughness = 0.8f;     ///< 0 a mirror .. 1 matte, as glTF has it; else a guess.
  bool double_sided = false;
};

/// A body that hair keeps out of, or inside of, as VRM describes it. Model space at rest, metres.
struct SourceCollider {
  enum class Shape { kSphere, kCapsule, kPlane } shape = Shape::kSphere;
  bool keeps_inside = false;
  std::uint32_t node = 0;  ///< The node that carries it.
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d tail = Eigen::Vector3d::Zero();     ///< kCapsule: the segment's other end.
  Eigen::Vector3d normal = Eigen::Vector3d::UnitY();  ///< kPlane: unit.
  double radius = 0;                                  ///< Not for kPlane.
};

/// The directions that a joint's tail may have, as in VRMC_springBone_limit; the angles mean the same as in
/// LimitRecord.
struct SourceLimit {
  enum class Kind { kUnlimited, kCone, kHinge, kSpherical } kind = Kind::kUnlimited;
  double angles[2] = {0, 0};  ///< Radians; cone and hinge: the first; spherical: pitch 0..pi and yaw 0..pi/2.
  /// At rest, model space from the limit's own axes, whose +Y is the middle direction.
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
};

/// One joint of a spring bone. The numbers are VRM's own (VRMC_springBone 1.0), lengths in metres.
struct SourceSpringJoint {
  std::uint32_t node = 0;
  double length = 0;         ///< To the tail that swings; 0: nothing swings, the joint only ends the one before.
  double stiffness = 1;      ///< Metres per second towards the rest direction, >= 0.
  double gravity_power = 0;  ///< Metres per second.
  Eigen::Vector3d gravity_direction{0, -1, 0};  ///< Unit, model space.
  double drag = 0.5;                            ///< 0..1.
  double hit_radius = 0;
  SourceLimit limit;
};

/// A chain of joints, root first, each a descendant of the one before. No node is a joint of two springs, or twice.
struct SourceSpring {
  std::string name;
  std::vector<SourceSpringJoint> joints;
  std::uint32_t center = kNoIndex;       ///< The spring does not feel the motion of this node; kNoIndex: the world.
  std::vector<std::uint32_t> colliders;  ///< Into SourceModel::colliders, ascending.
};

/// An image as stored in the file: encoded bytes (PNG, JPEG, TGA, WebP), not decoded here.
struct SourceImage {
  std::string name;
  std::vector<std::uint8_t> bytes;
};

/// Fewer cards for the same strands as the hair's own mesh: a level of detail that replaces it, with its material.
/// Arrays have the sizes of meshes'; no influences.
struct SourceLevel {
  SourceMesh mesh;
  std::vector<Eigen::Vector3f> along;   ///< Per vertex, unit, root to tip.
  std::vector<float> place;             ///< Per vertex, 0 root .. 1 tip.
  std::vector<std::uint32_t> strip_of;  ///< Per triangle, ascending from 0.
};

/// The direction in which a model looks: +Z, or -Z as in VRM 0.x. kUnknown: the file does not say.
enum class Facing { kUnknown, kForwards, kBackwards };

/// How reliable a file's unit or up axis is.
enum class Statement {
  kGiven,     ///< From the caller, apart from the file: holds whatever the model looks like.
  kDeclared,  ///< From the format's definition, or a value that somebody set.
  kUsual,     ///< The value that exporters write for every model.
  kUnsaid,    ///< Not at all.
};

/// The file's size and up axis. The model has them applied, right or wrong.
struct SourceSpace {
  double metres_per_unit = 1;             ///< Factor that the file's lengths were multiplied with.
  Statement unit = Statement::kGiven;     ///< A model that comes from no file is in metres.
  Statement up = Statement::kGiven;       ///< Y up.
  char up_axis = 'y';                     ///< The file's own that became Y, whatever its sign: 'x', 'y' or 'z'.
  std::string unit_words = "the caller";  ///< For messages: "glTF is in metres", "UnitScaleFactor 1, centimetres".
  std::string up_words = "the caller";    ///< "glTF has Y up".
  std::string generator;                  ///< The program that wrote the file, if the file names it.
};

struct SourceModel {
  std::string path;
  std::vector<std::filesystem::path> roots;  ///< ImportSettings::roots.
  std::string importer;                      ///< Name and version, for example "assimp 5.2.4".
  std::uint16_t importer_version[3] = {0, 0, 0};
  std::vector<SourceNode> nodes;  ///< Parents first.
  std::vector<SourceMesh> meshes;
  std::vector<SourceMaterial> materials;
  std::vector<SourceImage> images;
  std::vector<SourceSpring> springs;      ///< At most kMaxSourceSprings.
  std::vector<SourceCollider> colliders;  ///< At most kMaxSourceColliders.
  std::uint32_t head_node = kNoIndex;     ///< The head of a VRM's humanoid; kNoIndex where the file has none.
  Facing facing = Facing::kUnknown;
  /// Cards made from strands: the strands run along V of the texture, which already has the right size.
  bool made_from_strands = false;
  std::vector<SourceLevel> coarser;  ///< Each has fewer triangles than the one before; only cards have them.
  double scalp_radius = 0;  ///< Radius of the sphere that the strands' roots lie on, metres; 0 where it is not known.
  SourceSpace space;
  Diagnostics warnings;
  /// Paths of the other files that the importer opened or looked for, absent ones too: buffers, material libraries. Not
  /// textures, which it leaves alone.
  std::vector<std::string> side_files;
  /// Image files that materials name for any use, as written; embedded ones may be among them.
  std::vector<std::string> named_images;
};

/// The name of a mesh's material; "" where it has none.
[[nodiscard]] inline std::string material_name(const SourceModel& model, const SourceMesh& mesh) {
  return mesh.material < model.materials.size() ? model.materials[mesh.material].name : "";
}

/// Every promise of source_model.h: cross-references in range, parents first, arrays of one size, finite numbers,
/// influences that add up to one. Empty when they hold, else the first that does not.
[[nodiscard]] std::string find_model_fault(const SourceModel& model);

}  // namespace coif::importer
