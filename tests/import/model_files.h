#pragma once
// Small models that tests write for themselves, and what tests measure on imported ones.

#include "import/import.h"

#include <Eigen/Core>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace coif::test {

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

/// ASCII FBX with one triangle (0,0,0) (1,0,0) (0,2,3) in file units; `settings` are lines of GlobalSettings.
[[nodiscard]] std::string small_fbx(const std::string& settings);
/// One line for small_fbx.
[[nodiscard]] std::string fbx_int(const std::string& name, int value);

/// COLLADA with the same triangle.
[[nodiscard]] std::string small_dae(const std::string& unit_metres, const std::string& up_axis);

[[nodiscard]] ImportSettings with_unit(double metres_per_unit);
[[nodiscard]] ImportSettings with_up_axis(UpAxis axis);

/// What should not depend on the file format that carried a shape.
struct Shape {
  Eigen::Vector3f low, high;      ///< Bounding box, metres.
  double area = 0;                ///< Square metres.
  double signed_volume = 0;       ///< Changes sign when the winding turns.
  Eigen::Vector2d mean_uv{0, 0};  ///< Over triangle corners.
  std::size_t triangles = 0;
};
[[nodiscard]] Shape measure(const SourceModel& model);

}  // namespace coif::test
