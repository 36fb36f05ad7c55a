#include "cook/strands/strand_evidence.h"

#include "platform/stop.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace coif::cook {
namespace {

constexpr std::size_t kSamples = 64;  ///< Vertices looked at per patch.
constexpr std::size_t kPerCell = 16;  ///< Samples kept per cell; in denser hair further ones add nothing.
constexpr float kParallel = 0.6f;     ///< Cosine from which two tangents can be compared.

using Cell = std::array<std::int64_t, 3>;

struct Sample {
  std::uint32_t vertex = 0;
  std::uint32_t patch = 0;
};

Cell cell_of(const Eigen::Vector3f& p, double size) {
  Cell cell;
  // Far outside of anything sensible all is one cell, rather than overflow.
  constexpr double kFarthest = 1.0e15;
  for (int k = 0; k < 3; ++k) {
    cell[std::size_t(k)] = std::int64_t(std::clamp(std::floor(double(p[k]) / size), -kFarthest, kFarthest));
  }
  return cell;
}

std::vector<Sample> take_samples(const std::vector<PatchView>& views) {
  std::vector<Sample> samples;
  for (std::uint32_t p = 0; p < views.size(); ++p) {
    const std::size_t count = views[p].vertices.size(), step = std::max<std::size_t>(1, count / kSamples);
    for (std::size_t i = 0; i < count; i += step) samples.push_back({views[p].vertices[i], p});
  }
  return samples;
}

using Grid = std::map<Cell, std::vector<Sample>>;

Grid fill_grid(const HairMesh& mesh, const std::vector<Sample>& samples, double size) {
  Grid grid;
  for (const Sample& sample : samples) {
    auto& cell = grid[cell_of(mesh.positions[sample.vertex], size)];
    if (cell.size() < kPerCell) cell.push_back(sample);
  }
  return grid;
}

template <typename Visit>
void for_each_near(const Grid& grid, const Cell& home, const Visit& visit) {
  for (int n = 0; n < 27; ++n) {
    const auto found = grid.find({home[0] + n % 3 - 1, home[1] + n / 3 % 3 - 1, home[2] + n / 9 - 1});
    if (found == grid.end()) continue;
    for (const Sample& sample : found->second) visit(sample);
  }
}

}  // namespace

namespace {

/// Whose neighbours are sought: a sample itself, or its image in a plane.
struct Image {
  bool is_mirrored = false;
  float middle = 0;

  [[nodiscard]] Eigen::Vector3f place(Eigen::Vector3f p) const {
    if (is_mirrored) p.x() = 2 * middle - p.x();
    return p;
  }
  [[nodiscard]] Eigen::Vector3f direction(Eigen::Vector3f d) const {
    if (is_mirrored) d.x() = -d.x();
    return d;
  }
};

/// What the samples of one patch met.
struct Meetings {
  std::vector<float> sum;  ///< Per patch, of cosines.
  std::vector<std::uint32_t> patches;
  float total = 0;
  std::size_t samples = 0, with_any = 0;

  void add(std::uint32_t patch, float cosine) {
    patches.push_back(patch);
    sum[patch] += cosine;
    total += std::abs(cosine);
  }

  /// A patch of which only a part met anything says less.
  std::vector<Neighbour> take() {
    std::vector<Neighbour> neighbours;
    std::ranges::sort(patches);
    patches.erase(std::ranges::unique(patches).begin(), patches.end());
    const float share = float(with_any) / float(samples);
    for (const std::uint32_t patch : patches) {
      neighbours.push_back({patch, share * sum[patch] / total});
      sum[patch] = 0;
    }
    patches.clear();
    total = 0;
    samples = with_any = 0;
    return neighbours;
  }
};

std::vector<std::vector<Neighbour>> find_beside(const HairMesh& mesh, const std::vector<PatchView>& views,
                                                std::span<const Eigen::Vector3f> tangents, const Image& image,
                                                double reach, const std::stop_token& stop) {
  const std::vector<Sample> samples = take_samples(views);
  const Grid grid = fill_grid(mesh, samples, reach);
  std::vector<std::vector<Neighbour>> neighbours(views.size());
  Meetings met{std::vector<float>(views.size(), 0.0f), {}};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    platform::throw_if_stopped(stop);
    const Sample& sample = samples[i];
    const Eigen::Vector3f at = image.place(mesh.positions[sample.vertex]),
                          tangent = image.direction(tangents[sample.vertex]);
    const std::size_t before = met.patches.size();
    for_each_near(grid, cell_of(at, reach), [&](const Sample& other) {
      if (other.patch == sample.patch || (mesh.positions[other.vertex] - at).norm() > float(reach)) return;
      const float cosine = tangent.dot(tangents[other.vertex]);
      if (std::abs(cosine) >= kParallel) met.add(other.patch, cosine);
    });
    ++met.samples;
    met.with_any += met.patches.size() > before ? 1 : 0;
    if (i + 1 < samples.size() && samples[i + 1].patch == sample.patch) continue;
    neighbours[sample.patch] = met.take();
  }
  return neighbours;
}

}  // namespace

std::vector<std::vector<Neighbour>> find_neighbours(const HairMesh& mesh, const std::vector<PatchView>& views,
                                                    std::span<const Eigen::Vector3f> tangents, double reach,
                                                    const std::stop_token& stop) {
  return find_beside(mesh, views, tangents, {}, reach, stop);
}

std::vector<std::vector<Neighbour>> find_mirror_images(const HairMesh& mesh, const std::vector<PatchView>& views,
                                                       std::span<const Eigen::Vector3f> tangents, float middle,
                                                       double reach, const std::stop_token& stop) {
  return find_beside(mesh, views, tangents, {true, middle}, reach, stop);
}

namespace {

constexpr double kMostHeight = 1.5;  ///< Share of the head's radius: hair that hangs farther adds nothing.
/// Share of the head's radius: side of the cells in which free hair is counted.
constexpr double kOnSkull = 0.7;  ///< How much more height says where nothing else does.
constexpr double kAround = 0.45;
/// Share of the head's radius: hair this far off the head hangs free.
constexpr double kRaised = 0.2;  ///< By the head's radius: hair this far off the head may only be thick,
constexpr double kFree = 0.5;
constexpr double kBesideAxis = 0.7;  ///< Radii from the head's axis: a layer of hair goes around it out there.
constexpr double kTied = 4;          ///< A quarter more of the hair around free: no doubt.
constexpr float kEnd = 0.25f;        ///< Share of the patch at each end that is looked at.

struct End {
  double distance = 0, depth = 0, height = 0;
  double count = 0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(), squares = Eigen::Vector3d::Zero();

  void add(const Eigen::Vector3d& p, const FittedHead& head, double depth_here) {
    distance += head.distance(p);
    depth += depth_here;
    height += p.y();
    sum += p;
    squares += p.cwiseAbs2();
    count += 1;
  }

  void finish() {
    const double n = std::max(count, 1.0);
    distance /= n;
    depth /= n;
    height /= n;
    sum /= n;
    squares /= n;
  }

  /// Root mean square distance from the end's middle.
  [[nodiscard]] double spread() const { return std::sqrt(std::max(0.0, (squares - sum.cwiseAbs2()).sum())); }
};

float depth_of(const HairMesh& mesh, std::uint32_t v, std::span<const float> depth_of_node) {
  float depth = 0;
  for (const importer::SourceInfluence& influence : mesh.influences_of(v)) {
    depth += influence.weight * depth_of_node[influence.node];
  }
  return depth;
}

float limited(double value) { return float(std::clamp(value, -1.0, 1.0)); }

}  // namespace

bool is_shell(const HairMesh& mesh, const PatchView& patch, const FittedHead& head, double beside) {
  constexpr std::size_t kSectors = 12, kFewest = 7;
  constexpr double kTurn = 2 * std::numbers::pi;
  std::array<bool, kSectors> has{};
  for (const std::uint32_t v : patch.vertices) {
    const Eigen::Vector3d from = (mesh.positions[v].cast<double>() - head.center).cwiseQuotient(head.radii);
    if (std::hypot(from.x(), from.z()) < beside) continue;
    const double turn = std::atan2(from.x(), from.z()) / kTurn + 0.5;
    has[std::min(kSectors - 1, std::size_t(turn * double(kSectors)))] = true;
  }
  return std::size_t(std::ranges::count(has, true)) >= kFewest;
}

FreeHair::FreeHair(const HairMesh& mesh, const std::vector<PatchView>& views, const FittedHead& head)
    : head_(head), cell_size_(kAround * head.radii.mean()) {
  std::vector<bool> goes_round;  // a bun on top of the head does not: it is near the axis
  for (const PatchView& view : views) goes_round.push_back(is_shell(mesh, view, head, kBesideAxis));
  for (const Sample& sample : take_samples(views)) {
    if (goes_round[sample.patch]) continue;
    const Eigen::Vector3f& p = mesh.positions[sample.vertex];
    std::vector<Amount>& cell = cells_[cell_of(p, cell_size_)];
    if (cell.empty() || cell.back().patch != sample.patch) cell.push_back({sample.patch});
    Amount& amount = cell.back();
    amount.free += freedom(p.cast<double>());
    amount.all += 1;
  }
}

double FreeHair::freedom(const Eigen::Vector3d& point) const {
  return std::clamp((head_.distance(point) / head_.radii.mean() - kRaised) / (kFree - kRaised), 0.0, 1.0);
}

double FreeHair::beside(std::uint32_t patch, const Eigen::Vector3d& point) const {
  const Cell home = cell_of(point.cast<float>(), cell_size_);
  Amount sum;
  for (int n = 0; n < 27; ++n) {
    const auto found = cells_.find({home[0] + n % 3 - 1, home[1] + n / 3 % 3 - 1, home[2] + n / 9 - 1});
    if (found == cells_.end()) continue;
    for (const Amount& amount : found->second) {
      if (amount.patch == patch) continue;
      sum.free += amount.free;
      sum.all += amount.all;
    }
  }
  return sum.all > 0 ? sum.free / sum.all : freedom(point);
}

RootEvidence weigh_ends(const HairMesh& mesh, const PatchView& patch, std::uint32_t number, const StrandAxis& axis,
                        const SeenStrands& seen, const Surroundings& around) {
  const FittedHead& head = around.head;
  End low, high;
  for (std::size_t i = 0; i < patch.vertices.size(); ++i) {
    const float at = axis.coordinate[i];
    if (at > kEnd && at < 1 - kEnd) continue;
    const std::uint32_t v = patch.vertices[i];
    (at <= kEnd ? low : high)
        .add(mesh.positions[v].cast<double>(), head, double(depth_of(mesh, v, around.depth_of_node)));
  }
  low.finish();
  high.finish();
  const double size = head.radii.mean();
  RootEvidence evidence;
  // Half a radius leaves no doubt. Where both ends lie on the skull the difference depends more on the skull's shape,
  // which is only roughly known, than on the hair.
  const double away = std::clamp(std::max(high.distance, low.distance) / (0.5 * size), 0.0, 1.0);
  evidence.distance = limited(away * (high.distance - low.distance) / (0.5 * size));
  evidence.bones = limited(high.depth - low.depth);
  // There its height is all that the ends say: hair is combed down more often than up.
  const double says = 1 + kOnSkull * (1 - away);
  evidence.height = float(says * std::clamp((low.height - high.height) / size, -kMostHeight, kMostHeight));
  evidence.taper = limited((low.spread() - high.spread()) / std::max(low.spread() + high.spread(), 1.0e-9));
  const double freer = around.free_hair.beside(number, high.sum) - around.free_hair.beside(number, low.sum);
  // Thick hair hides roots that lie off the head: only where an end lies on it is free hair beside it a tail.
  const double on_head = 1 - around.free_hair.freedom(freer > 0 ? high.sum : low.sum);
  evidence.tied = limited(kTied * on_head * freer);
  if (axis.texture_axis >= 0) evidence.fade = seen.fade[std::size_t(axis.texture_axis)];
  return evidence;
}

}  // namespace coif::cook
