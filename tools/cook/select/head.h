#pragma once

#include "base/tool_error.h"
#include "cook/recipe/findings.h"
#include "cook/select/called.h"
#include "cook/select/hair_mesh.h"
#include "cook/select/head_room.h"

#include <Eigen/Core>
#include <tl/expected.hpp>

#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace coif::cook {

struct HairRecipe;
enum class HeadShape;

/// The head bone in the rest pose, model space.
struct HeadBone {
  std::uint32_t node = importer::kNoIndex;  ///< The source's node; kNoIndex where the hair follows none.
  std::string name = "head";
  Eigen::Vector3d joint = Eigen::Vector3d::Zero();               ///< Metres.
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  ///< Model from the bone's own axes.
};

/// Total skin weight of the hair on each node of the source.
using NodeWeights = std::vector<double>;

[[nodiscard]] NodeWeights hair_weights(const importer::SourceModel& source, const HairMesh& hair);

/// The head bone: the node called `pattern`; without one the head that the file declares; else the node called head
/// that carries, with all nodes below it, most of the hair's weight; else the lowest node above all of the hair, unless
/// it is only the node of a mesh far from it. Without any its joint is the middle of the hair. Error (kBadInput):
/// nothing is called `pattern`.
tl::expected<HeadBone, ToolError> find_head_bone(const importer::SourceModel& source, const HairMesh& hair,
                                                 const std::string& pattern);

/// Weight on a node and everything below it.
[[nodiscard]] NodeWeights weights_below(const importer::SourceModel& source, const NodeWeights& weights);

/// The head as an ellipsoid. Roots are near it, patches are sorted by the distance from its centre, and hair keeps out
/// of it unless there are better colliders.
struct FittedHead : HeadEllipsoid {
  HeadShape shape{};      ///< The recipe's shape that hair keeps out of.
  std::string origin;     ///< How it was found, for the report.
  bool declared = false;  ///< Declared by the recipe: must not be shrunk.
  double forwards = 0;    ///< Which way its joints or a beard look: 1 along +Z, -1 along -Z, 0: nothing shows it.
  bool faces_backwards = false;  ///< Looks along -Z instead of +Z.
};

/// Whether the model looks along -Z: as the recipe says, the file (VRM), or eyes and toes show; else where hair hangs
/// on the side of +Z at the height of a face and hardly any on the other. What is called a beard hangs from the face
/// itself. Decides "facing" unless the recipe does.
[[nodiscard]] bool faces_backwards(const importer::SourceModel& source, const HairMesh& hair, const FittedHead& head,
                                   const HairRecipe& recipe, Findings& findings);

/// How the head was estimated before the hair around it was looked at.
struct HeadSign {
  HeadEllipsoid shape;
  bool is_shown = false;  ///< By joints or a mesh of its own; else only by the hair's top.
};

[[nodiscard]] HeadSign first_sign_of_head(const importer::SourceModel& source, const HairMesh& hair,
                                          const HeadBone& head_bone);

/// The hair (not empty) lies on the skull at the top: a sphere through its upper part, made as high and deep as heads
/// are.
[[nodiscard]] HeadEllipsoid ellipsoid_under_top(const HairMesh& hair);
/// A ball farther down, for hair that stands high over its head, such as a bun: as far below the top of the hair's box
/// as heads are in hair of this width, metres. `z` of its centre as given.
[[nodiscard]] HeadEllipsoid ball_below_top(const Eigen::AlignedBox3d& box, double width, double z);

/// The recipe's head, if declared. Else it is estimated from vertices outside the hair's meshes that follow the head
/// bone (not if a quarter of the hair is deep inside them, as in a hood), or without those from the hair's upper part;
/// then it is moved and resized until the hair agrees (fit_head_room()), and shrunk until hardly any hair is inside.
/// Decides "head" unless the recipe does. Notes its place and how much hair is inside; warns if that is much.
[[nodiscard]] FittedHead fit_head(const importer::SourceModel& source, const HairMesh& hair, const HeadBone& head_bone,
                                  const HairRecipe& recipe, Findings& findings, const std::stop_token& stop = {});

}  // namespace coif::cook
