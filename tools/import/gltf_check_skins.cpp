#include "import/gltf_check_parts.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

// Joints and weights.

namespace coif::importer {
namespace {

using nlohmann::json;

constexpr double kSumRounding =
    5e-4;  ///< A weight's share of a vertex that nobody sees; a byte's step is 8 times that.
constexpr double kZeroRounding = 1e-6;  ///< What subtraction leaves of 0 in some programs.
constexpr const char* kNormalizeWeights = "normalize the weights (Blender: Weights > Normalize All) and export again";

/// How many vertices have a fault, and the first one.
struct VertexTally {
  std::size_t count = 0, first = 0;
  double number = 0;

  void add(std::size_t vertex, double value) {
    if (count++ == 0) first = vertex, number = value;
  }
};

class SkinChecks {
 public:
  explicit SkinChecks(CheckedGltf& file) : file_(file) {}

  void run() {
    check_skins();
    const json& meshes = file_.list("meshes");
    const std::vector<std::optional<std::size_t>> fewest = fewest_joints();
    for (std::size_t m = 0; m < meshes.size(); ++m) {
      joints_ = fewest[m];
      const json& primitives = list_of(member(meshes[m], "primitives"));
      for (std::size_t p = 0; p < primitives.size(); ++p) {
        place_ =
            gltf_part_name("mesh", meshes[m], m) + (primitives.size() == 1 ? "" : fmt::format(", primitive {}", p));
        if (!member(member(primitives[p], "extensions"), "KHR_draco_mesh_compression").is_object())
          check_sets(member(primitives[p], "attributes"));
      }
    }
  }

 private:
  template <class... Args>
  void wrong(const char* code, fmt::format_string<Args...> text, Args&&... args) {
    file_.faults.add(code, "{}: {}", place_, fmt::format(text, std::forward<Args>(args)...));
  }

  /// Per mesh, the joints of the smallest skin that some node gives it; none: no skin.
  [[nodiscard]] std::vector<std::optional<std::size_t>> fewest_joints() const {
    std::vector<std::optional<std::size_t>> fewest(file_.list("meshes").size());
    for (const json& node : file_.list("nodes")) {
      const auto mesh = index_of(member(node, "mesh"), fewest.size());
      const auto skin = index_of(member(node, "skin"), file_.list("skins").size());
      if (!mesh || !skin) continue;
      const std::size_t joints = list_of(member(file_.list("skins")[*skin], "joints")).size();
      fewest[*mesh] = std::min(fewest[*mesh].value_or(joints), joints);
    }
    return fewest;
  }

  void check_skins() {
    const json& skins = file_.list("skins");
    for (std::size_t s = 0; s < skins.size(); ++s) {
      place_ = gltf_part_name("skin", skins[s], s);
      const json& joints = list_of(member(skins[s], "joints"));
      std::set<std::uint32_t> nodes;
      for (const json& joint : joints) nodes.insert(index_of(joint, kNoIndex).value_or(std::uint32_t(nodes.size())));
      if (nodes.size() < joints.size()) wrong(gltf_code::kRules, "a node is twice among its joints; export it again");
      const auto binds = file_.read(member(skins[s], "inverseBindMatrices"));
      if (!binds) continue;
      if (binds->width != 16 || !binds->is_float()) {
        wrong(gltf_code::kRules, "its bind matrices are no matrices of floats; export it again");
        continue;
      }
      if (binds->count() < joints.size())
        wrong(gltf_code::kRules, "it has {} bind matrices for {} joints; export it again", binds->count(),
              joints.size());
      for (std::size_t b = 0; b < binds->count(); ++b) {
        const double* row = &binds->numbers[16 * b];
        if (row[3] == 0 && row[7] == 0 && row[11] == 0 && row[15] == 1) continue;
        wrong(gltf_code::kRules, "bind matrix {} is no place: its last row is not 0, 0, 0, 1; export it again", b);
        break;
      }
    }
  }

  void check_sets(const json& attributes) {
    std::vector<StoredNumbers> joints, weights;
    for (std::size_t set = 0; set < 8; ++set) {
      const json& j = member(attributes, fmt::format("JOINTS_{}", set).c_str());
      const json& w = member(attributes, fmt::format("WEIGHTS_{}", set).c_str());
      if (j.is_null() != w.is_null())
        return wrong(gltf_code::kRules, "its {} of joints has no weights, or the other way round; export it again",
                     set);
      if (j.is_null()) break;
      auto js = file_.read(j), ws = file_.read(w);
      if (!js || !ws || js->width != 4 || ws->width != 4 || js->count() != ws->count()) return;
      joints.push_back(std::move(*js));
      weights.push_back(std::move(*ws));
    }
    for (std::size_t set = 1; set < joints.size(); ++set) {
      if (joints[set].count() != joints[0].count()) return;
    }
    if (!joints.empty()) check_vertices(joints, weights);
  }

  void check_vertices(const std::vector<StoredNumbers>& joints, const std::vector<StoredNumbers>& weights) {
    VertexTally outside, twice, negative, sums;
    std::vector<double> held;
    for (std::size_t v = 0; v < joints[0].count(); ++v) {
      held.clear();
      double sum = 0;
      bool is_twice = false;
      for (std::size_t i = 0; i < 4 * joints.size(); ++i) {
        const double joint = joints[i / 4].numbers[4 * v + i % 4], weight = weights[i / 4].value(4 * v + i % 4);
        if (joints_ && joint >= double(*joints_)) outside.add(v, joint);
        if (weight < -kZeroRounding) negative.add(v, weight);
        sum += weight;
        if (!(weight > kZeroRounding)) continue;
        if (std::ranges::find(held, joint) != held.end() && !std::exchange(is_twice, true)) twice.add(v, joint);
        held.push_back(joint);
      }
      if (!(std::abs(sum - 1) <= kSumRounding)) sums.add(v, sum);
    }
    if (outside.count > 0)
      wrong(gltf_code::kJoints,
            "{} joints of vertices are not of its skin (vertex {} has {:.0f}, the skin {} joints); export mesh and "
            "armature together again",
            outside.count, outside.first, outside.number, joints_.value_or(0));
    if (twice.count > 0)
      wrong(gltf_code::kJoints,
            "a joint holds {} vertices twice (vertex {} joint {:.0f}); their weights are added: clean the weights "
            "(Blender: Weights > Clean) and export again",
            twice.count, twice.first, twice.number);
    if (negative.count > 0)
      wrong(gltf_code::kWeights, "{} weights are below 0 (at vertex {} {:g}); {}", negative.count, negative.first,
            negative.number, kNormalizeWeights);
    if (sums.count > 0)
      wrong(gltf_code::kWeights, "the weights of {} vertices do not add up to 1 (of vertex {} to {:.4g}); {}",
            sums.count, sums.first, sums.number, kNormalizeWeights);
  }

  CheckedGltf& file_;
  std::string place_;
  std::optional<std::size_t> joints_;
};

}  // namespace

void check_gltf_skins(CheckedGltf& file) { SkinChecks(file).run(); }

}  // namespace coif::importer
