#pragma once

// What every supported file becomes: a plain model in metres, Y up, right-handed, in its rest pose.

#include "base/texture_channel.h"
#include "base/tool_error.h"

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
  /// Its transform is part of how its mesh's places are stored as whole numbers (KHR_mesh_quantization): where it
  /// stands says nothing.
  bool undoes_quantization = false;
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
  /// The set that the material's base texture names, with its transform applied; V grows downwards in the image, as
  /// in glTF. Empty when none.
  std::vector<Eigen::Vector2f> uvs;
  std::vector<Eigen::Vector4f> colors;  ///< Linear RGBA, >= 0, that multiply the material's; empty when none.
  /// positions.size() + 1 entries into `influences`, or empty: rigid to `node`.
  std::vector<std::uint32_t> influence_begin;
  std::vector<SourceInfluence> influences;
  std::vector<std::uint32_t> triangles;  ///< Three indices each, counter-clockwise seen from outside.
  /// How far the bones that hold it stand from where they were when it was bound to them, beside each other: the bone
  /// that is turned farthest, and by how many degrees; kNoIndex where the file was saved in the rest position.
  std::uint32_t posed_node = kNoIndex;
  float posed_degrees = 0;
};

/// What a texture shows outside 0..1: itself again, its edge, or itself turned over.
enum class TextureWrap : std::uint8_t { kRepeat, kClamp, kMirror };

struct SourceTexture {
  std::string path;                ///< As written in the file; for messages, and for finding it beside the source.
  std::uint32_t image = kNoIndex;  ///< Into SourceModel::images when embedded.
  TextureWrap wrap[2] = {TextureWrap::kRepeat, TextureWrap::kRepeat};  ///< Along U and V.

  [[nodiscard]] bool is_there() const { return !path.empty() || image != kNoIndex; }
};

/// How a material uses the alpha of its base colour, where the file says so.
enum class AlphaUse { kUnknown, kOpaque, kMask, kBlend };

inline constexpr float kMostNormalStrength = 16;

struct SourceMaterial {
  std::string name;
  Eigen::Vector4f base_color{1, 1, 1, 1};  ///< Linear, alpha in w.
  SourceTexture base_texture;              ///< Empty path and kNoIndex: none.
  SourceTexture normal_texture;            ///< A normal or bump map; the same.
  /// What is known of single strands, of cards that were made from them: red a number of the strand, 0..1; green how
  /// far in front of others it is; blue and alpha how it runs, as TextureRole::kStrandAxis has it. Embedded or none; no
  /// file format has it.
  SourceTexture strand_texture;
  float normal_strength = 1;  ///< What the map's slopes are multiplied with, 0..kMostNormalStrength.
  SourceTexture
      opacity_texture;  ///< Another image, whose numbers are the alpha instead of the base texture's; or none.
  TextureChannel opacity_channel = TextureChannel::kAuto;
  bool opacity_inverted = false;            ///< 1 is transparent.
  std::vector<std::string> other_textures;  ///< "occlusion map 'ao.png'": maps of what is computed here; for messages.
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

/// Which directions a joint's tail may have, as VRMC_springBone_limit has it; what the angles mean: LimitRecord.
struct SourceLimit {
  enum class Kind { kUnlimited, kCone, kHinge, kSpherical } kind = Kind::kUnlimited;
  double angles[2] = {0, 0};  ///< Radians; cone and hinge: the first; spherical: pitch 0..pi and yaw 0..pi/2.
  /// At rest, model space from the limit's own axes, whose +Y is the middle direction.
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
};

/// One joint of a spring bone. The numbers are VRM's own (VRMC_springBone 1.0), lengths in metres.
struct SourceSpringJoint {
  std::uint32_t node = 0;
  double length = 0;     ///< To the tail that swings; 0: nothing swings, the joint is only the end of the one before.
  double stiffness = 1;  ///< Metres per second towards the rest direction, >= 0.
  double gravity_power = 0;                     ///< Metres per second.
  Eigen::Vector3d gravity_direction{0, -1, 0};  ///< Unit, model space.
  double drag = 0.5;                            ///< 0..1.
  double hit_radius = 0;
  SourceLimit limit;
};

/// A chain of joints, root first, each a descendant of the one before. No node is a joint of two springs, or twice.
struct SourceSpring {
  std::string name;
  std::vector<SourceSpringJoint> joints;
  std::uint32_t center = kNoIndex;       ///< The node whose motion the spring does not feel; kNoIndex: the world.
  std::vector<std::uint32_t> colliders;  ///< Into SourceModel::colliders, ascending.
};

/// An image as stored in the file: encoded bytes (PNG, JPEG, TGA, WebP), not decoded here.
struct SourceImage {
  std::string name;
  std::vector<std::uint8_t> bytes;
};

/// Fewer cards that stand for the same strands as the hair's own mesh: what a level of detail draws instead of it, with
/// its material. Sizes of meshes, and no influences.
struct SourceLevel {
  SourceMesh mesh;
  std::vector<Eigen::Vector3f> along;   ///< Per vertex, unit, root to tip.
  std::vector<float> place;             ///< Per vertex, 0 root .. 1 tip.
  std::vector<std::uint32_t> strip_of;  ///< Per triangle, ascending from 0.
};

/// Which way a model looks: along +Z, or -Z as VRM 0.x does. kUnknown: the file does not say.
enum class Facing { kUnknown, kForwards, kBackwards };

/// How much somebody meant what a file says of its unit or its up axis.
enum class Statement {
  kGiven,     ///< By the caller, beside the file: holds whatever the model looks like.
  kDeclared,  ///< By the format's definition or by a value that somebody set.
  kUsual,     ///< By the value that exporters write whatever the model is.
  kUnsaid,    ///< Not at all.
};

/// What a file says of its size and of where up is. The model has that applied, right or wrong.
struct SourceSpace {
  double metres_per_unit = 1;             ///< What the file's lengths were multiplied with.
  Statement unit = Statement::kGiven;     ///< A model that no file gave is in metres,
  Statement up = Statement::kGiven;       ///< Y up.
  char up_axis = 'y';                     ///< The file's own that became Y, whatever its sign: 'x', 'y' or 'z'.
  std::string unit_words = "the caller";  ///< For messages: "glTF is in metres", "UnitScaleFactor 1, centimetres".
  std::string up_words = "the caller";    ///< "glTF has Y up".
  std::string generator;                  ///< The program that wrote the file, as far as it says.
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
  std::uint32_t head_node = kNoIndex;     ///< The head of a VRM's humanoid; kNoIndex where the file does not say.
  Facing facing = Facing::kUnknown;
  /// Cards that stand for strands: these grow along V of the texture, which is as large as it should be.
  bool made_from_strands = false;
  std::vector<SourceLevel> coarser;  ///< Each of fewer triangles than the one before; cards alone have them.
  double scalp_radius = 0;  ///< Of the sphere that the strands' roots lie on, metres; 0 where that is not known.
  SourceSpace space;
  std::vector<Warning>
      warnings;  ///< What is wrong or odd in the file, was repaired or dropped: where, what, and what mends it.
  /// Paths of the other files that the importer opened or looked for, absent ones too: buffers, material libraries. Not
  /// textures, which it leaves alone.
  std::vector<std::string> side_files;
  /// Image files that materials name for any use, as written; what is embedded may be among them.
  std::vector<std::string> named_images;
};

/// Of a mesh's material; "" where it has none.
[[nodiscard]] inline std::string material_name(const SourceModel& model, const SourceMesh& mesh) {
  return mesh.material < model.materials.size() ? model.materials[mesh.material].name : "";
}

/// Every promise of source_model.h: cross-references in range, parents first, arrays of one size, finite numbers,
/// influences that add up to one. Empty when they hold, else the first that does not.
[[nodiscard]] std::string find_model_fault(const SourceModel& model);

}  // namespace coif::importer
