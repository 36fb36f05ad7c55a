#include "import/assimp_scene.h"

#include "base/geometry.h"
#include "import/source_warnings.h"

#include <assimp/commonMetaData.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace coif::importer {

Eigen::Matrix3d y_up_from(UpAxis up) {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  if (up == UpAxis::kX) rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  if (up == UpAxis::kZ) rotation << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  return rotation;
}

namespace {

std::optional<double> number(const aiMetadata* metadata, const char* key) {
  if (metadata == nullptr) return std::nullopt;
  double wide = 0;
  float narrow = 0;
  int whole = 0;
  if (metadata->Get(std::string(key), wide)) return wide;
  if (metadata->Get(std::string(key), narrow)) return double{narrow};
  if (metadata->Get(std::string(key), whole)) return double(whole);
  return std::nullopt;
}

// The file's axis, as a vector of file space, that an FBX "...Axis" and "...AxisSign" pair names.
std::optional<Eigen::Vector3d> axis(const aiMetadata* metadata, const std::string& name) {
  const double index = number(metadata, name.c_str()).value_or(-1);
  const double sign = number(metadata, (name + "Sign").c_str()).value_or(1);
  if (index != 0 && index != 1 && index != 2) return std::nullopt;
  return Eigen::Vector3d::Unit(static_cast<Eigen::Index>(index)) * (sign < 0 ? -1.0 : 1.0);
}

// FBX names the file's right (Coord), up and front axes; front points at the viewer, so (right, up, front) = (X, Y, Z).
Eigen::Matrix3d y_up_from_fbx(const aiMetadata* metadata, Diagnostics& warnings) {
  const auto right = axis(metadata, "CoordAxis");
  const auto up = axis(metadata, "UpAxis");
  const auto front = axis(metadata, "FrontAxis");
  if (right && up && front) {
    Eigen::Matrix3d rows;
    rows << right->transpose(), up->transpose(), front->transpose();
    if (rows.determinant() < -0.5) warn(warnings, source_code::kSpace, "left-handed axes in the file were mirrored");
    if (std::abs(rows.determinant()) > 0.5) return rows;
  }
  if (!up) return Eigen::Matrix3d::Identity();
  warn(warnings, source_code::kSpace, "the file's axes contradict each other; only its up axis is used");
  return y_up_from(up->x() != 0 ? UpAxis::kX : up->z() != 0 ? UpAxis::kZ : UpAxis::kY);
}

constexpr double kMetresPerCentimetre = 0.01;

double fbx_metres_per_unit(const aiMetadata* metadata, SourceSpace& space, Diagnostics& warnings) {
  const std::optional<double> said = number(metadata, "UnitScaleFactor");
  const double centimetres = said.value_or(1.0);
  if (!(std::isfinite(centimetres) && centimetres > 0)) {
    warn(warnings, source_code::kSpace, "UnitScaleFactor {} is not a length; centimetres are assumed", centimetres);
    space.unit_words = "an FBX without a unit is in centimetres";
    return kMetresPerCentimetre;
  }
  // Every exporter writes 1 unless somebody set another unit.
  if (centimetres != 1) space.unit = Statement::kDeclared;
  space.unit_words = !said              ? std::string("an FBX without a unit is in centimetres")
                     : centimetres == 1 ? std::string("UnitScaleFactor 1, centimetres")
                                        : fmt::format("UnitScaleFactor {:.6g}", centimetres);
  return kMetresPerCentimetre * centimetres;
}

// assimp has put the COLLADA unit into the root node as a uniform scale.
double unit_in_root(const aiScene& scene) {
  const double unit = std::cbrt(std::abs(double(scene.mRootNode->mTransformation.Determinant())));
  return std::isfinite(unit) && unit > 0 ? unit : 1.0;
}

/// The axis that a rotation takes to Y.
char axis_up(const Eigen::Matrix3d& rotation) {
  Eigen::Index axis = 1;
  rotation.row(1).cwiseAbs().maxCoeff(&axis);
  return char('x' + axis);
}

std::string generator_of(const aiScene& scene) {
  aiString text;
  if (scene.mMetaData == nullptr || !scene.mMetaData->Get(AI_METADATA_SOURCE_GENERATOR, text)) return "";
  return text_of(text);
}

/// Sets the format's defaults, before the file's own values. Length: metres per unit.
void read_format(const aiScene& scene, SourceFormat format, SourceSpace& space) {
  switch (format) {
    case SourceFormat::kFbx:
      space.unit = space.up = Statement::kUsual;
      space.up_words = "the file's axes";
      break;
    case SourceFormat::kDae:
      space.metres_per_unit = unit_in_root(scene);
      space.unit = std::abs(space.metres_per_unit - 1) < 1.0e-6 ? Statement::kUsual : Statement::kDeclared;
      space.up = Statement::kDeclared;
      space.unit_words = fmt::format("<unit meter=\"{:.6g}\">", space.metres_per_unit);
      space.up_words = "<up_axis>";
      space.up_axis = axis_up(rotation_part(affine_of(scene.mRootNode->mTransformation)));
      break;
    case SourceFormat::kObj:
      space.unit = space.up = Statement::kUnsaid;
      space.unit_words = "OBJ has no unit";
      space.up_words = "OBJ has no up axis";
      break;
    case SourceFormat::kGltf:
    case SourceFormat::kHair:
    case SourceFormat::kTressFx: break;  // assimp never makes a scene of it.
  }
}

}  // namespace

Eigen::Affine3d model_from_scene(const aiScene& scene, SourceFormat format, const ImportSettings& settings,
                                 SourceSpace& space, Diagnostics& warnings) {
  space.generator = generator_of(scene);
  read_format(scene, format, space);
  double scale = 1;
  Eigen::Matrix3d rotation = y_up_from(settings.up_axis.value_or(UpAxis::kY));
  if (format == SourceFormat::kFbx && !settings.metres_per_unit) {
    scale = space.metres_per_unit = fbx_metres_per_unit(scene.mMetaData, space, warnings);
  }
  if (format == SourceFormat::kFbx && !settings.up_axis) rotation = y_up_from_fbx(scene.mMetaData, warnings);
  if (settings.metres_per_unit) {
    scale = *settings.metres_per_unit;
    if (format == SourceFormat::kDae) scale /= unit_in_root(scene);
    space.metres_per_unit = *settings.metres_per_unit;
    space.unit = Statement::kGiven;
  }
  if (settings.up_axis) space.up = Statement::kGiven;
  if (settings.up_axis || format == SourceFormat::kFbx) space.up_axis = axis_up(rotation);
  Eigen::Affine3d model_from_scene = Eigen::Affine3d::Identity();
  model_from_scene.linear() = scale * rotation;
  return model_from_scene;
}

}  // namespace coif::importer
