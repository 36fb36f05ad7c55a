#include "import/model_stream.h"

#include "import/source_model.h"

#include <concepts>
#include <cstring>
#include <type_traits>

namespace coif {
namespace {

constexpr std::uint32_t kMagic = 0x31464D49u;  // so that a stray write into the pipe is not taken for a model

static_assert(sizeof(Eigen::Vector3f) == 12 && sizeof(Eigen::Vector2f) == 8 && sizeof(SourceInfluence) == 8);

// Elements that may be copied as bytes: no padding, no value that is not valid.
template <class T>
inline constexpr bool kPlain = std::is_arithmetic_v<T> || std::same_as<T, SourceInfluence> ||
                               std::same_as<T, Eigen::Vector3f> || std::same_as<T, Eigen::Vector2f>;

class Encoder {
 public:
  bool raw(const void* data, std::size_t size) {
    const std::size_t start = bytes.size();
    bytes.resize(start + size);
    if (size != 0) std::memcpy(bytes.data() + start, data, size);
    return true;
  }
  template <class T>
  requires kPlain<T>
  bool plain(const T& value) { return raw(&value, sizeof value); }
  template <class Container>
  bool sequence(const Container& items) {
    return plain(std::uint64_t{items.size()}) && raw(items.data(), items.size() * sizeof *items.data());
  }
  template <class Item, class Transfer>
  bool list(const std::vector<Item>& items, std::size_t, Transfer transfer) {
    plain(std::uint64_t{items.size()});
    for (const Item& item : items) transfer(*this, item);
    return true;
  }

  std::vector<std::uint8_t> bytes;
};

class Decoder {
 public:
  explicit Decoder(std::span<const std::uint8_t> bytes) : left_(bytes) {}

  bool raw(void* data, std::size_t size) {
    if (size > left_.size()) return false;
    if (size != 0) std::memcpy(data, left_.data(), size);
    left_ = left_.subspan(size);
    return true;
  }
  template <class T>
  requires kPlain<T>
  bool plain(T& value) { return raw(&value, sizeof value); }
  template <class Container>
  bool sequence(Container& items) {
    std::uint64_t count = 0;
    if (!plain(count) || count > left_.size() / sizeof *items.data()) return false;
    items.resize(static_cast<std::size_t>(count));
    return raw(items.data(), items.size() * sizeof *items.data());
  }
  // `least`: bytes that every item takes at least, so that a count cannot promise more items than there are bytes.
  template <class Item, class Transfer>
  bool list(std::vector<Item>& items, std::size_t least, Transfer transfer) {
    std::uint64_t count = 0;
    if (!plain(count) || count > left_.size() / least) return false;
    items.resize(static_cast<std::size_t>(count));
    for (Item& item : items) {
      if (!transfer(*this, item)) return false;
    }
    return true;
  }
  [[nodiscard]] bool at_end() const { return left_.empty(); }

 private:
  std::span<const std::uint8_t> left_;
};

// One list of fields serves both directions: `Archive` is Encoder with a const object, or Decoder with a mutable one.

constexpr auto transfer_text = [](auto& archive, auto& text) { return archive.sequence(text); };

constexpr auto transfer_node = [](auto& archive, auto& node) {
  return archive.sequence(node.name) && archive.plain(node.parent) &&
         archive.raw(node.model_from_node.data(), 16 * sizeof(double));
};

constexpr auto transfer_mesh = [](auto& archive, auto& mesh) {
  return archive.sequence(mesh.name) && archive.plain(mesh.node) && archive.plain(mesh.material) &&
         archive.sequence(mesh.positions) && archive.sequence(mesh.normals) && archive.sequence(mesh.uvs) &&
         archive.sequence(mesh.influence_begin) && archive.sequence(mesh.influences) &&
         archive.sequence(mesh.triangles);
};

bool transfer_flag(Encoder& archive, const bool& flag) { return archive.plain(std::uint8_t{flag}); }

// Any byte but 0 and 1 copied into a bool would be undefined.
bool transfer_flag(Decoder& archive, bool& flag) {
  std::uint8_t byte = 0;
  if (!archive.plain(byte) || byte > 1) return false;
  flag = byte == 1;
  return true;
}

template <class Choice>
bool transfer_choice(Encoder& archive, const Choice& choice, Choice) {
  return archive.plain(static_cast<std::uint8_t>(choice));
}

// A number beyond the last enumerator is no value of the type that anything after this expects.
template <class Choice>
bool transfer_choice(Decoder& archive, Choice& choice, Choice last) {
  std::uint8_t byte = 0;
  if (!archive.plain(byte) || byte > static_cast<std::uint8_t>(last)) return false;
  choice = static_cast<Choice>(byte);
  return true;
}

constexpr auto transfer_material = [](auto& archive, auto& material) {
  return archive.sequence(material.name) && archive.raw(material.base_color.data(), 4 * sizeof(float)) &&
         archive.sequence(material.base_texture.path) && archive.plain(material.base_texture.image) &&
         archive.sequence(material.normal_texture.path) && archive.plain(material.normal_texture.image) &&
         archive.plain(material.normal_strength) && archive.sequence(material.opacity_texture) &&
         archive.list(material.other_textures, sizeof(std::uint64_t), transfer_text) &&
         transfer_choice(archive, material.alpha_use, AlphaUse::kBlend) && archive.plain(material.alpha_cutoff) &&
         transfer_flag(archive, material.double_sided);
};

constexpr auto transfer_collider = [](auto& archive, auto& collider) {
  return transfer_choice(archive, collider.shape, SourceCollider::Shape::kPlane) &&
         transfer_flag(archive, collider.keeps_inside) && archive.plain(collider.node) &&
         archive.raw(collider.center.data(), 3 * sizeof(double)) &&
         archive.raw(collider.tail.data(), 3 * sizeof(double)) &&
         archive.raw(collider.normal.data(), 3 * sizeof(double)) && archive.plain(collider.radius);
};

constexpr auto transfer_limit = [](auto& archive, auto& limit) {
  return transfer_choice(archive, limit.kind, SourceLimit::Kind::kSpherical) && archive.raw(limit.angles, sizeof limit.angles) &&
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

bool transfer_axis(Encoder& archive, const char& axis) { return archive.plain(axis); }

bool transfer_axis(Decoder& archive, char& axis) { return archive.plain(axis) && axis >= 'x' && axis <= 'z'; }

constexpr auto transfer_space = [](auto& archive, auto& space) {
  return archive.plain(space.metres_per_unit) && transfer_choice(archive, space.unit, Statement::kUnsaid) &&
         transfer_choice(archive, space.up, Statement::kUnsaid) && transfer_axis(archive, space.up_axis) &&
         archive.sequence(space.unit_words) && archive.sequence(space.up_words) && archive.sequence(space.generator);
};

constexpr auto transfer_model = [](auto& archive, auto& model) {
  constexpr std::size_t kCount = sizeof(std::uint64_t);
  return archive.sequence(model.path) && archive.sequence(model.importer) &&
         archive.raw(model.importer_version, sizeof model.importer_version) &&
         archive.list(model.nodes, kCount + 132, transfer_node) &&
         archive.list(model.meshes, 7 * kCount + 8, transfer_mesh) &&
         archive.list(model.materials, 2 * kCount + 26, transfer_material) &&
         archive.list(model.images, 2 * kCount, transfer_image) &&
         archive.list(model.springs, 3 * kCount + 4, transfer_spring) &&
         archive.list(model.colliders, 10 * sizeof(double) + 6, transfer_collider) && archive.plain(model.head_node) &&
         transfer_choice(archive, model.facing, Facing::kBackwards) && transfer_space(archive, model.space) &&
         archive.list(model.warnings, kCount, transfer_text) && archive.list(model.side_files, kCount, transfer_text);
};

bool decode_error(Decoder& decoder, ImportOutcome& outcome) {
  std::uint8_t kind = 0;
  ToolError error;
  if (!decoder.plain(kind) || kind > static_cast<std::uint8_t>(ToolError::Kind::kInternal)) return false;
  if (!decoder.sequence(error.message) || !decoder.at_end()) return false;
  error.kind = static_cast<ToolError::Kind>(kind);
  outcome = tl::unexpected(std::move(error));
  return true;
}

}  // namespace

std::vector<std::uint8_t> encode_outcome(const ImportOutcome& outcome) {
  Encoder encoder;
  encoder.plain(kMagic);
  transfer_flag(encoder, outcome.has_value());
  if (outcome) {
    transfer_model(encoder, *outcome);
  } else {
    encoder.plain(static_cast<std::uint8_t>(outcome.error().kind));
    encoder.sequence(outcome.error().message);
  }
  return std::move(encoder.bytes);
}

bool decode_outcome(std::span<const std::uint8_t> bytes, ImportOutcome& outcome) {
  Decoder decoder(bytes);
  std::uint32_t magic = 0;
  bool has_model = false;
  if (!decoder.plain(magic) || magic != kMagic || !transfer_flag(decoder, has_model)) return false;
  if (!has_model) return decode_error(decoder, outcome);
  SourceModel model;
  if (!transfer_model(decoder, model) || !decoder.at_end() || !find_model_fault(model).empty()) return false;
  outcome = std::move(model);
  return true;
}

}  // namespace coif
