#pragma once

#include "base/linear_picture.h"
#include "base/tool_error.h"
#include "render/picture.h"

#include <Eigen/Core>
#include <tl/expected.hpp>

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace coif::report {

/// A picture that another renderer made of the same hair, as the folder's list says.
struct TruthScene {
  std::string view, color, light;  ///< Names for people.
  /// Two files, OpenEXR: the same picture with noise that has nothing in common, so that the mean of products has none.
  std::array<std::filesystem::path, 2> files;
  render::CameraPlace camera;
  render::PictureLight lights;
  std::optional<Eigen::Vector3f> base_color;  ///< The hair's, linear, in place of the asset's factor.

  [[nodiscard]] std::string name() const { return view + ", " + color + ", " + light; }
};

/// A path-traced picture: hair alone, what hides it is cut out.
struct TruthPicture {
  std::array<LinearPicture, 2> halves;
  [[nodiscard]] LinearPicture mean() const;
};

/// Reads FOLDER/truth.json: {"scenes": [{"view", "color", "light", "pictures": ["a.exr", "b.exr"], "camera", "lights",
/// "sky": [r, g, b], "base_color": [r, g, b]}]}, cameras and lights as in render/camera_file.h. Errors: kFileAccess,
/// kBadInput, with the place.
[[nodiscard]] tl::expected<std::vector<TruthScene>, ToolError> read_truth_list(const std::filesystem::path& folder,
                                                                               const Eigen::Vector3d& joint);

/// Errors: kFileAccess, kBadInput; both files must have the same size.
[[nodiscard]] tl::expected<TruthPicture, ToolError> read_truth(const TruthScene& scene);

}  // namespace coif::report
