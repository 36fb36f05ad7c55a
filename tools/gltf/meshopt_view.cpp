#include "gltf/buffers.h"

#include "gltf/document.h"

#include <meshoptimizer.h>

#include <cstring>

namespace coif::gltf {
namespace {

using nlohmann::json;
using Bytes = tl::expected<std::vector<std::byte>, std::string>;

constexpr std::size_t kMostStride = 256;

/// The extension's description of the decompressed bytes.
struct Packing {
  std::size_t count = 0;
  std::size_t stride = 0;
  std::string mode;
  std::string filter;
};

bool has_known_shape(const Packing& packing) {
  if (packing.mode == "ATTRIBUTES") return packing.stride % 4 == 0 && packing.stride <= kMostStride;
  const bool is_index = packing.stride == 2 || packing.stride == 4;
  return is_index && packing.filter == "NONE" &&
         (packing.mode == "INDICES" || (packing.mode == "TRIANGLES" && packing.count % 3 == 0));
}

bool has_known_filter(const Packing& packing) {
  const auto& [count, stride, mode, filter] = packing;
  return filter == "NONE" || (filter == "OCTAHEDRAL" && (stride == 4 || stride == 8)) ||
         (filter == "QUATERNION" && stride == 8) || filter == "EXPONENTIAL";
}

bool decode(const Packing& packing, std::span<const std::byte> bytes, std::vector<std::byte>& out) {
  const auto* const first = reinterpret_cast<const unsigned char*>(bytes.data());
  const auto& [count, stride, mode, filter] = packing;
  if (mode == "ATTRIBUTES") return meshopt_decodeVertexBuffer(out.data(), count, stride, first, bytes.size()) == 0;
  if (mode == "TRIANGLES") return meshopt_decodeIndexBuffer(out.data(), count, stride, first, bytes.size()) == 0;
  return meshopt_decodeIndexSequence(out.data(), count, stride, first, bytes.size()) == 0;
}

void undo_filter(const Packing& packing, std::vector<std::byte>& out) {
  if (packing.filter == "OCTAHEDRAL") meshopt_decodeFilterOct(out.data(), packing.count, packing.stride);
  if (packing.filter == "QUATERNION") meshopt_decodeFilterQuat(out.data(), packing.count, packing.stride);
  if (packing.filter == "EXPONENTIAL") meshopt_decodeFilterExp(out.data(), packing.count, packing.stride);
}

}  // namespace

Bytes decompress_meshopt(const json& compression, std::span<const std::byte> bytes) {
  const auto count = index_of(member(compression, "count"), kMostBufferBytes);
  const auto stride = index_of(member(compression, "byteStride"), kMostStride + 1);
  Packing packing{count.value_or(0), stride.value_or(0), printable_text_of(member(compression, "mode")),
                  printable_text_of(member(compression, "filter"))};
  if (packing.filter.empty()) packing.filter = "NONE";
  const bool fits = packing.count > 0 && packing.stride > 0 && packing.count <= kMostBufferBytes / packing.stride;
  if (!fits || !has_known_shape(packing) || !has_known_filter(packing)) {
    return fault(
        "is compressed by EXT_meshopt_compression in a way that nothing defines (mode '{}', filter '{}', {} elements "
        "of {} bytes)",
        packing.mode, packing.filter, packing.count, packing.stride);
  }
  std::vector<std::byte> out(packing.count * packing.stride);
  if (!decode(packing, bytes, out))
    return fault(
        "is damaged, or of a newer EXT_meshopt_compression than is read; npx @gltf-transform/cli copy OLD.glb NEW.glb "
        "writes it plain");
  undo_filter(packing, out);
  return out;
}

}  // namespace coif::gltf
