#include "cook/strands/strand_direction.h"

#include "base/parallel_for.h"
#include "base/text.h"
#include "cook/recipe/strip_recipe.h"
#include "cook/strands/strand_evidence.h"

#include <fmt/format.h>
#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>

namespace coif::cook {
namespace {

using Eigen::Vector3f;

constexpr float kSure = 0.5f;     ///< For RootEvidence::sum(): half a radius nearer, or a bone.
constexpr float kPainted = 0.1f;  ///< Ends whose colours differ by this much were painted as root and tip.
/// Share of the head's radius: patches that are nearer than this are neighbours.
constexpr double kBeside = 0.15;
constexpr double kMirrored = 0.08;  ///< Patches nearer than this to a mirror image are it.
constexpr double kTwin = 0.03;      ///< As kMirrored, of each vertex of twins.
constexpr float kUnsure = 0.2f;     ///< Beliefs below this are reported.

/// The recipe's root of a patch.
struct DeclaredRoot {
  int texture_axis = -1;  ///< -1: not given. Has no effect without texture coordinates.
  bool at_high_end = false;
  bool swapped = false;  ///< The other end than the one found.
};

DeclaredRoot declared_root(const std::string& root) {
  if (root == "swap") return {.swapped = true};
  if (root == "auto") return {};
  return {root.ends_with("_v") ? 1 : 0, root.starts_with("high")};
}

std::vector<DeclaredRoot> declared_roots(const std::vector<std::string>& roots, std::size_t count) {
  std::vector<DeclaredRoot> declared(count);
  for (std::size_t p = 0; p < roots.size(); ++p) declared[p] = declared_root(roots[p]);
  return declared;
}

float total_area(const HairMesh& mesh, const PatchView& view) {
  float sum = 0;
  for (std::size_t t : view.triangles) sum += doubled_area(mesh, t);
  return sum;
}

/// The texture axis of most of the area, by patches that are clearly longer along one axis.
int common_texture_axis(std::span<const PatchStrands> patches) {
  float sum = 0;
  for (const PatchStrands& patch : patches) {
    if (std::abs(patch.preference) > kLonger) sum += patch.area * (patch.preference > 0 ? 1.0f : -1.0f);
  }
  return sum >= 0 ? 1 : 0;
}

/// The overall direction of the strands: from the middle of the patch's first half to that of its second.
Vector3f overall_direction(const HairMesh& mesh, const PatchView& view, std::span<const float> place) {
  Vector3f sum = Vector3f::Zero(), mean = Vector3f::Zero();
  for (std::uint32_t v : view.vertices) mean += mesh.positions[v] / float(view.vertices.size());
  for (std::uint32_t v : view.vertices) sum += (mesh.positions[v] - mean) * (place[v] - 0.5f);
  return sum.norm() > 0 ? Vector3f(sum.normalized()) : Vector3f(0, -1, 0);
}

/// Tangents of one patch from StrandField::place.
void write_tangents(const HairMesh& mesh, const PatchView& view, int texture_axis, StrandField& field) {
  for (std::size_t t : view.triangles) {
    // Along the texture's own axis, if any: painted strands are parallel to it even where it is sheared.
    const Vector3f along =
        texture_axis >= 0 ? texture_axes(mesh, t)[std::size_t(texture_axis)] : gradient(mesh, t, field.place);
    if (!(along.norm() > 0)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      field.tangent[mesh.triangles[t + k]] += along.normalized() * doubled_area(mesh, t);
    }
  }
  const Vector3f fallback = overall_direction(mesh, view, field.place);
  for (std::uint32_t v : view.vertices) {
    const Vector3f& normal = mesh.normals[v];
    Vector3f tangent = field.tangent[v].isZero() ? fallback : Vector3f(field.tangent[v].normalized());
    tangent -= normal * normal.dot(tangent);
    field.tangent[v] = tangent.norm() > 1.0e-4f ? Vector3f(tangent.normalized()) : Vector3f(normal.unitOrthogonal());
  }
}

/// Writes a patch as if its low end were the root.
void write_patch(const HairMesh& mesh, const PatchView& view, const StrandAxis& axis, StrandField& field) {
  for (std::size_t i = 0; i < view.vertices.size(); ++i) field.place[view.vertices[i]] = axis.coordinate[i];
  write_tangents(mesh, view, axis.texture_axis, field);
}

/// The votes of the patches about their roots.
std::vector<RootVote> votes_of(std::span<const PatchStrands> patches, const RootWeights& weights) {
  std::vector<RootVote> votes;
  for (const PatchStrands& patch : patches) {
    const int axis = patch.axis.texture_axis;
    const float differ = axis < 0 ? 0 : patch.seen.differ[std::size_t(axis)];
    votes.push_back(
        {axis, patch.evidence.sum(weights), patch.area, std::clamp(differ / kPainted, weights.habit, 1.0f)});
  }
  return votes;
}

void turn_round(const PatchView& view, StrandField& field) {
  for (std::uint32_t v : view.vertices) {
    field.place[v] = 1 - field.place[v];
    field.tangent[v] = -field.tangent[v];
  }
}

}  // namespace

StrandField find_strand_direction(const HairStrips& hair, const FittedHead& head, const StrandSettings& settings,
                                  Findings& findings) {
  const HairMesh& mesh = hair.mesh;
  StrandField field;
  field.tangent.assign(mesh.positions.size(), Vector3f::Zero());
  field.place.assign(mesh.positions.size(), 0.0f);
  const std::vector<PatchView> views = hair.views();
  const std::vector<DeclaredRoot> declared = declared_roots(settings.roots, views.size());
  std::vector<PatchStrands> strands(views.size());
  parallel_for(views.size(), settings.threads, [&](std::size_t p) {
    strands[p].area = total_area(mesh, views[p]);
    strands[p].twin = {std::uint32_t(p), 1};
    strands[p].preference = settings.trust_texture ? texture_preference(mesh, views[p]) : 0;
    if (!settings.seen.empty()) strands[p].seen = settings.seen[p];
  });
  const int common = common_texture_axis(strands);
  const FreeHair free_hair(mesh, views, head);
  const Surroundings around{head, free_hair, settings.depth_of_node, settings.weights};
  const double size = head.radii.mean();
  const auto middle = float(head.center.x());
  const std::vector<std::uint32_t> twins = find_twins(mesh, views, middle, float(kTwin * size));
  const auto is_told = [&](std::size_t p) { return declared[p].texture_axis >= 0 && strands[p].preference != 0; };
  const auto seeking = [&](std::uint32_t p) { return Seeking{views[p], p, strands[p]}; };
  parallel_for(views.size(), settings.threads, [&](std::size_t p) {
    const std::uint32_t twin = twins[p];
    if (is_told(p)) {
      strands[p].axis = strand_axis(hair, views[p], declared[p].texture_axis);
    } else if (twin == p || is_told(twin)) {
      choose_axis(hair, seeking(std::uint32_t(p)), around, common);
    } else if (p < twin) {
      choose_axes(hair, seeking(std::uint32_t(p)), seeking(twin), around, common);
    }
  });
  parallel_for(views.size(), settings.threads,
               [&](std::size_t p) { write_patch(mesh, views[p], strands[p].axis, field); });
  const std::stop_token& stop = settings.threads.stop;
  PatchCompany company{find_neighbours(mesh, views, field.tangent, kBeside * size, stop),
                       find_mirror_images(mesh, views, field.tangent, middle, kMirrored * size, stop)};
  for (const PatchStrands& patch : strands) company.twins.push_back(patch.twin);
  const std::vector<float> belief =
      settle_beliefs(mesh, views, votes_of(strands, settings.weights), company, settings.weights, stop);
  std::size_t sure = 0;
  float along_u = 0;
  std::vector<FoundRoot> found;
  for (std::uint32_t p = 0; p < views.size(); ++p) {
    const int axis = strands[p].axis.texture_axis;
    const bool by_recipe = declared[p].texture_axis >= 0 && axis >= 0;
    if (by_recipe ? declared[p].at_high_end : (belief[p] < 0) != declared[p].swapped) turn_round(views[p], field);
    found.push_back({strands[p].area, belief[p], strands[p].evidence.sum(settings.weights), strands[p].mirrored,
                     by_recipe || declared[p].swapped});
    sure += !by_recipe && std::abs(strands[p].evidence.sum(settings.weights)) >= kSure ? 1 : 0;
    if (!by_recipe && std::abs(belief[p]) < kUnsure) field.unsure.push_back(hair.patches.number_of(p));
    along_u += by_recipe ? strands[p].area * (axis == 0 ? 1.0f : -1.0f) : 0.0f;
  }
  field.along_u = (along_u != 0 ? along_u > 0 : common == 0) && !mesh.uvs.empty();
  std::ranges::sort(field.unsure);
  if (!field.unsure.empty())
    findings.note(fmt::format("roots: {} of {} patches unsure: {} of 'coif cook --list patches'", field.unsure.size(),
                              views.size(), numbers_text(field.unsure)));
  field.doubts = doubts_of(mesh, views, found, company, field.tangent, head);
  const auto told = std::size_t(std::ranges::count(found, true, &FoundRoot::is_told));
  if (told < found.size()) {
    findings.decide(decision_of(field.doubts, told, sure, found.size()));
  } else {
    findings.note(fmt::format("roots: told of all {} patches", told));
  }
  return field;
}

std::vector<std::string> declared_roots(const StripRecipe& recipe, const importer::SourceModel& source,
                                        const HairStrips& hair) {
  const bool is_known = recipe.strand_root == "auto" && source.made_from_strands;
  std::vector<std::string> roots(hair.patches.count, is_known ? "low_v" : recipe.strand_root);
  for (std::uint32_t p = 0; p < roots.size(); ++p) {
    if (const std::string* said = hair.said_of(p, &PatchOverride::root)) roots[p] = *said;
  }
  return roots;
}

std::vector<float> depths_below(const importer::SourceModel& source, std::uint32_t head_node) {
  std::vector<float> depth(source.nodes.size(), -1.0f);
  if (head_node != importer::kNoIndex) depth[head_node] = 0;
  for (std::uint32_t n = 0; n < source.nodes.size(); ++n) {
    const std::uint32_t parent = source.nodes[n].parent;
    if (n != head_node && parent != importer::kNoIndex && depth[parent] >= 0) depth[n] = depth[parent] + 1;
  }
  for (float& d : depth) d = std::max(d, 0.0f);
  return depth;
}

}  // namespace coif::cook
