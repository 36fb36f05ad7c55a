#include "cook/strands/strand_evidence.h"

#include "platform/stop.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace coif::cook {
namespace {

constexpr int kBeliefRounds = 16;
constexpr std::uint32_t kCells = 64;  ///< Cells on each side of the texture.

/// Row or column of a texture that repeats.
std::uint32_t cell_at(float coordinate) {
  const float fraction = coordinate - std::floor(coordinate);
  return std::min(std::uint32_t(fraction * float(kCells)), kCells - 1);
}

/// The patches that show each part of the texture, and the side of it that they take for the roots.
class TextureConsensus {
 public:
  TextureConsensus(const HairMesh& mesh, const std::vector<PatchView>& views, std::span<const RootVote> votes,
                   const RootWeights& weights)
      : votes_(votes), weights_(weights), cells_of_(views.size()) {
    if (mesh.uvs.empty()) return;
    for (auto& sums : cells_) sums.assign(std::size_t(kCells) * kCells, {});
    for (std::size_t p = 0; p < views.size(); ++p) {
      if (votes[p].texture_axis < 0) continue;
      std::vector<std::uint32_t>& cells = cells_of_[p];
      for (const std::size_t t : views[p].triangles) {
        const Eigen::Vector2f middle =
            (mesh.uvs[mesh.triangles[t]] + mesh.uvs[mesh.triangles[t + 1]] + mesh.uvs[mesh.triangles[t + 2]]) / 3;
        cells.push_back(cell_at(middle.y()) * kCells + cell_at(middle.x()));
      }
      std::ranges::sort(cells);
      cells.erase(std::ranges::unique(cells).begin(), cells.end());
    }
  }

  void gather(std::span<const float> belief) {
    common_ = {};
    for (auto& sums : cells_) std::ranges::fill(sums, Sum{});
    for (std::size_t p = 0; p < cells_of_.size(); ++p) {
      if (votes_[p].texture_axis < 0) continue;
      const auto axis = std::size_t(votes_[p].texture_axis);
      common_[axis].add(belief[p], votes_[p].area);
      for (const std::uint32_t cell : cells_of_[p]) cells_[axis][cell].add(belief[p], votes_[p].area);
    }
  }

  /// The evidence of the other patches about this one.
  [[nodiscard]] float about(std::size_t p, float own_belief) const {
    if (votes_[p].texture_axis < 0) return 0;
    const auto axis = std::size_t(votes_[p].texture_axis);
    float island = 0;
    for (const std::uint32_t cell : cells_of_[p]) island += cells_[axis][cell].without(own_belief, votes_[p].area);
    if (!cells_of_[p].empty()) island /= float(cells_of_[p].size());
    return votes_[p].painted *
           (weights_.island * island + weights_.common * common_[axis].without(own_belief, votes_[p].area));
  }

 private:
  struct Sum {
    double belief = 0, area = 0;

    void add(float one, float its_area) {
      belief += double(one) * double(its_area);
      area += double(its_area);
    }
    /// Mean belief of the others; a few small ones beside a large one count less.
    [[nodiscard]] float without(float one, float its_area) const {
      const double others = area - double(its_area);
      return others > 1e-6 * area ? float((belief - double(one) * double(its_area)) / std::max(others, 0.5 * area)) : 0;
    }
  };

  std::span<const RootVote> votes_;
  const RootWeights& weights_;
  std::vector<std::vector<std::uint32_t>> cells_of_;
  std::array<std::vector<Sum>, 2> cells_;  ///< Per axis.
  std::array<Sum, 2> common_{};
};

}  // namespace

std::vector<float> settle_beliefs(const HairMesh& mesh, const std::vector<PatchView>& views,
                                  std::span<const RootVote> votes, const PatchCompany& company,
                                  const RootWeights& weights, const std::stop_token& stop) {
  TextureConsensus texture(mesh, views, votes, weights);
  std::vector<float> belief(votes.size()), odds(votes.size());
  for (std::size_t p = 0; p < votes.size(); ++p) belief[p] = std::tanh(votes[p].evidence);
  for (int round = 0; round < kBeliefRounds; ++round) {
    platform::throw_if_stopped(stop);
    texture.gather(belief);
    for (std::size_t p = 0; p < votes.size(); ++p) {
      float sum = votes[p].evidence + texture.about(p, belief[p]);
      for (const Neighbour& other : company.beside[p]) sum += weights.neighbour * other.agreement * belief[other.patch];
      for (const Neighbour& other : company.mirrored[p]) sum += weights.mirror * other.agreement * belief[other.patch];
      odds[p] = sum;
    }
    for (std::uint32_t p = 0; p < votes.size(); ++p) {
      const Neighbour twin = company.twins.empty() ? Neighbour{p, 1} : company.twins[p];
      belief[p] = std::tanh((odds[p] + twin.agreement * odds[twin.patch]) / (1 + std::abs(twin.agreement)));
    }
  }
  return belief;
}

}  // namespace coif::cook
