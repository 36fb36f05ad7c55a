#include "cook/strands/choose_patches.h"

#include "base/text.h"
#include "base/words.h"
#include "cook/recipe/strip_recipe.h"
#include "cook/select/triangle_distance.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace coif::cook {
namespace {

using Eigen::Vector3d;
using Rectangle = Eigen::AlignedBox2f;

constexpr float kSameIsland = 0.5f;         ///< Least share of two rectangles' common area, of the area of both.
constexpr std::size_t kMostIslands = 4096;  ///< More are no atlas, and comparing all would take long.

/// The part of the texture that each patch shows: the same as the first patch that shows nearly the same.
std::vector<std::uint32_t> islands_of(const HairMesh& mesh, const std::vector<PatchView>& views) {
  std::vector<Rectangle> islands;
  std::vector<std::uint32_t> island_of;
  const auto area = [](const Rectangle& r) { return r.isEmpty() ? 0 : std::max(r.volume(), 1.0e-12f); };
  for (const PatchView& view : views) {
    Rectangle shown;
    if (!mesh.uvs.empty()) {
      for (const std::uint32_t v : view.vertices) shown.extend(mesh.uvs[v]);
      const Eigen::Vector2f whole = shown.min().array().floor();  // the texture repeats
      shown.translate(-whole);
    }
    const auto same = std::ranges::find_if(islands, [&](const Rectangle& island) {
      const float common = area(island.intersection(shown));
      return island.isApprox(shown) || common > kSameIsland * (area(island) + area(shown) - common);
    });
    island_of.push_back(std::uint32_t(same - islands.begin()));
    if (same == islands.end() && islands.size() < kMostIslands) islands.push_back(shown);
  }
  return island_of;
}

double distance_of(const HairMesh& mesh, const PatchView& view, const Vector3d& point) {
  double squared = std::numeric_limits<double>::infinity();
  for (const std::size_t t : view.triangles) {
    const auto corner = [&](std::size_t k) { return Vector3d(mesh.positions[mesh.triangles[t + k]].cast<double>()); };
    squared = std::min(squared, squared_distance(point, corner(0), corner(1), corner(2)));
  }
  return std::sqrt(squared);
}

bool has(const std::vector<std::uint32_t>& numbers, std::uint32_t number) {
  return numbers.empty() || std::ranges::find(numbers, number) != numbers.end();
}

bool fits(const PatchSelection& select, const PatchListing& patch) {
  const auto named = [](const std::string& pattern, const std::string& name) {
    return pattern.empty() || matches(name, pattern);
  };
  if (!named(select.mesh, patch.mesh) || !named(select.material, patch.material)) return false;
  if (!has(select.indices, patch.number) || !has(select.islands, patch.island)) return false;
  if (!select.box) return true;
  const auto& b = *select.box;
  const Eigen::AlignedBox3d box(Vector3d(b[0], b[1], b[2]), Vector3d(b[3], b[4], b[5]));
  return box.contains(patch.middle);
}

std::vector<std::uint32_t> selected(const PatchSelection& select, const HairMesh& mesh,
                                    const std::vector<PatchView>& views, std::span<const PatchListing> listings) {
  std::vector<std::uint32_t> patches;
  std::vector<double> distances;
  for (const PatchListing& patch : listings) {
    if (!fits(select, patch)) continue;
    patches.push_back(patch.number);
    if (select.near) distances.push_back(distance_of(mesh, views[patch.number], Vector3d(select.near->data())));
  }
  if (!select.near || patches.empty()) return patches;
  if (!select.within) return {patches[std::size_t(std::ranges::min_element(distances) - distances.begin())]};
  std::vector<std::uint32_t> near;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    if (distances[i] <= *select.within) near.push_back(patches[i]);
  }
  return near;
}

tl::unexpected<ToolError> refuse(const importer::SourceModel& source, const std::string& what) {
  return tl::unexpected(
      ToolError{ToolError::Kind::kBadInput,
                fmt::format("{}: recipe key \"patches.overrides\" {}; 'coif cook {} --list patches' lists them",
                            source.path, what, source.path)});
}

void leave_out(const std::vector<bool>& dropped, HairStrips& hair, Findings& findings) {
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t p = 0; p < dropped.size(); ++p) {
    if (dropped[p]) numbers.push_back(p);
  }
  if (numbers.empty()) return;
  const std::size_t before = hair.mesh.triangle_count();
  hair.drop(dropped);
  findings.leave_out({fmt::format("{} ({})", patches_text(numbers),
                                  counted(before - hair.mesh.triangle_count(), "triangle", "triangles")),
                      "\"keep\" is false in the recipe's \"patches.overrides\""});
}

}  // namespace

std::vector<PatchListing> list_patches(const importer::SourceModel& source, const HairStrips& hair) {
  const std::vector<PatchView> views = hair.views();
  const std::vector<std::uint32_t> islands = islands_of(hair.mesh, views);
  std::vector<PatchListing> listings;
  for (std::uint32_t p = 0; p < views.size(); ++p) {
    PatchListing& patch = listings.emplace_back();
    patch.number = p;
    const importer::SourceMesh& mesh = source.meshes[hair.mesh.mesh_of_triangle[views[p].triangles.front() / 3]];
    patch.mesh = mesh.name;
    patch.material = importer::material_name(source, mesh);
    patch.island = islands[p];
    patch.triangles = views[p].triangles.size();
    Eigen::AlignedBox3d box;
    for (const std::uint32_t v : views[p].vertices) box.extend(hair.mesh.positions[v].cast<double>());
    patch.middle = box.center();
    patch.size = box.sizes();
  }
  return listings;
}

tl::expected<void, ToolError> choose_patches(const importer::SourceModel& source, const StripRecipe& recipe,
                                             bool only_lists, HairStrips& hair, std::vector<PatchListing>& listings,
                                             Findings& findings) {
  const std::vector<PatchView> views = hair.views();
  for (std::uint32_t o = 0; o < recipe.patch_overrides.size(); ++o) {
    const auto patches = selected(recipe.patch_overrides[o].select, hair.mesh, views, listings);
    if (patches.empty()) {
      const std::string what = fmt::format("[{}] selects none of the {} patches", o, listings.size());
      if (!only_lists) return refuse(source, what);
      findings.warn("C102", "\"patches.overrides\" " + what);
      continue;
    }
    for (const std::uint32_t p : patches) listings[p].overrides.push_back(o);
    findings.note(fmt::format("\"patches.overrides\" [{}]: {}", o, patches_text(patches)));
  }
  hair.overrides.said = recipe.patch_overrides;
  for (const PatchListing& patch : listings) hair.overrides.of_patch.push_back(patch.overrides);
  std::vector<bool> dropped;
  for (PatchListing& patch : listings) {
    const bool* keep = hair.said_of(patch.number, &PatchOverride::keep);
    patch.kept = keep == nullptr || *keep;
    dropped.push_back(!patch.kept);
  }
  if (std::ranges::none_of(listings, &PatchListing::kept)) return refuse(source, "keeps no patch");
  leave_out(dropped, hair, findings);
  return {};
}

void list_roots(const HairStrips& hair, std::vector<PatchListing>& listings) {
  if (hair.mesh.uvs.empty()) return;
  const std::vector<PatchView> views = hair.views();
  // Over all pieces of one patch: the change of place with each coordinate.
  std::vector<Eigen::Vector2d> slopes(listings.size(), Eigen::Vector2d::Zero());
  for (std::uint32_t p = 0; p < views.size(); ++p) {
    Eigen::Vector2d mean = Eigen::Vector2d::Zero(), sum = Eigen::Vector2d::Zero(), spread = Eigen::Vector2d::Zero();
    double place = 0;
    const auto count = double(views[p].vertices.size());
    for (const std::uint32_t v : views[p].vertices) {
      mean += hair.mesh.uvs[v].cast<double>() / count;
      place += double(hair.strands.place[v]) / count;
    }
    for (const std::uint32_t v : views[p].vertices) {
      const Eigen::Vector2d from = hair.mesh.uvs[v].cast<double>() - mean;
      sum += from * (double(hair.strands.place[v]) - place);
      spread += from.cwiseAbs2();
    }
    slopes[hair.patches.number_of(p)] += sum.cwiseQuotient(spread.cwiseMax(1.0e-12).cwiseSqrt());
  }
  for (PatchListing& patch : listings) {
    const Eigen::Vector2d& slope = slopes[patch.number];
    if (slope.isZero()) continue;
    const bool along_v = std::abs(slope.y()) >= std::abs(slope.x());
    patch.root = fmt::format("{}_{}", (along_v ? slope.y() : slope.x()) > 0 ? "low" : "high", along_v ? 'v' : 'u');
  }
}

}  // namespace coif::cook
