#pragma once

// Small models that tests write for themselves.

#include "import/import.h"
#include "import/source_model.h"

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace coif::importer::test {

/// An empty folder of its own, removed with everything in it.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Writes `text` into the folder and returns the file's path.
  std::filesystem::path write(const std::string& name, const std::string& text) const;

 private:
  std::filesystem::path path_;
};

/// One skinned or rigid triangle mesh as glTF, with the fields that tests vary. Written as JSON beside a .bin file.
struct SmallGltf {
  std::vector<float> positions{0, 0, 0, 1, 0, 0, 0, 1, 0};
  std::vector<float> normals{0, 0, 1, 0, 0, 1, 0, 0, 1};
  std::vector<float> uvs{0, 0, 1, 0, 0, 0.25f};
  std::vector<std::uint16_t> indices{0, 1, 2};
  std::vector<std::uint16_t> joints;  ///< Four per vertex, or empty: no skin.
  std::vector<float> weights;         ///< Four per vertex.
  /// JSON of the node array. Mesh 0 may be used, and skin 0: `skin_joints`, two at most, bind matrices identity.
  std::string nodes = R"([{"name": "strip", "mesh": 0}])";
  std::string roots = "[0]";
  std::string skin_joints = "[1]";
  std::string material = R"({"name": "hair"})";
  std::string images;  ///< JSON members after "meshes", for example textures; each ends with a comma.

  [[nodiscard]] std::filesystem::path write(const TemporaryFolder& folder, const std::string& name) const;
};

/// "min" and "max" of an accessor of places, which glTF asks for, as JSON; nothing where one is no number, which JSON
/// cannot have.
[[nodiscard]] std::string bounds_of(std::span<const float> places);

/// An ASCII FBX of lines of GlobalSettings, objects and connections.
[[nodiscard]] std::string fbx_document(const std::string& settings, const std::string& objects,
                                       const std::string& connections);
/// A model of such a file, with lines of its properties.
[[nodiscard]] std::string fbx_model(int model, const std::string& name, const std::string& model_class,
                                    const std::string& properties = "");
/// The same of a mesh, with its geometry: one triangle (0,0,0) (1,0,0) (0,2,3) in file units.
[[nodiscard]] std::string fbx_triangle(int geometry, const std::string& name, int model,
                                       const std::string& properties = "");
/// ASCII FBX with one triangle (0,0,0) (1,0,0) (0,2,3) in file units; `settings` are lines of GlobalSettings.
[[nodiscard]] std::string small_fbx(const std::string& settings);
/// One line for small_fbx.
[[nodiscard]] std::string fbx_int(const std::string& name, int value);

/// COLLADA with the same triangle.
[[nodiscard]] std::string small_dae(const std::string& unit_metres, const std::string& up_axis);

// Small glTF documents with VRM's extensions.

/// body > head > hair_1 > hair_2 > hair_end, straight up by 1 m, then down by 0.1 m each, and a strip beside them; the
/// nodes 0 to 5 of the document, in this order: strip, body, head, hair_1, hair_2, hair_end. `extensions` is JSON.
[[nodiscard]] SmallGltf small_vrm(const std::string& extensions);

/// A VRMC_springBone extension; the arguments are JSON lists.
[[nodiscard]] std::string spring_bone_1(const std::string& springs, const std::string& colliders = "[]",
                                        const std::string& groups = "[]");
/// A VRM 0.x extension with a humanoid whose head is node 2.
[[nodiscard]] std::string spring_bone_0(const std::string& bone_groups, const std::string& collider_groups = "[]");

/// One binary glTF of a document and its buffer.
[[nodiscard]] std::string glb_of(std::string json, std::string buffer);

/// A .gltf that SmallGltf wrote, as one binary file with its buffer inside.
[[nodiscard]] std::string as_glb(const std::filesystem::path& gltf);

// Animated glTF documents that tests write for themselves.

/// One node, and an animation of it; what tests vary is in `document` until text() is asked for.
class ClipDocument {
 public:
  ClipDocument();

  /// Adds a channel to the first animation that moves `node` ("translation", "rotation" or "scale").
  ClipDocument& animate(std::size_t node, const std::string& path, const std::vector<float>& seconds,
                        const std::vector<float>& values, const char* interpolation = "LINEAR");

  /// As .gltf with its buffer inside.
  [[nodiscard]] std::string text() const;
  /// As .gltf with its buffer in the file `uri`, whose content is buffer().
  [[nodiscard]] std::string text_beside(const std::string& uri) const;
  [[nodiscard]] std::string glb() const;
  [[nodiscard]] const std::string& buffer() const { return buffer_; }

  nlohmann::json document;  ///< Nodes: 0, "head".

 private:
  std::size_t add(const std::vector<float>& values, const char* type, std::size_t width);

  std::string buffer_;
};

/// Quaternions (x, y, z, w) of a nod about X, one for each time.
[[nodiscard]] std::vector<float> turns_about_x(const std::vector<float>& seconds,
                                               const std::function<double(double)>& radians);

/// A triangle on two nodes that uses every field of a model and keeps all of its promises.
[[nodiscard]] SourceModel small_source_model();

}  // namespace coif::importer::test
