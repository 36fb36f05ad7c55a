#include "gltf/draco_mesh.h"

#include "gltf/document.h"

#include <draco/compression/decode.h>
#include <draco/mesh/mesh.h>

#include <cstring>
#include <utility>

namespace coif::gltf {
namespace {

std::uint32_t component_type(draco::DataType type) {
  switch (type) {
    case draco::DT_INT8: return 5120;
    case draco::DT_UINT8: return 5121;
    case draco::DT_INT16: return 5122;
    case draco::DT_UINT16: return 5123;
    case draco::DT_UINT32: return 5125;
    case draco::DT_FLOAT32: return 5126;
    default: return 0;
  }
}

}  // namespace

DracoMesh::DracoMesh(std::unique_ptr<draco::Mesh> mesh) : mesh_(std::move(mesh)) {}
DracoMesh::DracoMesh(DracoMesh&&) noexcept = default;
DracoMesh& DracoMesh::operator=(DracoMesh&&) noexcept = default;
DracoMesh::~DracoMesh() = default;

tl::expected<DracoMesh, std::string> DracoMesh::decode(std::span<const std::byte> bytes) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  auto mesh = draco::Decoder().DecodeMeshFromBuffer(&buffer);
  if (!mesh.ok())
    return fault("is damaged: KHR_draco_mesh_compression cannot be undone ({})", mesh.status().error_msg());
  return DracoMesh(std::move(mesh).value());
}

std::vector<std::uint32_t> DracoMesh::triangles() const {
  std::vector<std::uint32_t> out;
  out.reserve(3 * std::size_t{mesh_->num_faces()});
  for (draco::FaceIndex f(0); f < mesh_->num_faces(); ++f) {
    for (const draco::PointIndex& point : mesh_->face(f)) out.push_back(point.value());
  }
  return out;
}

tl::expected<GltfElements, std::string> DracoMesh::elements(std::uint32_t id, std::size_t width) const {
  const draco::PointAttribute* const attribute = mesh_->GetAttributeByUniqueId(id);
  GltfElements out;
  if (attribute != nullptr) out.component = gltf_component(component_type(attribute->data_type()));
  if (out.component.size == 0) return fault("has no compressed attribute {} of a known kind", id);
  if (std::size_t(attribute->num_components()) != width) {
    return fault("has {} numbers to the element in compressed attribute {}, and {} are meant",
                 int{attribute->num_components()}, id, width);
  }
  const std::size_t size = out.component.size * width;
  out.width = width;
  out.bytes.resize(mesh_->num_points() * size);
  for (draco::PointIndex point(0); point < mesh_->num_points(); ++point) {
    const draco::AttributeValueIndex value = attribute->mapped_index(point);
    if (value.value() >= attribute->size()) return fault("is damaged: compressed attribute {} lacks values", id);
    std::memcpy(&out.bytes[point.value() * size], attribute->GetAddress(value), size);
  }
  return out;
}

tl::expected<std::vector<float>, std::string> DracoMesh::numbers(std::uint32_t id, std::size_t width,
                                                                 bool normalized) const {
  const auto packed = elements(id, width);
  if (!packed) return tl::unexpected(packed.error());
  std::vector<float> out(packed->count());
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = float(gltf_value(packed->component, normalized, packed->stored(i)));
  return out;
}

tl::expected<std::vector<std::uint32_t>, std::string> DracoMesh::integers(std::uint32_t id, std::size_t width) const {
  const auto packed = elements(id, width);
  if (!packed) return tl::unexpected(packed.error());
  if (!packed->component.is_unsigned) return fault("has no unsigned numbers in compressed attribute {}", id);
  std::vector<std::uint32_t> out(packed->count());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = std::uint32_t(packed->stored(i));
  return out;
}

}  // namespace coif::gltf
