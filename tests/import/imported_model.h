#pragma once

// What tests ask of imported models.

#include "import/import.h"
#include "import/source_model.h"

#include <Eigen/Core>

#include <cstddef>
#include <filesystem>
#include <string>

namespace coif::importer::test {

/// The model, which keeps all of its promises. Fails the test where it does not, or where there is none, in whose place
/// comes one with a mesh of three vertices.
[[nodiscard]] SourceModel import_or_fail(const std::filesystem::path& path, const ImportSettings& settings = {});

/// One line each.
[[nodiscard]] std::string warnings_of(const SourceModel& model);
[[nodiscard]] bool warns(const SourceModel& model, const std::string& text);

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

}  // namespace coif::importer::test
