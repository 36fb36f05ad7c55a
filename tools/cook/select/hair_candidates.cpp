#include "cook/select/hair_candidates.h"

#include "cook/select/crown_view.h"
#include "cook/select/hair_evidence.h"

#include <algorithm>
#include <functional>
#include <map>

namespace coif::cook {
namespace {

using Eigen::Vector3d, Eigen::Vector3f;
using importer::SourceMesh, importer::SourceModel;

constexpr double kOnlyOnHead = 0.8;    ///< Share of the weight of a piece out of a mesh with more than the head.
constexpr double kMostlyOnHead = 0.5;  ///< The same of a whole mesh: long hair hangs to the shoulders.
constexpr double kNoCrown = 0.005;     ///< Share of the crown that a brow may seem to cover.
constexpr double kShowsFace = 0.45;    ///< Share of the middle of the face: a mesh with more is more than hair.
constexpr float kOneColor = 0.14f;     ///< Distance of colours, 0..1.7, of what belongs together.
constexpr double kMostColors = 8;      ///< An unwrapped skin has many islands, a palette few colours.
constexpr double kOtherCell = 0.4;     ///< How far colours of one palette are taken to be apart.
constexpr std::size_t kMostIslands = 2000;
constexpr double kSmallPiece = 0.02;  ///< Share of the crown or the face that a piece of an own covers at least.

class CandidateFinder {
 public:
  CandidateFinder(const SourceModel& source, const SurfaceIslands& surface, const std::optional<HeadView>& view)
      : source_(source), view_(view), islands_(surface.list), islands_of_(surface.of_mesh), first_(surface.first) {}

  HairCandidates find() && {
    has_cells_.assign(source_.meshes.size(), false);
    look_from_head();
    HairCandidates all;
    all.sees_head = view_.has_value();
    for (std::uint32_t m = 0; m < source_.meshes.size(); ++m) add_candidates(m, all.list);
    for (HairCandidate& candidate : all.list)
      candidate.probability = probability_of_hair(candidate.features, all.sees_head);
    std::ranges::stable_sort(all.list, std::greater<>(), &HairCandidate::probability);
    return all;
  }

 private:
  void look_from_head() {
    coverage_.resize(islands_.size());
    if (!view_) return;
    Outermost outermost;
    for (std::uint32_t m = 0; m < source_.meshes.size(); ++m) {
      const SourceMesh& mesh = source_.meshes[m];
      for (std::size_t t = 0; t < islands_of_[m].piece_of.size(); ++t) {
        const std::uint32_t island = first_[m] + islands_of_[m].piece_of[t];
        if (islands_[island].evidence.head_share < kOnHead) continue;
        const auto corner = [&](std::size_t k) { return view_->in_axes(mesh.positions[mesh.triangles[3 * t + k]]); };
        outermost.add(corner(0), corner(1), corner(2), island);
      }
    }
    coverage_ = outermost.shares(islands_.size());
    double most = 0.05;
    for (std::uint32_t i = 0; i < islands_.size(); ++i) {
      if (coverage_[i].middle_of_face <= most) continue;
      most = coverage_[i].middle_of_face;
      face_ = i;
    }
  }

  [[nodiscard]] std::vector<std::uint32_t> islands_on_head(std::uint32_t m, double least) const {
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < islands_of_[m].count; ++i)
      if (!view_ || islands_[first_[m] + i].evidence.head_share >= least) found.push_back(first_[m] + i);
    return found;
  }

  [[nodiscard]] double share_on_head(std::uint32_t m) const {
    if (!view_) return 1;
    double on_head = 0, all = 0;
    for (std::uint32_t i = first_[m]; i < first_[m] + islands_of_[m].count; ++i) {
      on_head += double(islands_[i].evidence.triangles) * islands_[i].evidence.head_share;
      all += double(islands_[i].evidence.triangles);
    }
    return all > 0 ? on_head / all : 0;
  }

  /// A brow or a beard, by its place: wholly before the head, and not up to the crown.
  [[nodiscard]] bool lies_on_face(const std::vector<std::uint32_t>& islands) const {
    double crown = 0;
    Eigen::AlignedBox3d box;
    for (const std::uint32_t i : islands) {
      crown += coverage_[i].crown;
      box.extend(view_->in_axes(islands_[i].box.min().cast<float>()));
      box.extend(view_->in_axes(islands_[i].box.max().cast<float>()));
    }
    return crown < kNoCrown && box.center().z() > 0.5 && box.max().y() < 0.35;
  }

  /// Without the pieces that are a brow or a beard of hair's colour, which are parts of their own.
  void add_off_face(std::uint32_t m, const std::vector<std::uint32_t>& group, std::vector<HairCandidate>& list) {
    std::map<std::uint32_t, std::vector<std::uint32_t>> pieces;
    for (const std::uint32_t i : group) pieces[islands_[i].piece].push_back(i);
    std::vector<std::uint32_t> off, on;
    for (const auto& [piece, islands] : pieces) {
      std::vector<std::uint32_t>& side = lies_on_face(islands) ? on : off;
      side.insert(side.end(), islands.begin(), islands.end());
    }
    if (!off.empty()) list.push_back(made_of(m, off));
    if (!on.empty()) list.push_back(made_of(m, on));
  }

  /// A mesh that leaves the face free is one part; another one is its colours, else its pieces.
  void add_candidates(std::uint32_t m, std::vector<HairCandidate>& list) {
    const std::vector<std::uint32_t> on_head = islands_on_head(m, kOnHead);
    double middle = 0;
    for (const std::uint32_t i : on_head) middle += coverage_[i].middle_of_face;
    if (on_head.empty()) return;
    if (share_on_head(m) >= kMostlyOnHead && middle < kShowsFace) {
      list.push_back(made_of(m, islands_on_head(m, 0)));
      return;
    }
    std::vector<std::vector<std::uint32_t>> groups = by_color(islands_on_head(m, kOnlyOnHead));
    has_cells_[m] = !groups.empty();
    if (groups.empty()) groups = by_piece(islands_on_head(m, kOnlyOnHead));
    for (const std::vector<std::uint32_t>& group : groups) add_off_face(m, group, list);
  }

  /// The same colour, or cells of the texture that overlap, as where small cells of a palette colour everything.
  [[nodiscard]] bool look_alike(const SurfaceIsland& a, const SurfaceIsland& b) const {
    if (a.has_color != b.has_color) return false;
    return a.has_color ? (a.color - b.color).norm() < kOneColor : a.cell.intersects(b.cell);
  }

  static std::vector<std::vector<std::uint32_t>> values_of(
      const std::map<std::uint32_t, std::vector<std::uint32_t>>& groups) {
    std::vector<std::vector<std::uint32_t>> values;
    for (const auto& [key, value] : groups) values.push_back(value);
    return values;
  }

  /// Groups of islands that look alike; none where that does not tell parts apart.
  [[nodiscard]] std::vector<std::vector<std::uint32_t>> by_color(const std::vector<std::uint32_t>& islands) const {
    DisjointSets sets(islands.size());
    for (std::uint32_t a = 0; a < islands.size() && islands.size() <= kMostIslands; ++a)
      for (std::uint32_t b = 0; b < a; ++b)
        if (look_alike(islands_[islands[a]], islands_[islands[b]])) sets.unite(a, b);
    std::map<std::uint32_t, std::vector<std::uint32_t>> groups;
    for (std::uint32_t a = 0; a < islands.size(); ++a) groups[sets.find(a)].push_back(islands[a]);
    if (groups.size() < 2 || double(groups.size()) > kMostColors) return {};
    return values_of(groups);
  }

  /// Connected pieces that cover something of the head.
  [[nodiscard]] std::vector<std::vector<std::uint32_t>> by_piece(const std::vector<std::uint32_t>& islands) const {
    std::map<std::uint32_t, std::vector<std::uint32_t>> pieces;
    for (const std::uint32_t i : islands) pieces[islands_[i].piece].push_back(i);
    std::erase_if(pieces, [&](const auto& piece) {
      double covered = 0;
      bool is_moved = false;
      for (const std::uint32_t i : piece.second) {
        covered += coverage_[i].crown + coverage_[i].face;
        is_moved = is_moved || islands_[i].evidence.hair_bone_share > kMovedByHairBones;
      }
      return covered < kSmallPiece && !is_moved;
    });
    return values_of(pieces);
  }

  /// How far a part's colour is from that of the face; -1 where that is not known.
  [[nodiscard]] double apart_from_face(std::uint32_t m, const std::vector<std::uint32_t>& islands,
                                       const std::optional<Vector3f>& color) const {
    const SurfaceIsland& face = islands_[face_];
    if (std::ranges::find(islands, face_) != islands.end()) return 0;
    if (color && face.has_color) return double((*color - face.color).norm());
    const bool is_of_palette = has_cells_[m] && source_.meshes[m].material == source_.meshes[face.mesh].material;
    return is_of_palette ? kOtherCell : -1;
  }

  HairCandidate made_of(std::uint32_t m, const std::vector<std::uint32_t>& islands) {
    const SourceMesh& mesh = source_.meshes[m];
    HairCandidate part;
    part.mesh = m;
    part.is_whole_mesh = islands.size() == islands_of_[m].count;
    std::vector<bool> is_in(islands_of_[m].count, false);
    for (const std::uint32_t i : islands) is_in[i - first_[m]] = true;
    for (const std::uint32_t island : islands_of_[m].piece_of) part.taken.push_back(is_in[island]);
    part.triangles = std::size_t(std::ranges::count(part.taken, true));
    const auto set = [&](Feature feature, double value) { part.features[std::size_t(feature)] = value; };
    const HairNames names = names_of(source_, mesh);
    set(Feature::kCalledHair, !names.why_hair.empty() ? 1 : 0);
    set(Feature::kCalledOther, names.say_otherwise ? 1 : 0);
    set(Feature::kTransparent, is_transparent(source_, mesh) ? 1 : 0);
    set(Feature::kOnlyPieces, !part.is_whole_mesh && !has_cells_[m] ? 1 : 0);
    for (std::uint32_t i = first_[m]; i < first_[m] + islands_of_[m].count; ++i)
      if (islands_[i].evidence.is_moved_as_hair()) set(Feature::kBesideMoved, 1);
    double area = 0, hair = 0, most = 0, eyes = 0, on_head = 0;
    Coverage covered;
    Eigen::AlignedBox3d box;
    Vector3f color = Vector3f::Zero();
    bool has_color = true;
    for (const std::uint32_t i : islands) {
      const SurfaceIsland& island = islands_[i];
      const double corners = double(island.evidence.triangles);
      area += island.area;
      hair += corners * island.evidence.hair_bone_share;
      most = std::max(most, island.evidence.largest_hair_bone);
      eyes += corners * island.evidence.eye_bone_share;
      on_head += corners * island.evidence.head_share;
      covered.crown += coverage_[i].crown;
      covered.face += coverage_[i].face;
      covered.middle_of_face += coverage_[i].middle_of_face;
      box.extend(island.box);
      has_color = has_color && island.has_color;
      color += float(island.area) * island.color;
    }
    const double count = std::max<double>(1, double(part.triangles));
    set(Feature::kHairBones, hair / count >= kMovedByHairBones && most >= kSurelyMoved ? 1 : 0);
    set(Feature::kEyeBones, eyes / count);
    set(Feature::kHeadShare, on_head / count);
    set(Feature::kCrown, covered.crown);
    set(Feature::kFace, covered.face);
    set(Feature::kMiddle, covered.middle_of_face);
    if (has_color && area > 0) part.color = color / float(area);
    if (face_ != importer::kNoIndex) {
      const double apart = apart_from_face(m, islands, part.color);
      set(Feature::kUnlikeFace, std::clamp(apart, 0.0, 1.0));
      set(Feature::kLikeFace, apart >= 0 && apart < 0.5 * double(kOneColor) ? 1 : 0);
    }
    if (view_ && !box.isEmpty()) {
      set(Feature::kHigh, std::clamp((box.center().y() - view_->head.center.y()) / view_->head.radii.y(), -2.0, 2.0));
      set(Feature::kLarge, std::min(2.0, box.diagonal().norm() / (2 * view_->head.radii.norm())));
    }
    return part;
  }

  const SourceModel& source_;
  const std::optional<HeadView>& view_;
  const std::vector<SurfaceIsland>& islands_;
  const std::vector<MeshPieces>& islands_of_;
  const std::vector<std::uint32_t>& first_;
  std::vector<Coverage> coverage_;           ///< Per island.
  std::vector<bool> has_cells_;              ///< Per mesh: colours tell its parts apart.
  std::uint32_t face_ = importer::kNoIndex;  ///< The island that is most of the middle of the face.
};

}  // namespace

HairCandidates find_hair_candidates(const SourceModel& source, double weld_distance) {
  const std::uint32_t head = guess_head_node(source);
  std::optional<HeadView> view = view_of_head(source, head, weld_distance);
  const SurfaceIslands surface = find_surface_islands(source, head, view.has_value(), weld_distance);
  HairCandidates found = CandidateFinder(source, surface, view).find();
  if (!view || view->shows_forwards || found.list.empty()) return found;
  view->forwards = -view->forwards;  // What covers a face may cover the back of a head that looks the other way.
  HairCandidates other = CandidateFinder(source, surface, view).find();
  constexpr double kLead = 0.1;  // Most heads look along +Z.
  return other.list[0].probability > found.list[0].probability + kLead ? other : found;
}

}  // namespace coif::cook
