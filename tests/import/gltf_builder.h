#pragma once

// A glTF document that tests write for themselves, with accessors of every kind.

#include "import/model_files.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace coif::importer::test {

/// How an accessor stores its numbers. Numbers are written as `component` can hold them: the nearest integer, of a
/// fraction where it is normalized.
struct Storage {
  int component = 5126;  ///< glTF's componentType.
  bool normalized = false;
  std::size_t padding = 0;  ///< Bytes between two elements.
  bool sparse = false;      ///< Without a bufferView of its own: all elements are replaced.
  bool meshopt = false;     ///< Compressed; `padding` must make four bytes of an element.
};

/// One mesh of one primitive on one node, "strip"; tests change `document` as they like.
class GltfBuilder {
 public:
  GltfBuilder();

  /// Adds an accessor and returns its number. `type` is "SCALAR", "VEC3" ...
  std::size_t add(std::span<const float> numbers, const std::string& type, const Storage& storage = {});
  /// The same of places, with their bounds.
  std::size_t add_places(std::span<const float> numbers);
  /// Adds a bufferView and returns its number.
  std::size_t add_view(const std::string& bytes);
  /// Sets an attribute of the primitive.
  GltfBuilder& attribute(const std::string& name, std::span<const float> numbers, const std::string& type,
                         const Storage& storage = {});
  /// A material of the primitive with a texture, `texture_info` in the place of the base colour's.
  GltfBuilder& textured(const nlohmann::json& texture_info, const nlohmann::json& sampler = nlohmann::json::object());

  [[nodiscard]] nlohmann::json& primitive() { return document["meshes"][0]["primitives"][0]; }
  [[nodiscard]] std::string glb() const;
  std::filesystem::path write(const TemporaryFolder& folder, const std::string& name = "m.glb") const;

  nlohmann::json document;
  std::string buffer;
};

/// A strip of two triangles, 1 wide and 2 high, as positions, normals and UVs.
extern const std::vector<float> kStripPositions, kStripNormals, kStripUvs;

}  // namespace coif::importer::test
