#pragma once

// What the checks of gltf_checks.cpp share. Private to them.

#include "base/json.h"
#include "gltf/accessors.h"
#include "gltf/buffers.h"
#include "gltf/document.h"
#include "import/source_model.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace coif::importer {

// Codes of the table of issues; tools/validate has their meanings.
namespace gltf_code {
inline constexpr const char* kRules = "S111";      ///< Containers, references, types, sizes.
inline constexpr const char* kIndices = "S112";    ///< Indices of vertices.
inline constexpr const char* kNumbers = "S113";    ///< Not finite, or out of their range.
inline constexpr const char* kJoints = "S114";     ///< Twice in a vertex, or not of the skin.
inline constexpr const char* kWeights = "S115";    ///< Sums and signs.
inline constexpr const char* kUnits = "S116";      ///< Normals, tangents and rotations.
inline constexpr const char* kBounds = "S117";     ///< Least and largest values.
inline constexpr const char* kAnimation = "S118";  ///< Key times and values.
}  // namespace gltf_code

/// Collects sentences, each once, up to a limited number.
class GltfFaults {
 public:
  void add(const char* code, std::string text);
  template <class... Args>
  void add(const char* code, fmt::format_string<Args...> text, Args&&... args) {
    add(code, fmt::format(text, std::forward<Args>(args)...));
  }
  [[nodiscard]] Diagnostics finish() &&;

 private:
  /// How often one kind of fault occurs besides the places that are named.
  struct Kind {
    std::size_t named = 0;
    std::size_t more = 0;
    std::size_t last = 0;  ///< Index in told_ of the last one that names a place.
  };
  Diagnostics told_;
  std::map<std::string, Kind> kinds_;
  std::size_t more_ = 0;
};

/// The stored numbers of an accessor.
struct StoredNumbers {
  gltf::GltfComponent component;
  bool normalized = false;
  std::size_t width = 1;  ///< Numbers of an element.
  std::vector<double> numbers;

  [[nodiscard]] std::size_t count() const { return numbers.size() / width; }
  [[nodiscard]] bool is_float() const { return component.largest == 0; }
  /// The value of the stored number `i`.
  [[nodiscard]] double value(std::size_t i) const { return gltf::gltf_value(component, normalized, numbers[i]); }
};

/// A glTF document under check.
class CheckedGltf {
 public:
  CheckedGltf(const nlohmann::json& parsed, gltf::GltfBuffers& buffers) : document(parsed), buffers_(buffers) {}

  const nlohmann::json& document;
  GltfFaults faults;

  [[nodiscard]] const nlohmann::json& list(const char* name) const { return list_of(member(document, name)); }
  [[nodiscard]] bool uses(std::string_view extension) const;
  /// None where the accessor is absent, compressed, or not within its buffer; check_gltf_accessors() reports why.
  [[nodiscard]] std::optional<StoredNumbers> read(const nlohmann::json& accessor);
  [[nodiscard]] std::optional<std::size_t> buffer_size(std::size_t buffer, std::string& why);

 private:
  gltf::GltfBuffers& buffers_;
};

/// "mesh 'hair', primitive 2"
[[nodiscard]] std::string gltf_part_name(const char* what, const nlohmann::json& object, std::size_t index);

void check_gltf_container(const std::filesystem::path& path, GltfFaults& faults);  ///< Chunks of a .glb.
void check_gltf_objects(CheckedGltf& file);  ///< Types, references, node transforms.
void check_gltf_accessors(
    CheckedGltf& file);                     ///< Views within buffers, accessors within views, bounds, finite numbers.
void check_gltf_meshes(CheckedGltf& file);  ///< Attributes and indices of primitives.
void check_gltf_skins(CheckedGltf& file);   ///< Joints and weights of primitives, bind matrices.
void check_gltf_animations(CheckedGltf& file);  ///< Key times, values.

}  // namespace coif::importer
