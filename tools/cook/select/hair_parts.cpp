#include "cook/select/hair_candidates.h"
#include "cook/select/triangle_distance.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace coif::cook {
namespace {

using Eigen::Vector3d;
using importer::SourceMesh, importer::SourceModel;

constexpr std::size_t kMostTries = 64;  ///< Triangles of a part that are tried for a point that is on no other.
constexpr double kReach = 0.1;          ///< Metres: a point that is farther from every part is on none.
constexpr double kDigits = 1.0e4;       ///< Points are told to 0.1 mm.

std::array<Vector3d, 3> corners_of(const SourceMesh& mesh, std::size_t t) {
  const auto corner = [&](std::size_t k) { return mesh.positions[mesh.triangles[3 * t + k]].cast<double>(); };
  return {corner(0), corner(1), corner(2)};
}

/// Parts with the boxes around them, to ask many times which is nearest.
class PartFinder {
 public:
  PartFinder(const SourceModel& source, const HairCandidates& parts) : source_(source), parts_(parts) {
    for (const HairCandidate& part : parts.list) {
      Eigen::AlignedBox3d& box = boxes_.emplace_back();
      for (std::size_t t = 0; t < part.taken.size(); ++t)
        if (part.taken[t])
          for (const Vector3d& corner : corners_of(source.meshes[part.mesh], t)) box.extend(corner);
    }
  }

  /// The number of the nearest part within `reach` metres, the first of equals; that of no part where there is none.
  [[nodiscard]] std::size_t nearest(const Vector3d& point, double reach = kReach) const {
    std::size_t best = parts_.list.size();
    double least = reach * reach;
    for (std::size_t p = 0; p < parts_.list.size(); ++p) {
      const HairCandidate& part = parts_.list[p];
      if (boxes_[p].squaredExteriorDistance(point) >= least) continue;
      for (std::size_t t = 0; t < part.taken.size(); ++t) {
        if (!part.taken[t]) continue;
        const auto [a, b, c] = corners_of(source_.meshes[part.mesh], t);
        const double distance = squared_distance(point, a, b, c);
        if (!(distance < least)) continue;
        least = distance;
        best = p;
      }
    }
    return best;
  }

  /// The middle of a large triangle of the part, to which no other part is nearer.
  [[nodiscard]] Vector3d place_on(std::size_t p) const {
    const HairCandidate& part = parts_.list[p];
    std::vector<std::pair<double, std::size_t>> by_area;
    for (std::size_t t = 0; t < part.taken.size(); ++t) {
      if (!part.taken[t]) continue;
      const auto [a, b, c] = corners_of(source_.meshes[part.mesh], t);
      by_area.emplace_back(-(b - a).cross(c - a).norm(), t);
    }
    std::ranges::sort(by_area);
    Vector3d first = Vector3d::Zero();
    for (std::size_t i = 0; i < std::min(by_area.size(), kMostTries); ++i) {
      const auto [a, b, c] = corners_of(source_.meshes[part.mesh], by_area[i].second);
      const Vector3d place = ((a + b + c) / 3 * kDigits).array().round() / kDigits;
      if (nearest(place) == p) return place;
      if (i == 0) first = place;
    }
    return first;
  }

 private:
  const SourceModel& source_;
  const HairCandidates& parts_;
  std::vector<Eigen::AlignedBox3d> boxes_;
};

/// ["Hair", "Tail"]; names may have bytes that are no UTF-8.
std::string list_text(const std::vector<std::string>& names) {
  std::vector<std::string> quoted;
  for (const std::string& name : names)
    quoted.push_back(nlohmann::json(name).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  return fmt::format("[{}]", fmt::join(quoted, ", "));
}

bool is_whole(const HairChoice& choice, const SourceModel& source, std::size_t m) {
  return std::size_t(std::ranges::count(choice.taken[m], true)) == source.meshes[m].triangles.size() / 3;
}

/// What takes it by names alone; empty where they would take something else.
std::string line_of_names(const SourceModel& source, const HairChoice& choice) {
  std::vector<std::string> meshes, materials;
  const auto add = [](std::vector<std::string>& list, const std::string& name) {
    if (std::ranges::find(list, name) == list.end()) list.push_back(name);
  };
  for (std::size_t m = 0; m < source.meshes.size(); ++m) {
    if (choice.taken[m].empty()) continue;
    if (!is_whole(choice, source, m) || source.meshes[m].name.empty()) return "";
    add(meshes, source.meshes[m].name);
    add(materials, importer::material_name(source, source.meshes[m]));
  }
  bool meshes_alone = true, both = true;
  for (std::size_t m = 0; m < source.meshes.size(); ++m) {
    const SourceMesh& mesh = source.meshes[m];
    if (!choice.taken[m].empty() || std::ranges::find(meshes, mesh.name) == meshes.end()) continue;
    meshes_alone = false;
    if (std::ranges::find(materials, importer::material_name(source, mesh)) != materials.end()) both = false;
  }
  if (meshes_alone) return fmt::format("\"hair\": {{\"meshes\": {}}}", list_text(meshes));
  if (!both) return "";
  return fmt::format("\"hair\": {{\"meshes\": {}, \"materials\": {}}}", list_text(meshes), list_text(materials));
}

}  // namespace

tl::expected<std::vector<std::size_t>, ToolError> parts_at(const SourceModel& source, const HairCandidates& candidates,
                                                           std::span<const std::array<double, 3>> points) {
  const PartFinder finder(source, candidates);
  std::vector<std::size_t> found;
  for (const std::array<double, 3>& point : points) {
    const std::size_t part = finder.nearest(Vector3d(point.data()));
    if (part == candidates.list.size()) {
      return file_failure(
          ToolError::Kind::kBadInput, source.path,
          "recipe key \"hair.parts\": no part that may be hair is within {} m of [{}]; 'coif cook --list "
          "candidates' prints a point of each",
          kReach, fmt::join(point, ", "));
    }
    if (std::ranges::find(found, part) == found.end()) found.push_back(part);
  }
  return found;
}

std::string recipe_line(const SourceModel& source, const HairChoice& choice, const HairCandidates& candidates) {
  if (std::string line = line_of_names(source, choice); !line.empty()) return line;
  const PartFinder finder(source, candidates);
  std::vector<std::string> points;
  for (std::size_t p = 0; p < candidates.list.size(); ++p) {
    if (candidates.list[p].share_of(choice) < 0.5) continue;
    const Vector3d place = finder.place_on(p);
    points.push_back(fmt::format("[{:.4f}, {:.4f}, {:.4f}]", place.x(), place.y(), place.z()));
  }
  return fmt::format("\"hair\": {{\"parts\": [{}]}}", fmt::join(points, ", "));
}

std::string recipe_line(const SourceModel& source, const HairCandidate& candidate, const HairCandidates& candidates) {
  HairChoice choice;
  choice.taken.resize(source.meshes.size());
  choice.taken[candidate.mesh] = candidate.taken;
  return recipe_line(source, choice, candidates);
}

}  // namespace coif::cook
