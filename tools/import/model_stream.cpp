#include "import/reader_process.h"

#include "import/source_model.h"
#include "import/stream_parts.h"

namespace coif::importer {

namespace {

constexpr std::uint32_t kMagic = 0x31464D49u;  // So that a stray write into the pipe does not pass as a model.
constexpr std::uint32_t kWholeMagic = 0x31574D49u;

// One list of fields serves both directions: see stream_parts.h.

constexpr auto transfer_node = [](auto& archive, auto& node) {
  return archive.sequence(node.name) && archive.plain(node.parent) &&
         archive.raw(node.model_from_node.data(), 16 * sizeof(double)) &&
         transfer_flag(archive, node.undoes_quantization);
};

constexpr auto transfer_mesh = [](auto& archive, auto& mesh) {
  return archive.sequence(mesh.name) && archive.plain(mesh.node) && archive.plain(mesh.material) &&
         archive.sequence(mesh.positions) && archive.sequence(mesh.normals) && archive.sequence(mesh.uvs) &&
         archive.sequence(mesh.colors) && archive.sequence(mesh.influence_begin) && archive.sequence(mesh.influences) &&
         archive.sequence(mesh.triangles) && archive.plain(mesh.posed_node) && archive.plain(mesh.posed_degrees);
};

constexpr auto transfer_texture = [](auto& archive, auto& texture) {
  return archive.sequence(texture.path) && archive.plain(texture.image) &&
         transfer_choice(archive, texture.wrap[0], TextureWrap::kMirror) &&
         transfer_choice(archive, texture.wrap[1], TextureWrap::kMirror);
};

constexpr auto transfer_material = [](auto& archive, auto& material) {
  return archive.sequence(material.name) && archive.raw(material.base_color.data(), 4 * sizeof(float)) &&
         transfer_texture(archive, material.base_texture) && transfer_texture(archive, material.normal_texture) &&
         archive.plain(material.normal_strength) && transfer_texture(archive, material.opacity_texture) &&
         transfer_choice(archive, material.opacity_channel, TextureChannel::kLuminance) &&
         transfer_flag(archive, material.opacity_inverted) &&
         archive.list(material.other_textures, sizeof(std::uint64_t), transfer_text) &&
         transfer_choice(archive, material.alpha_use, AlphaUse::kBlend) && archive.plain(material.alpha_cutoff) &&
         archive.plain(material.roughness) && transfer_flag(archive, material.double_sided);
};

constexpr auto transfer_collider = [](auto& archive, auto& collider) {
  return transfer_choice(archive, collider.shape, SourceCollider::Shape::kPlane) &&
         transfer_flag(archive, collider.keeps_inside) && archive.plain(collider.node) &&
         archive.raw(collider.center.data(), 3 * sizeof(double)) &&
         archive.raw(collider.tail.data(), 3 * sizeof(double)) &&
         archive.raw(collider.normal.data(), 3 * sizeof(double)) && archive.plain(collider.radius);
};

constexpr auto transfer_limit = [](auto& archive, auto& limit) {
  return transfer_choice(archive, limit.kind, SourceLimit::Kind::kSpherical) &&
         archive.raw(limit.angles, sizeof limit.angles) &&
         archive.raw(limit.rotation.coeffs().data(), 4 * sizeof(double));
};

constexpr auto transfer_joint = [](auto& archive, auto& joint) {
  return archive.plain(joint.node) && archive.plain(joint.length) && archive.plain(joint.stiffness) &&
         archive.plain(joint.gravity_power) && archive.raw(joint.gravity_direction.data(), 3 * sizeof(double)) &&
         archive.plain(joint.drag) && archive.plain(joint.hit_radius) && transfer_limit(archive, joint.limit);
};

constexpr auto transfer_spring = [](auto& archive, auto& spring) {
  constexpr std::size_t kJoint = sizeof(std::uint32_t) + sizeof(std::uint8_t) + 14 * sizeof(double);
  return archive.sequence(spring.name) && archive.list(spring.joints, kJoint, transfer_joint) &&
         archive.plain(spring.center) && archive.sequence(spring.colliders);
};

constexpr auto transfer_image = [](auto& archive, auto& image) {
  return archive.sequence(image.name) && archive.sequence(image.bytes);
};

constexpr auto transfer_model = [](auto& archive, auto& model) {
  constexpr std::size_t kCount = sizeof(std::uint64_t);
  return archive.sequence(model.path) && archive.sequence(model.importer) &&
         archive.raw(model.importer_version, sizeof model.importer_version) &&
         archive.list(model.nodes, kCount + 133, transfer_node) &&
         archive.list(model.meshes, 8 * kCount + 16, transfer_mesh) &&
         archive.list(model.materials, 5 * kCount + 44, transfer_material) &&
         archive.list(model.images, 2 * kCount, transfer_image) &&
         archive.list(model.springs, 3 * kCount + 4, transfer_spring) &&
         archive.list(model.colliders, 10 * sizeof(double) + 6, transfer_collider) && archive.plain(model.head_node) &&
         transfer_choice(archive, model.facing, Facing::kBackwards) && transfer_space(archive, model.space) &&
         archive.list(model.warnings, 2 * kCount, transfer_warning) &&
         archive.list(model.side_files, kCount, transfer_text) &&
         archive.list(model.named_images, kCount, transfer_text);
};

constexpr auto transfer_level = [](auto& archive, auto& level) {
  return transfer_mesh(archive, level.mesh) && archive.sequence(level.along) && archive.sequence(level.place) &&
         archive.sequence(level.strip_of);
};

bool transfer_roots(ByteEncoder& archive, const std::vector<std::filesystem::path>& roots) {
  return archive.list(roots, sizeof(std::uint64_t), [](auto& out, auto& root) { return out.sequence(root.native()); });
}
bool transfer_roots(ByteDecoder& archive, std::vector<std::filesystem::path>& roots) {
  return archive.list(roots, sizeof(std::uint64_t), [](auto& in, auto& root) {
    std::string text;
    if (!in.sequence(text)) return false;
    root = text;
    return true;
  });
}

constexpr auto transfer_whole_model = [](auto& archive, auto& model) {
  constexpr std::size_t kCount = sizeof(std::uint64_t);
  return transfer_model(archive, model) && transfer_roots(archive, model.roots) &&
         transfer_flag(archive, model.made_from_strands) &&
         archive.list(model.coarser, 11 * kCount + 16, transfer_level) && archive.plain(model.scalp_radius);
};

}  // namespace

std::vector<std::uint8_t> encode_outcome(const ImportOutcome& outcome) {
  return encode_framed(kMagic, outcome, transfer_model);
}

bool decode_outcome(std::span<const std::uint8_t> bytes, ImportOutcome& outcome) {
  return decode_framed(kMagic, bytes, outcome, transfer_model, find_model_fault);
}

std::vector<std::uint8_t> encode_model(const ImportOutcome& outcome) {
  return encode_framed(kWholeMagic, outcome, transfer_whole_model);
}

bool decode_model(std::span<const std::uint8_t> bytes, ImportOutcome& outcome) {
  return decode_framed(kWholeMagic, bytes, outcome, transfer_whole_model, find_model_fault);
}

}  // namespace coif::importer
