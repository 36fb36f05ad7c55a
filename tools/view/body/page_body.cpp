#include "view/body/page_body.h"

#include "base/byte_archive.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace coif::view {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

static_assert(std::endian::native == std::endian::little);
constexpr float kMost = 65535;
constexpr std::uint32_t kNoImage = 0xFFFFFFFFu;

/// A mesh in whole numbers.
struct PackedMesh {
  float low[5] = {}, size[5] = {};     ///< Range of position and uv.
  std::vector<std::uint16_t> places;   ///< Five per vertex, shares of that range.
  std::vector<std::uint16_t> normals;  ///< Two per vertex: octahedral.
  std::vector<std::uint8_t> turning;   ///< Empty or one per vertex, 255: the whole turn.
  std::vector<std::uint16_t> triangles;
  float look[5] = {};  ///< Colour, least alpha, roughness.
  std::uint32_t image = kNoImage;
};

/// Both ways: `archive` is an encoder or a decoder.
constexpr auto transfer_mesh = [](auto& archive, auto& mesh) {
  bool fine = true;
  for (int k = 0; k < 5; ++k) fine = fine && archive.plain(mesh.low[k]) && archive.plain(mesh.size[k]);
  for (int k = 0; k < 5; ++k) fine = fine && archive.plain(mesh.look[k]);
  return fine && archive.plain(mesh.image) && archive.sequence(mesh.places) && archive.sequence(mesh.normals) &&
         archive.sequence(mesh.turning) && archive.sequence(mesh.triangles);
};

using Place = Eigen::Matrix<float, 5, 1>;

Place place_of(const render::SolidVertex& vertex) {
  Place place;
  place << vertex.position, vertex.uv;
  return place;
}

std::uint16_t whole(float share) { return std::uint16_t(std::lround(kMost * std::clamp(share, 0.0f, 1.0f))); }

/// Source: Cigolle et al. 2014, "A Survey of Efficient Representations for Independent Unit Vectors".
Vector2f folded(const Vector3f& unit) {
  const Vector3f flat = unit / unit.cwiseAbs().sum();
  if (flat.z() >= 0) return flat.head<2>();
  return {std::copysign(1 - std::abs(flat.y()), flat.x()), std::copysign(1 - std::abs(flat.x()), flat.y())};
}
Vector3f unfolded(const Vector2f& flat) {
  Vector3f unit(flat.x(), flat.y(), 1 - flat.cwiseAbs().sum());
  if (unit.z() < 0) {
    unit.x() = std::copysign(1 - std::abs(flat.y()), flat.x());
    unit.y() = std::copysign(1 - std::abs(flat.x()), flat.y());
  }
  return unit.normalized();
}

PackedMesh packed(const PageBodyMesh& body) {
  PackedMesh out;
  const render::SolidMesh& mesh = body.mesh;
  Eigen::AlignedBox<float, 5> box;
  for (const render::SolidVertex& vertex : mesh.vertices) box.extend(place_of(vertex));
  const Place sizes = box.isEmpty() ? Place::Ones() : Place(box.sizes().cwiseMax(1e-6f));
  Eigen::Map<Place>{out.low} = box.isEmpty() ? Place::Zero() : box.min();
  Eigen::Map<Place>{out.size} = sizes;
  for (const render::SolidVertex& vertex : mesh.vertices) {
    const Place share = (place_of(vertex) - box.min()).cwiseQuotient(sizes);
    for (int k = 0; k < 5; ++k) out.places.push_back(whole(share[k]));
    for (const float half : folded(vertex.normal)) out.normals.push_back(whole(0.5f + 0.5f * half));
  }
  for (const float share : body.turning) out.turning.push_back(std::uint8_t(std::lround(255 * share)));
  out.triangles.assign(mesh.triangles.begin(), mesh.triangles.end());
  Eigen::Map<Vector3f>{out.look} = mesh.color;
  out.look[3] = mesh.alpha_cutoff;
  out.look[4] = mesh.roughness;
  out.image = body.image.value_or(kNoImage);
  return out;
}

std::optional<PageBodyMesh> unpacked(const PackedMesh& mesh) {
  const std::size_t vertices = mesh.places.size() / 5;
  const bool is_whole = mesh.places.size() == 5 * vertices && mesh.normals.size() == 2 * vertices &&
                        (mesh.turning.empty() || mesh.turning.size() == vertices) && mesh.triangles.size() % 3 == 0;
  if (!is_whole) return std::nullopt;
  PageBodyMesh out;
  const Eigen::Map<const Place> low(mesh.low), size(mesh.size);
  for (std::size_t i = 0; i < vertices; ++i) {
    Place place;
    for (int k = 0; k < 5; ++k) place[k] = low[k] + size[k] * float(mesh.places[5 * i + std::size_t(k)]) / kMost;
    const Vector2f flat(float(mesh.normals[2 * i]), float(mesh.normals[2 * i + 1]));
    out.mesh.vertices.push_back({place.head<3>(), unfolded((2 / kMost * flat).array() - 1), place.tail<2>()});
  }
  for (const std::uint16_t v : mesh.triangles) {
    if (v >= vertices) return std::nullopt;
    out.mesh.triangles.push_back(v);
  }
  for (const std::uint8_t share : mesh.turning) out.turning.push_back(float(share) / 255);
  out.mesh.color = Eigen::Map<const Vector3f>(mesh.look);
  out.mesh.alpha_cutoff = mesh.look[3];
  out.mesh.roughness = mesh.look[4];
  if (mesh.image != kNoImage) out.image = mesh.image;
  return out;
}

}  // namespace

std::vector<std::byte> body_bytes(const PageBody& body) {
  ByteEncoder encoder;
  std::vector<PackedMesh> meshes;
  for (const PageBodyMesh& mesh : body.meshes) meshes.push_back(packed(mesh));
  encoder.list(meshes, 1, transfer_mesh);
  const auto bytes = std::as_bytes(std::span(encoder.bytes));
  return {bytes.begin(), bytes.end()};
}

std::optional<PageBody> page_body(std::span<const std::byte> bytes) {
  ByteDecoder decoder({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  std::vector<PackedMesh> meshes;
  constexpr std::size_t kLeastBytes = 15 * sizeof(float) + sizeof(std::uint32_t) + 4 * sizeof(std::uint64_t);
  if (!decoder.list(meshes, kLeastBytes, transfer_mesh) || !decoder.at_end()) return std::nullopt;
  PageBody body;
  for (const PackedMesh& mesh : meshes) {
    auto own = unpacked(mesh);
    if (!own) return std::nullopt;
    body.meshes.push_back(std::move(*own));
  }
  return body;
}

}  // namespace coif::view
