#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace coif::cook {

/// The shape of the head that hair keeps out of.
enum class HeadShape { kAuto, kEllipsoid, kSphere, kCapsule, kNothing };

/// Where a model looks.
enum class Faces { kAuto, kPlusZ, kMinusZ };

/// The recipe's values for choosing the hair's triangles, and for the head that it grows on.
struct HairRecipe {
  // Patterns with * and ?, letters of either case.
  std::vector<std::string> hair_meshes;
  std::vector<std::string> hair_materials;
  std::vector<std::string> hair_bones;
  std::vector<std::array<double, 3>> hair_parts;  ///< Points on parts that are hair, model space, metres.

  /// The recipe names what is hair.
  [[nodiscard]] bool names_hair() const {
    return !hair_meshes.empty() || !hair_materials.empty() || !hair_bones.empty() || !hair_parts.empty();
  }

  double patch_weld_distance = 0;  ///< Metres.
  std::string head_bone;           ///< Pattern; "": found by name and hierarchy.
  HeadShape head_shape = HeadShape::kAuto;
  Faces head_faces = Faces::kAuto;
  std::optional<std::array<double, 3>> head_center;  ///< Model space, metres.
  std::optional<std::array<double, 3>> head_radii;   ///< Metres.
};

}  // namespace coif::cook
