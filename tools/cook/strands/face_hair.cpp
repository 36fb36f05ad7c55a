#include "cook/strands/choose_patches.h"

#include "cook/recipe/strip_recipe.h"
#include "cook/select/called.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace coif::cook {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

// Shares of the head's radii, each along its own axis; Z is forwards.
constexpr double kWidestBrow = 0.95, kHighestBrow = 0.35;
constexpr double kBrowLeastForwards = 0.6, kBrowMostAbove = 0.7, kBrowMostBelow = 0.25;
constexpr double kCloseToFace = 0.35;  ///< Share of its middle's distance, outwards or inwards.
constexpr double kMirrorSlack = 0.12;

/// Names of a patch's mesh and material.
std::array<std::string, 2> names_of(const importer::SourceModel& source, const HairStrips& hair,
                                    const PatchView& patch) {
  const importer::SourceMesh& mesh = source.meshes[hair.mesh.mesh_of_triangle[patch.triangles.front() / 3]];
  return {mesh.name, importer::material_name(source, mesh)};
}

/// The box of a patch, in shares of the head's radii from its centre, in the face's directions.
AlignedBox3d box_on_head(const HairStrips& hair, const PatchView& patch, const FittedHead& head) {
  AlignedBox3d box;
  for (const std::uint32_t v : patch.vertices) {
    Vector3d p = (hair.mesh.positions[v].cast<double>() - head.center).cwiseQuotient(head.radii);
    if (head.faces_backwards) p = {-p.x(), p.y(), -p.z()};
    box.extend(p);
  }
  return box;
}

bool lies_as_a_brow(const AlignedBox3d& box) {
  const Vector3d size = box.sizes(), middle = box.center();
  const bool is_small = size.x() < kWidestBrow && size.y() < kHighestBrow && size.x() > size.y();
  const bool is_before_face =
      middle.z() > kBrowLeastForwards && middle.y() < kBrowMostAbove && middle.y() > -kBrowMostBelow;
  return is_small && is_before_face && std::abs(middle.norm() - 1) < kCloseToFace;
}

bool mirror_each_other(const AlignedBox3d& a, const AlignedBox3d& b) {
  const Vector3d mirrored(-b.center().x(), b.center().y(), b.center().z());
  return (a.center() - mirrored).cwiseAbs().maxCoeff() < kMirrorSlack &&
         (a.sizes() - b.sizes()).cwiseAbs().maxCoeff() < kMirrorSlack && a.center().x() * b.center().x() < 0;
}

std::string numbered(const HairStrips& hair, std::span<const std::uint32_t> patches) {
  std::vector<std::uint32_t> numbers;
  for (const std::uint32_t p : patches) numbers.push_back(hair.patches.number_of(p));
  std::ranges::sort(numbers);
  return patches_text(numbers);
}

}  // namespace

FaceHair find_face_hair(const importer::SourceModel& source, const HairStrips& hair, const FittedHead& head) {
  FaceHair found;
  std::vector<std::pair<std::uint32_t, AlignedBox3d>> perhaps;
  const std::vector<PatchView> views = hair.views();
  for (std::uint32_t p = 0; p < views.size(); ++p) {
    const auto names = names_of(source, hair, views[p]);
    const AlignedBox3d box = box_on_head(hair, views[p], head);
    if (std::ranges::any_of(names, is_called_beard)) {
      found.beard.push_back(p);
    } else if (std::ranges::any_of(names, is_called_brow)) {
      found.brows.push_back(p);
    } else if (lies_as_a_brow(box)) {
      perhaps.emplace_back(p, box);
    }
  }
  for (const auto& [p, box] : perhaps) {
    const auto is_mirrored = [&](const auto& other) { return mirror_each_other(box, other.second); };
    if (std::ranges::any_of(perhaps, is_mirrored)) found.brows.push_back(p);
  }
  std::ranges::sort(found.brows);
  return found;
}

tl::expected<void, ToolError> choose_face_hair(const importer::SourceModel& source, const StripRecipe& recipe,
                                               const FittedHead& head, HairStrips& hair, Findings& findings) {
  const FaceHair found = find_face_hair(source, hair, head);
  std::vector<bool> dropped(hair.patches.count, false);
  const auto choose = [&](const char* name, const char* key, const std::vector<std::uint32_t>& patches, bool keeps) {
    if (patches.empty()) return;
    const std::string which = numbered(hair, patches);
    if (keeps)
      return findings.note(fmt::format("{}: {}; \"hair.{}\": false in the recipe leaves them out", name, which, key));
    for (const std::uint32_t p : patches) dropped[p] = true;
    findings.leave_out({fmt::format("{}: {}", name, which), fmt::format("\"hair.{}\" is false", key)});
  };
  choose("brows", "brows", found.brows, recipe.hair_brows);
  choose("beard", "beard", found.beard, recipe.hair_beard);
  const auto gone = std::ranges::count(dropped, true);
  if (gone == std::ptrdiff_t(dropped.size())) {
    return tl::unexpected(ToolError{ToolError::Kind::kBadInput,
                                    source.path +
                                        ": all of the hair is brows and beard, which the recipe's \"hair.brows\" and "
                                        "\"hair.beard\" leave out; set them to true"});
  }
  if (gone > 0) hair.drop(dropped);
  return {};
}

}  // namespace coif::cook
