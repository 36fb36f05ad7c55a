#include "cook/cuts/cut_hair.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>

namespace coif::cook {
namespace {

using Eigen::Vector3f;

constexpr float kLeastShare = 0.1f;   ///< Share of an edge: a cut nearer to a corner goes through the corner.
constexpr std::size_t kPartners = 6;  ///< Number of a triangle's worst partners whose planes are tried.

/// A cut through an edge of a triangle.
struct EdgeCut {
  std::uint32_t from, to;  ///< Vertices.
  float share;
};

/// A line across a triangle: through two edges, or through a corner and an edge.
struct Cut {
  std::array<EdgeCut, 2> edges;
  std::size_t edge_count = 0;
  Vector3f start, end;    ///< The line's ends, metres.
  std::size_t added = 0;  ///< Triangles.
  double gain = 0;        ///< Weight put right.

  [[nodiscard]] double per_triangle() const { return gain / double(added); }
};

class Cutting {
 public:
  Cutting(const SeenCrossings& crossings, const CutSettings& settings, SplitMesh& mesh)
      : settings_(settings), mesh_(mesh), samples_(crossings.samples), of_triangle_(mesh.triangles().size()) {
    for (std::uint32_t s = 0; s < samples_.size(); ++s) {
      of_triangle_[samples_[s].near].push_back(s);
      of_triangle_[samples_[s].far].push_back(s);
    }
  }

  /// Lazy evaluation (Minoux 1978, "Accelerated greedy algorithms for maximizing submodular set functions"): gains only
  /// fall as other triangles are cut, so a gain that is still the largest after it was computed again is the largest of
  /// all.
  CutResult run() {
    for (std::uint32_t t = 0; t < of_triangle_.size(); ++t) offer(t);
    while (!offers_.empty()) {
      const Offer offer_made = offers_.top();
      offers_.pop();
      const std::optional<Cut> cut = best_cut(offer_made.triangle);
      if (!cut || cut->per_triangle() < settings_.least_gain) continue;
      if (!offers_.empty() && cut->per_triangle() < offers_.top().value) {
        offers_.push({cut->per_triangle(), offer_made.triangle});
        continue;
      }
      if (result_.added + cut->added > settings_.most_added) continue;
      make(*cut, offer_made.triangle);
    }
    return result_;
  }

 private:
  struct Offer {
    double value;
    std::uint32_t triangle;
    bool operator<(const Offer& other) const {
      return std::tuple(value, other.triangle) < std::tuple(other.value, triangle);
    }
  };

  /// One of a triangle's samples, from the triangle's side.
  struct Opinion {
    std::uint64_t partner_in_view;
    std::uint32_t partner;
    bool is_near;
    float weight;
    Vector3f point;
  };

  void offer(std::uint32_t triangle) {
    if (of_triangle_[triangle].empty()) return;
    if (const auto cut = best_cut(triangle)) offers_.push({cut->per_triangle(), triangle});
  }

  /// Sorted, so that the samples of one partner in one view follow each other.
  [[nodiscard]] std::vector<Opinion> opinions_of(std::uint32_t triangle) const {
    std::vector<Opinion> opinions;
    opinions.reserve(of_triangle_[triangle].size());
    for (const std::uint32_t s : of_triangle_[triangle]) {
      const CrossingSample& sample = samples_[s];
      const bool is_near = sample.near == triangle;
      const std::uint32_t partner = is_near ? sample.far : sample.near;
      opinions.push_back({std::uint64_t(sample.view) << 32 | partner, partner, is_near, sample.weight,
                          is_near ? sample.near_point : sample.far_point});
    }
    std::ranges::stable_sort(opinions, {}, &Opinion::partner_in_view);
    return opinions;
  }

  /// Calls `each` with the samples of each partner in each view.
  static void for_groups(std::span<const Opinion> opinions, auto&& each) {
    for (std::size_t begin = 0, end = 0; begin < opinions.size(); begin = end) {
      while (end < opinions.size() && opinions[end].partner_in_view == opinions[begin].partner_in_view) ++end;
      each(opinions.subspan(begin, end - begin));
    }
  }

  static double unavoidable(std::span<const Opinion> group) {
    double near = 0, far = 0;
    for (const Opinion& opinion : group) (opinion.is_near ? near : far) += double(opinion.weight);
    return std::min(near, far);
  }

  [[nodiscard]] static std::vector<std::uint32_t> worst_partners(std::span<const Opinion> opinions) {
    std::vector<std::pair<std::uint32_t, double>> of_views;
    for_groups(opinions, [&](std::span<const Opinion> group) {
      const double loss = unavoidable(group);
      if (loss > 0) of_views.emplace_back(group.front().partner, loss);
    });
    std::ranges::stable_sort(of_views, {}, &std::pair<std::uint32_t, double>::first);
    std::vector<std::pair<double, std::uint32_t>> partners;
    for (const auto& [partner, loss] : of_views) {
      if (partners.empty() || partners.back().second != partner) partners.emplace_back(0, partner);
      partners.back().first -= loss;
    }
    std::ranges::sort(partners);
    std::vector<std::uint32_t> worst;
    for (std::size_t i = 0; i < std::min(kPartners, partners.size()); ++i) worst.push_back(partners[i].second);
    return worst;
  }

  [[nodiscard]] std::array<Vector3f, 3> corners_of(std::uint32_t triangle) const {
    const auto& v = mesh_.triangles()[triangle].vertex;
    return {mesh_.position(v[0]), mesh_.position(v[1]), mesh_.position(v[2])};
  }

  [[nodiscard]] std::optional<Cut> best_cut(std::uint32_t triangle) const {
    const std::vector<Opinion> opinions = opinions_of(triangle);
    std::optional<Cut> best;
    for (const std::uint32_t partner : worst_partners(opinions)) {
      for (Cut& cut : cuts_by(partner, triangle)) {
        judge(opinions, triangle, cut);
        if (cut.gain > 0 && (!best || cut.per_triangle() > best->per_triangle())) best = cut;
      }
    }
    return best;
  }

  /// Cuts along the plane of another triangle, and from the corners beside it to where the plane meets edges.
  [[nodiscard]] std::vector<Cut> cuts_by(std::uint32_t partner, std::uint32_t triangle) const {
    const std::array<Vector3f, 3> plane = corners_of(partner), corner = corners_of(triangle);
    const Vector3f normal = (plane[1] - plane[0]).cross(plane[2] - plane[0]).normalized();
    const auto& vertex = mesh_.triangles()[triangle].vertex;
    std::vector<Cut> cuts;
    Cut whole;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      const float from = normal.dot(corner[k] - plane[0]), to = normal.dot(corner[next] - plane[0]);
      if (!(from * to < 0)) continue;
      const float share = from / (from - to);
      const float length = (corner[next] - corner[k]).norm();
      if (share < kLeastShare || share > 1 - kLeastShare ||
          length * std::min(share, 1 - share) < settings_.shortest_edge)
        continue;
      Cut single;
      single.edges[0] = {vertex[k], vertex[next], share};
      single.edge_count = 1;
      single.start = corner[k] + share * (corner[next] - corner[k]);
      single.end = corner[(k + 2) % 3];
      single.added = mesh_.count_at(vertex[k], vertex[next]);
      (whole.edge_count == 0 ? whole.start : whole.end) = single.start;
      whole.edges[whole.edge_count++] = single.edges[0];
      whole.added += single.added;
      cuts.push_back(single);
    }
    if (whole.edge_count == 2) cuts.push_back(whole);
    return cuts;
  }

  /// Tests on which side of a line across a triangle a point is: true on the left.
  static auto left_of(const Vector3f& start, const Vector3f& end, const Vector3f& normal) {
    return [across = Vector3f(normal.cross(end - start)), start](const Vector3f& point) {
      return across.dot(point - start) > 0;
    };
  }

  [[nodiscard]] Vector3f normal_of(std::uint32_t triangle) const {
    const auto corner = corners_of(triangle);
    return (corner[1] - corner[0]).cross(corner[2] - corner[0]);
  }

  void judge(std::span<const Opinion> opinions, std::uint32_t triangle, Cut& cut) const {
    const auto is_left = left_of(cut.start, cut.end, normal_of(triangle));
    for_groups(opinions, [&](std::span<const Opinion> group) {
      double weight[2][2] = {};
      for (const Opinion& opinion : group) weight[is_left(opinion.point)][opinion.is_near] += double(opinion.weight);
      const double whole = std::min(weight[0][0] + weight[1][0], weight[0][1] + weight[1][1]);
      cut.gain += whole - std::min(weight[0][0], weight[0][1]) - std::min(weight[1][0], weight[1][1]);
    });
  }

  void make(const Cut& cut, std::uint32_t triangle) {
    ++result_.cuts;
    std::vector<std::uint32_t> pieces{triangle};
    for (std::size_t e = 0; e < cut.edge_count; ++e) {
      const EdgeCut& edge = cut.edges[e];
      for (const SplitMesh::Halves& halves : mesh_.split_edge(edge.from, edge.to, edge.share)) {
        share_out(halves);
        pieces.push_back(halves.kept);
        pieces.push_back(halves.added);
        ++result_.added;
      }
    }
    result_.gained += cut.gain;
    std::ranges::sort(pieces);
    pieces.erase(std::ranges::unique(pieces).begin(), pieces.end());
    for (const std::uint32_t piece : pieces) offer(piece);
  }

  /// Gives the samples of a triangle that was split to its halves.
  void share_out(const SplitMesh::Halves& halves) {
    of_triangle_.resize(mesh_.triangles().size());
    const auto is_left = left_of(mesh_.position(halves.tip), mesh_.position(halves.middle), normal_of(halves.added));
    const std::vector<std::uint32_t> samples = std::move(of_triangle_[halves.kept]);
    of_triangle_[halves.kept].clear();
    for (const std::uint32_t s : samples) {
      CrossingSample& sample = samples_[s];
      const bool is_near = sample.near == halves.kept;
      const Vector3f& point = is_near ? sample.near_point : sample.far_point;
      const std::uint32_t half = is_left(point) ? halves.added : halves.kept;
      (is_near ? sample.near : sample.far) = half;
      of_triangle_[half].push_back(s);
    }
  }

  const CutSettings& settings_;
  SplitMesh& mesh_;
  std::vector<CrossingSample> samples_;
  std::vector<std::vector<std::uint32_t>> of_triangle_;  ///< Samples.
  std::priority_queue<Offer> offers_;
  CutResult result_;
};

}  // namespace

CutResult cut_crossings(const SeenCrossings& crossings, const CutSettings& settings, SplitMesh& mesh) {
  return Cutting(crossings, settings, mesh).run();
}

}  // namespace coif::cook
