#include "cook/strands/strand_evidence.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace coif::cook {
namespace {

constexpr float kWeak = 0.3f;     ///< Belief below which hardly anything spoke.
constexpr float kOwnSays = 0.5f;  ///< Evidence of a patch's own ends from which they say something.
constexpr float kSteep = 0.3f;    ///< Upward part of a unit direction from which it runs up or down.
constexpr double kFewest = 0.05;  ///< Share of the area below the centre from which its direction says something.
constexpr double kWorthSaying = 0.03;

/// Logarithm of the odds without doubts, and how much each share takes from it.
constexpr double kBase = 3.8;
constexpr double kOfUnsure = 3, kOfRises = 6, kOfRisesAbove = 0.5, kOfNeighbour = 4, kOfMirror = 5, kOfEnds = 3;

struct Slopes {
  double up = 0, down = 0;

  void add(float steepness, double area) {
    if (steepness > kSteep) up += area;
    if (steepness < -kSteep) down += area;
  }
  [[nodiscard]] double share_up(double least) const { return up + down > least ? up / (up + down) : 0; }
};

/// How much company contradicts a patch, 0..1.
double against(std::span<const Neighbour> company, std::span<const FoundRoot> found, const FoundRoot& own) {
  float sum = 0;
  for (const Neighbour& other : company) sum += other.agreement * found[other.patch].belief;
  return double(std::clamp(own.belief < 0 ? sum : -sum, 0.0f, 1.0f));
}

}  // namespace

double RootDoubts::probability() const {
  const double odds = kBase - kOfUnsure * unsure - kOfRises * rises - kOfRisesAbove * rises_above -
                      kOfNeighbour * against_neighbour - kOfMirror * against_mirror - kOfEnds * against_ends;
  return probability_of_odds(odds);
}

std::string RootDoubts::reason() const {
  std::array<std::pair<double, std::string>, 6> all{
      {{kOfUnsure * unsure, fmt::format("nothing says where {:.0f} % of the hair has its roots", 100 * unsure)},
       {kOfRises * rises, fmt::format("{:.0f} % of the hair below the head's centre runs upwards", 100 * rises)},
       {kOfRisesAbove * rises_above, fmt::format("{:.0f} % above it does", 100 * rises_above)},
       {kOfNeighbour * against_neighbour,
        fmt::format("{:.0f} % runs against the hair beside it", 100 * against_neighbour)},
       {kOfMirror * against_mirror, fmt::format("{:.0f} % runs against its mirror image", 100 * against_mirror)},
       {kOfEnds * against_ends, fmt::format("the ends of {:.0f} % say the opposite", 100 * against_ends)}}};
  std::ranges::stable_sort(all, std::greater<>{}, &std::pair<double, std::string>::first);
  std::string text;
  for (const auto& [weight, words] : all) {
    if (weight < kWorthSaying * kBase) continue;
    text += (text.empty() ? "" : ", ") + words;
  }
  return text.empty() ? "nothing speaks against them" : text;
}

RootDoubts doubts_of(const HairMesh& mesh, std::span<const PatchView> views, std::span<const FoundRoot> found,
                     const PatchCompany& company, std::span<const Eigen::Vector3f> tangents, const FittedHead& head) {
  RootDoubts doubts;
  Slopes above, below;
  double all = 0;
  for (std::size_t p = 0; p < views.size(); ++p) {
    const FoundRoot& own = found[p];
    if (own.is_told) continue;
    const auto area = double(own.area);
    all += area;
    if (std::abs(own.belief) < kWeak) doubts.unsure += area;
    if (own.evidence * own.belief < 0 && std::abs(own.evidence) > kOwnSays) doubts.against_ends += area;
    doubts.against_neighbour += area * against(company.beside[p], found, own);
    doubts.against_mirror +=
        area * std::max(against(company.mirrored[p], found, own), double(std::max(0.0f, -own.mirrored)));
    for (const std::size_t t : views[p].triangles) {
      float slope = 0, height = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        slope += tangents[mesh.triangles[t + k]].y() / 3;
        height += mesh.positions[mesh.triangles[t + k]].y() / 3;
      }
      (double(height) < head.center.y() ? below : above).add(slope, double(doubled_area(mesh, t)));
    }
  }
  if (!(all > 0)) return doubts;
  for (double* share : {&doubts.unsure, &doubts.against_ends, &doubts.against_neighbour, &doubts.against_mirror}) {
    *share /= all;
  }
  doubts.rises = below.share_up(kFewest * all);
  doubts.rises_above = above.share_up(kFewest * all);
  return doubts;
}

Decision decision_of(const RootDoubts& doubts, std::size_t told, std::size_t sure, std::size_t patches) {
  Decision decision;
  decision.what = "roots";
  const std::string of = told == 0 ? "" : fmt::format("{} of ", patches - told);
  decision.chosen = fmt::format("the ends that fit best, of {}{} {}", of, patches, patches == 1 ? "patch" : "patches");
  decision.reason =
      fmt::format("{}; {} by their own ends, the others by texture and neighbours", doubts.reason(), sure);
  decision.probability = doubts.probability();
  decision.key = "\"strands.root\", or \"root\" of single \"patches\"";
  return decision;
}

}  // namespace coif::cook
