#pragma once

// A mesh that KHR_draco_mesh_compression holds. Source: Khronos, "KHR_draco_mesh_compression".

#include "gltf/accessors.h"

#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace draco {
class Mesh;
}

namespace coif::gltf {

class DracoMesh {
 public:
  /// The error is a sentence's end: "is damaged: ...".
  [[nodiscard]] static tl::expected<DracoMesh, std::string> decode(std::span<const std::byte> bytes);
  DracoMesh(DracoMesh&&) noexcept;
  DracoMesh& operator=(DracoMesh&&) noexcept;
  ~DracoMesh();

  [[nodiscard]] std::vector<std::uint32_t> triangles() const;  ///< Three each.
  /// Numbers of the attribute with that unique id, like those of an accessor. The error is the end of a sentence.
  [[nodiscard]] tl::expected<std::vector<float>, std::string> numbers(std::uint32_t id, std::size_t width,
                                                                      bool normalized) const;
  [[nodiscard]] tl::expected<std::vector<std::uint32_t>, std::string> integers(std::uint32_t id,
                                                                               std::size_t width) const;

 private:
  explicit DracoMesh(std::unique_ptr<draco::Mesh> mesh);
  [[nodiscard]] tl::expected<GltfElements, std::string> elements(std::uint32_t id, std::size_t width) const;

  std::unique_ptr<draco::Mesh> mesh_;
};

}  // namespace coif::gltf
