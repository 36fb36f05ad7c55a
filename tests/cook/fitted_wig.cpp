#include "cook/fitted_wig.h"

#include "cook/recipe/recipe.h"
#include "cook/rig/skeleton.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coif::cook {
namespace {

constexpr float kRadius = 0.1f;

Eigen::Vector3f towards(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return {float(std::sin(angle)), 0, float(std::cos(angle))};
}

/// Direction and place of the strands along a strip of two vertices per row.
void append_strands(const importer::SourceMesh& strip, StrandField& strands) {
  const std::size_t count = strip.positions.size();
  for (std::size_t v = 0; v < count; ++v) {
    const std::size_t above = v >= 2 ? v - 2 : v, below = v + 2 < count ? v + 2 : v;
    strands.tangent.push_back((strip.positions[below] - strip.positions[above]).normalized());
    strands.place.push_back(float(v / 2) / float(count / 2 - 1));
  }
}

void append(const importer::SourceMesh& strip, std::uint32_t number, HairMesh& hair) {
  const auto first = std::uint32_t(hair.positions.size());
  hair.positions.insert(hair.positions.end(), strip.positions.begin(), strip.positions.end());
  for (std::uint32_t v : strip.triangles) hair.triangles.push_back(first + v);
  hair.mesh_of_triangle.insert(hair.mesh_of_triangle.end(), strip.triangles.size() / 3, number);
}

}  // namespace

FittedHead round_head() {
  FittedHead head;
  head.center = {0, 1.6, 0};
  head.radii.setConstant(double(kRadius));
  return head;
}

std::vector<Eigen::Vector3d> FittedWig::joints(std::uint32_t chain) const {
  const ChainRecord& record = rig.skeleton.chains.at(chain);
  std::vector<Eigen::Vector3d> joints{rig.skeleton.bones.at(record.first_bone).start};
  for (std::uint32_t b = 0; b < record.bone_count; ++b) {
    joints.push_back(rig.skeleton.bones.at(record.first_bone + b).tail);
  }
  return joints;
}

double FittedWig::length(std::uint32_t chain) const {
  double sum = 0;
  const auto all = joints(chain);
  for (std::size_t j = 1; j < all.size(); ++j) sum += (all[j] - all[j - 1]).norm();
  return sum;
}

double FittedWig::weight(std::uint32_t vertex, std::uint32_t bone) const {
  double sum = 0;
  for (const BoneWeight& w : rig.weights.at(vertex)) sum += w.bone == bone ? w.weight : 0;
  return sum;
}

double FittedWig::weight_difference(std::uint32_t a, std::uint32_t b) const {
  double sum = 0;
  for (std::uint32_t bone = 0; bone < rig.skeleton.bones.size(); ++bone) {
    sum += 0.5 * std::abs(weight(a, bone) - weight(b, bone));
  }
  return sum;
}

FittedWig fit_wig(const std::vector<importer::SourceMesh>& strips, const Recipe& recipe) {
  FittedWig wig;
  wig.source.path = "wig.glb";
  wig.source.meshes = strips;
  const std::uint32_t node = add_node(wig.source, "Head", importer::kNoIndex, {0, 1.5, 0});
  StrandField strands;
  for (std::uint32_t s = 0; s < strips.size(); ++s) {
    append(strips[s], s, wig.hair);
    append_strands(strips[s], strands);
  }
  const HeadBone bone{node, "Head", {0, 1.5, 0}};
  HairStrips hair = strips_from(wig.hair);
  hair.strands = std::move(strands);
  wig.rig = fit_chains(wig.source, hair, round_head(), head_alone(wig.source, bone), recipe, wig.findings);
  return wig;
}

importer::SourceMesh make_tail(double degrees, float length, std::uint32_t rows) {
  const Eigen::Vector3f out = towards(degrees);
  return make_strip({.root = Eigen::Vector3f(0, 1.6f, 0) + out * (kRadius + 0.005f),
                     .along = {0, -length, 0},
                     .across = out.cross(Eigen::Vector3f::UnitY()) * 0.02f,
                     .rows = rows});
}

importer::SourceMesh make_scalp_strip(double degrees) {
  importer::SourceMesh strip = make_strip({.rows = 20});
  const Eigen::Vector3f out = towards(degrees), side = out.cross(Eigen::Vector3f::UnitY());
  for (std::uint32_t v = 0; v < strip.positions.size(); ++v) {
    const auto angle = float(v / 2) / 20 * float(std::numbers::pi / 2);
    const Eigen::Vector3f on_head = Eigen::Vector3f::UnitY() * std::cos(angle) + out * std::sin(angle);
    strip.positions[v] =
        Eigen::Vector3f(0, 1.6f, 0) + on_head * (kRadius + 0.004f) + side * 0.02f * (v % 2 == 0 ? -0.5f : 0.5f);
  }
  return strip;
}

std::vector<importer::SourceMesh> mirrored(std::vector<importer::SourceMesh> strips) {
  for (importer::SourceMesh& strip : strips) {
    for (Eigen::Vector3f& p : strip.positions) p.x() = -p.x();
    for (std::size_t t = 0; t < strip.triangles.size(); t += 3) std::swap(strip.triangles[t], strip.triangles[t + 1]);
  }
  return strips;
}

}  // namespace coif::cook
