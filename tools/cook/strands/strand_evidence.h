#pragma once

#include "cook/recipe/decision.h"
#include "cook/select/head.h"
#include "cook/strands/hair_strips.h"

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <stop_token>
#include <vector>

namespace coif::cook {

/// How much each sign counts when roots are sought: the one table of these weights. Fitted by tests/corpus/fit_roots.py
/// on made-up styles whose roots are known, and on labelled files of artists; what is not said there was set by hand.
struct RootWeights {
  // Which end of a patch is the root: the weights of RootEvidence.
  float distance = 0.78f;      ///< An end that is half a head's radius nearer to the head.
  float bones = 1.5f;          ///< An end whose bones are one step nearer to the head bone.
  float height = 0.25f;        ///< An end that is one radius higher: hair hangs.
  float shell_height = 0.80f;  ///< The same on a shell around the head, which has its roots on top.
  float taper = 0.23f;         ///< An end that is wider, where the other is a point.
  float tied = 0.88f;          ///< An end without free hair beside it, where the other has a tail beside it.
  float fade = 1.19f;          ///< An end that is opaque, where the other is transparent.

  // What other patches say of it.
  float neighbour = 1.25f;  ///< All that touch it and run parallel.
  float mirror = 0.87f;     ///< All at its mirror image.
  float island = 1.21f;     ///< All that show the same part of the texture.
  float common = 0.35f;     ///< All others in the texture.
  float habit = 0.16f;      ///< Share of the two above where nothing is painted differently at root and tip.

  // Along which axis the strands run.
  float longer = 0.96f;         ///< A texture axis along which the patch is longer.
  float lines = 2.01f;          ///< One along which images have lines.
  float ends = 1.05f;           ///< The signs above, up to three.
  float common_axis = 0.19f;    ///< The one of most patches.
  float unwrapped = 0.28f;      ///< Somebody unwrapped a shell along any of them, rather than down from its top.
  float mirrored_axis = 1.55f;  ///< One that runs alike on both sides of a shell.
};

/// A number that grows along the strands of one patch, from one end to the other; which end is the root is not known
/// yet.
struct StrandAxis {
  int texture_axis = -1;          ///< 0: U, 1: V, -1: by walking over the surface.
  std::vector<float> coordinate;  ///< Per vertex of the view, 0..1.
};

/// Direction of growth of U and V over the triangle at `t`: dp/du and dp/dv, metres per texture; zero without an
/// inverse.
[[nodiscard]] std::array<Eigen::Vector3f, 2> texture_axes(const HairMesh& mesh, std::size_t t);

/// Direction in which a coordinate per vertex grows over the triangle at `t`, per metre; zero without area.
[[nodiscard]] Eigen::Vector3f gradient(const HairMesh& mesh, std::size_t t, std::span<const float> coordinate);

/// How much longer the patch is along V than along U, -1..1; 0 where texture coordinates are of no use: most of the
/// area is in one spot of the texture, as with palettes.
[[nodiscard]] float texture_preference(const HairMesh& mesh, const PatchView& patch);

/// A value of texture_preference(): from a patch twice as long along one texture axis on, strands run along it.
inline constexpr float kLonger = 0.33f;

/// The coordinate along `texture_axis` (0 or 1), or for -1 the distance over the surface from one end of the patch, the
/// one that is farthest from everything else.
[[nodiscard]] StrandAxis strand_axis(const HairStrips& hair, const PatchView& patch, int texture_axis);

/// For hair that is one shell: the distance over the surface from its highest parts.
[[nodiscard]] StrandAxis falling_axis(const HairStrips& hair, const PatchView& patch);

/// How alike the strands of two patches run on both sides of the plane x = `middle`: 1 where all of the first has a
/// mirror image within `reach` metres in the other that runs as its own does, -1 where all run the other way, 0 without
/// images. A patch that goes around the head may be compared with itself.
[[nodiscard]] float mirror_agreement(const HairMesh& mesh, const PatchView& patch, const StrandAxis& axis,
                                     const PatchView& other, const StrandAxis& other_axis, float middle, float reach);

/// For each patch its twin: the one whose vertices are the mirror image of its own in the plane x = `middle`, to
/// `reach` metres. The patch itself if it has no twin, or is its own image. Twins are each other's.
[[nodiscard]] std::vector<std::uint32_t> find_twins(const HairMesh& mesh, const std::vector<PatchView>& views,
                                                    float middle, float reach);

/// The strands of one patch, as images show them.
struct SeenStrands {
  float lines = 0;  ///< -1 where lines run along U .. 1 where they run along V; 0: nothing or neither is seen.
  std::array<float, 2> fade{0, 0};  ///< Along U and V: mean alpha at the low end less that at the high end, -1..1.
  std::array<float, 2> differ{kUnseen,
                              kUnseen};  ///< Along U and V: how far the mean colours of the two ends are apart, 0..1.

  static constexpr float kUnseen = 0.05f;  ///< Without an image; one may exist elsewhere.
};

/// A neighbouring patch, and how its strands run relative to this one's.
struct Neighbour {
  std::uint32_t patch = 0;
  float agreement = 0;  ///< 1: same direction, -1: opposite; sums over a patch's neighbours to at most the
                        ///< share of it that has any: a patch that touches others with its rim only says less.
};

/// For each patch those whose vertices are within `reach` metres of its own and whose tangents are about parallel or
/// opposite there. Looks at a bounded number of vertices per patch: near-linear.
[[nodiscard]] std::vector<std::vector<Neighbour>> find_neighbours(const HairMesh& mesh,
                                                                  const std::vector<PatchView>& views,
                                                                  std::span<const Eigen::Vector3f> tangents,
                                                                  double reach, const std::stop_token& stop);

/// The same with the patches beside each one's image in the plane x = `middle`: styles are about symmetric, and where a
/// lock has a mirror image the two run alike.
[[nodiscard]] std::vector<std::vector<Neighbour>> find_mirror_images(const HairMesh& mesh,
                                                                     const std::vector<PatchView>& views,
                                                                     std::span<const Eigen::Vector3f> tangents,
                                                                     float middle, double reach,
                                                                     const std::stop_token& stop);

/// Whether a patch goes around a good part of the head, seen from above, `beside` radii or more from its axis: then it
/// is a shell of many locks.
[[nodiscard]] bool is_shell(const HairMesh& mesh, const PatchView& patch, const FittedHead& head, double beside = 0);

/// Hair off the head, without layers that go around it. Strands that are combed over the skull to a tail or a bun end
/// beside hair that hangs free; strands that grow from the scalp do not start there.
class FreeHair {
 public:
  FreeHair(const HairMesh& mesh, const std::vector<PatchView>& views, const FittedHead& head);

  /// How free the hair of other patches than `patch` is around a point, 0..1; where there is none, how free
  /// the point is: a tip that hangs alone is no better tied to the head for that.
  [[nodiscard]] double beside(std::uint32_t patch, const Eigen::Vector3d& point) const;
  /// How free a point is: 0 on the head .. 1 half a radius away from it.
  [[nodiscard]] double freedom(const Eigen::Vector3d& point) const;

 private:
  struct Amount {
    std::uint32_t patch = 0;
    double free = 0, all = 0;
  };
  const FittedHead& head_;
  double cell_size_;
  std::map<std::array<std::int64_t, 3>, std::vector<Amount>> cells_;  ///< One amount for each patch in a cell.
};

/// What the two ends of a patch say about which one is the root. Each from -1 (the high end of the coordinate is it) to
/// 1 (the low end), 0 where it says nothing; height up to 4 either way.
struct RootEvidence {
  float distance = 0;  ///< Roots are nearer to the head's surface.
  float bones = 0;     ///< Roots follow bones that are nearer to the head bone.
  float height = 0;    ///< Hair hangs.
  float taper = 0;     ///< Tips are narrower.
  float tied = 0;      ///< An end on the head with free hair beside it is not the root.
  float fade = 0;      ///< Tips are painted thinner.

  bool of_shell = false;  ///< The patch goes around the head.

  /// The patch's own evidence: positive where the low end is the root.
  [[nodiscard]] float sum(const RootWeights& w) const { return of_axis(w) + w.tied * tied; }
  /// The evidence that strands run from end to end. Leaves out `tied`, which may differ from side to side, too.
  [[nodiscard]] float of_axis(const RootWeights& w) const {
    return w.distance * distance + w.bones * bones + (of_shell ? w.shell_height : w.height) * height + w.taper * taper +
           w.fade * fade;
  }
};

/// The data by which the ends are compared.
struct Surroundings {
  const FittedHead& head;
  const FreeHair& free_hair;
  std::span<const float> depth_of_node;  ///< Bones between each node of the source and the head.
  const RootWeights& weights;
};

/// `number`: the patch's among all.
[[nodiscard]] RootEvidence weigh_ends(const HairMesh& mesh, const PatchView& patch, std::uint32_t number,
                                      const StrandAxis& axis, const SeenStrands& seen, const Surroundings& around);

/// What is known of the strands of one patch.
struct PatchStrands {
  float preference = 0;  ///< texture_preference().
  SeenStrands seen;
  float area = 0;
  StrandAxis axis;
  RootEvidence evidence;
  float mirrored = 0;  ///< mirror_agreement() of a shell along its axis.
  Neighbour twin;      ///< Itself, or the patch whose axis was chosen together with its own.
};

/// A patch whose axis is sought.
struct Seeking {
  const PatchView& view;
  std::uint32_t number;   ///< Among all.
  PatchStrands& strands;  ///< Without axis.
};

/// Chooses along what the strands of one patch run, and fills axis and evidence. `common`: the texture axis of most
/// patches.
void choose_axis(const HairStrips& hair, const Seeking& patch, const Surroundings& around, int common);

/// The same for twins: the best pair of axes, if possible two that are mirror images of each other. Fills `twin`, too.
void choose_axes(const HairStrips& hair, const Seeking& one, const Seeking& other, const Surroundings& around,
                 int common);

/// One patch's vote about its root.
struct RootVote {
  int texture_axis = -1;  ///< Along which its strands run; -1: none.
  float evidence = 0;     ///< RootEvidence::sum().
  float area = 0;
  float painted = 1;  ///< Weight of other patches' roots in the texture, 0..1.
};

/// The patches that each one has to do with.
struct PatchCompany {
  std::vector<std::vector<Neighbour>> beside;    ///< find_neighbours()
  std::vector<std::vector<Neighbour>> mirrored;  ///< find_mirror_images()
  std::vector<Neighbour> twins{};                ///< find_twins(), each with mirror_agreement(); empty: not known.
};

/// For each patch the belief that its low end is the root, -1 (the high end) .. 1. Its own evidence counts, and what is
/// believed of the patches beside it, since hair that is combed one way runs one way; of their mirror images, since
/// styles are about symmetric; of those that show the same part of the texture, since one picture of strands has one
/// root; and of all, since one artist paints roots on one side. Twins share all that is known of either.
/// Mean-field iteration on that graph: few rounds carry a belief across a head.
[[nodiscard]] std::vector<float> settle_beliefs(const HairMesh& mesh, const std::vector<PatchView>& views,
                                                std::span<const RootVote> votes, const PatchCompany& company,
                                                const RootWeights& weights, const std::stop_token& stop);

/// What was found of one patch.
struct FoundRoot {
  float area = 0;
  float belief = 0;      ///< That its low end is the root, -1..1.
  float evidence = 0;    ///< RootEvidence::sum().
  float mirrored = 0;    ///< mirror_agreement() of a shell; 0 for other patches.
  bool is_told = false;  ///< By the recipe.
};

/// `tangents`, per vertex, from root to tip.
[[nodiscard]] RootDoubts doubts_of(const HairMesh& mesh, std::span<const PatchView> views,
                                   std::span<const FoundRoot> found, const PatchCompany& company,
                                   std::span<const Eigen::Vector3f> tangents, const FittedHead& head);

/// The decision about the roots of all patches but those that the recipe or the file told; `sure`: how many of them
/// were sure by their own ends.
[[nodiscard]] Decision decision_of(const RootDoubts& doubts, std::size_t told, std::size_t sure, std::size_t patches);

}  // namespace coif::cook
