#include "import/imported_model.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <limits>

namespace coif::importer::test {

SourceModel import_or_fail(const std::filesystem::path& path, const ImportSettings& settings) {
  auto model = import_model(path, settings);
  if (model) {
    EXPECT_EQ(find_model_fault(*model), "") << path;
    return *std::move(model);
  }
  ADD_FAILURE() << model.error().message;
  SourceModel empty;
  empty.meshes.resize(1);
  empty.meshes[0].positions.resize(3);
  return empty;
}

std::string warnings_of(const SourceModel& model) {
  std::string all;
  for (const std::string& warning : messages_of(model.warnings)) all += warning + "\n";
  return all;
}

bool warns(const SourceModel& model, const std::string& text) {
  return warnings_of(model).find(text) != std::string::npos;
}

ImportSettings with_unit(double metres_per_unit) {
  ImportSettings settings;
  settings.metres_per_unit = metres_per_unit;
  return settings;
}

ImportSettings with_up_axis(UpAxis axis) {
  ImportSettings settings;
  settings.up_axis = axis;
  return settings;
}

Shape measure(const SourceModel& model) {
  Shape shape;
  shape.low.setConstant(std::numeric_limits<float>::max());
  shape.high.setConstant(std::numeric_limits<float>::lowest());
  for (const SourceMesh& mesh : model.meshes) {
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
      Eigen::Vector3d corner[3];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = mesh.triangles[i + k];
        shape.low = shape.low.cwiseMin(mesh.positions[v]);
        shape.high = shape.high.cwiseMax(mesh.positions[v]);
        corner[k] = mesh.positions[v].cast<double>();
        if (!mesh.uvs.empty()) shape.mean_uv += mesh.uvs[v].cast<double>();
      }
      shape.area += 0.5 * (corner[1] - corner[0]).cross(corner[2] - corner[0]).norm();
      shape.signed_volume += corner[0].dot(corner[1].cross(corner[2])) / 6.0;
      ++shape.triangles;
    }
  }
  if (shape.triangles != 0) shape.mean_uv /= 3.0 * double(shape.triangles);
  return shape;
}

}  // namespace coif::importer::test
