#include "cook/rig/body_colliders.h"

#include "base/geometry.h"
#include "base/text.h"
#include "base/words.h"
#include "cook/recipe/rig_recipe.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <map>
#include <set>

namespace coif::cook {
namespace {

using Eigen::Vector3d;
using Done = tl::expected<void, ToolError>;

/// A collider that the body may have, with the bones of the hair that may touch it.
struct BodyCandidate {
  HeadCollider shape;
  std::uint32_t node = 0;
  std::vector<std::uint32_t> bones;  ///< Bones of the hair, ascending.
  std::string words;                 ///< For messages.
  bool of_recipe = false;
};

Vector3d to_vector(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

HeadCollider shape_of_recipe(const RecipeBodyCollider& from, const Vector3d& joint) {
  HeadCollider to;
  to.keeps_inside = from.inside;
  to.center = from.center ? to_vector(*from.center) : joint;
  if (from.normal) {
    to.shape = ColliderShape::kPlane;
    to.axis = to_vector(*from.normal).normalized();
    return to;
  }
  to.radii.setConstant(from.radius.value_or(0));
  if (!from.tail) return to;
  to.axis = to_vector(*from.tail) - to.center;
  const double other = from.tail_radius.value_or(to.radii.x());
  const double length = to.axis.norm();
  if (std::abs(other - to.radii.x()) >= length) {  // One ball contains the other.
    if (other > to.radii.x()) to.center += to.axis;
    to.radii.setConstant(std::max(other, to.radii.x()));
    to.axis.setZero();
    return to;
  }
  to.shape = from.tail_radius ? ColliderShape::kTaperedCapsule : ColliderShape::kCapsule;
  if (from.tail_radius) to.radii = {to.radii.x(), other, 0};
  return to;
}

double smallest_hit_radius(const std::vector<BoneJoint>& joints, const std::vector<std::uint32_t>& bones) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const std::uint32_t b : bones) smallest = std::min(smallest, joints[b].joint->hit_radius);
  return smallest;
}

/// The shape for hair without thickness that keeps off it as hair of this hit radius does.
void grow(HeadCollider& shape, double hit_radius) {
  if (shape.shape == ColliderShape::kPlane) {
    shape.center += hit_radius * shape.axis;
  } else if (!shape.keeps_inside) {
    shape.radii.array() += hit_radius;
  } else if (shape.radii.x() > 2 * hit_radius) {
    shape.radii.array() -= hit_radius;
  }
}

class BodyPass {
 public:
  BodyPass(const importer::SourceModel& source, const HeadBone& head_bone, const Skeleton& skeleton,
           const Colliders& of_head, const RigRecipe& recipe, Findings& findings)
      : source_(source),
        head_node_(head_bone.node),
        skeleton_(skeleton),
        is_thick_(!of_head.hit_radius.empty()),
        recipe_(recipe),
        findings_(findings) {}

  tl::expected<BodyColliders, ToolError> run() && {
    out_.of_bone.assign(skeleton_.bones.size(), 0);
    for (std::size_t i = 0; i < recipe_.body_colliders.size(); ++i) {
      if (Done done = add_recipe(recipe_.body_colliders[i], i); !done) return tl::unexpected(done.error());
    }
    if (recipe_.dynamics_source != DynamicsSource::kCurves) add_springs();
    keep_the_nearest();
    for (const BodyCandidate& candidate : candidates_) keep(candidate);
    tell();
    return std::move(out_);
  }

 private:
  [[nodiscard]] bool is_simulated(std::size_t bone) const { return skeleton_.bones[bone].kind == BoneKind::kSimulated; }

  Done bad(std::size_t entry, const std::string& what) const {
    return tl::unexpected(ToolError{ToolError::Kind::kBadInput,
                                    fmt::format("{}: \"body.colliders\" [{}]: {}", source_.path, entry, what)});
  }

  /// Names to choose from. Bones that carry hair, or have a hair name, are left out: there are hundreds.
  [[nodiscard]] std::string offer(const std::string& name) const {
    std::vector<std::string> names;
    for (std::uint32_t n = 0; n < source_.nodes.size(); ++n) {
      const bool of_head = head_node_ != importer::kNoIndex && is_on_head(source_, head_node_, on_node(n));
      if (!of_head && !source_.nodes[n].name.empty()) names.push_back(source_.nodes[n].name);
    }
    const std::string nearest = nearest_word(name, names);
    if (!nearest.empty()) return fmt::format("did you mean '{}'?", nearest);
    const std::size_t most = std::min<std::size_t>(names.size(), 12);
    return fmt::format("there are {}{}", fmt::join(names.begin(), names.begin() + std::ptrdiff_t(most), ", "),
                       names.size() > most ? ", ..." : "");
  }

  static importer::SourceCollider on_node(std::uint32_t node) {
    importer::SourceCollider collider;
    collider.node = node;
    return collider;
  }

  Done add_recipe(const RecipeBodyCollider& from, std::size_t entry) {
    std::uint32_t node = 0;
    const auto is_it = [&](const importer::SourceNode& n) {
      return std::ranges::equal(n.name, from.bone, {}, to_lower, to_lower);
    };
    while (node < source_.nodes.size() && !is_it(source_.nodes[node])) ++node;
    if (node == source_.nodes.size()) {
      return bad(entry, fmt::format("no bone is called '{}'; {}", excerpt(from.bone), offer(from.bone)));
    }
    if (head_node_ != importer::kNoIndex && is_on_head(source_, head_node_, on_node(node))) {
      return bad(entry, fmt::format("'{}' moves with the head or is hair; the body is what the head does not carry",
                                    from.bone));
    }
    BodyCandidate candidate;
    candidate.node = node;
    candidate.of_recipe = true;
    candidate.shape = shape_of_recipe(from, source_.nodes[node].model_from_node.translation());
    candidate.words = fmt::format("the recipe's body collider {} on '{}'", entry, source_.nodes[node].name);
    for (std::uint32_t b = 0; b < skeleton_.bones.size(); ++b) {
      const bool may = from.hair.empty() || matches_any(skeleton_.bones[b].name, from.hair);
      if (is_simulated(b) && may) candidate.bones.push_back(b);
    }
    if (candidate.bones.empty()) {
      return bad(entry, fmt::format("no bone of the hair that moves is called {}", fmt::join(from.hair, ", ")));
    }
    candidates_.push_back(std::move(candidate));
    return {};
  }

  static char to_lower(char c) { return char(std::tolower(static_cast<unsigned char>(c))); }

  /// Adds the colliders of the hair bones' springs that are not on the head.
  void add_springs() {
    const std::vector<BoneJoint> joints = joints_of_bones(source_, skeleton_);
    std::map<std::uint32_t, std::vector<std::uint32_t>> bones_of;
    for (std::uint32_t b = 0; b < joints.size(); ++b) {
      if (!joints[b]) continue;
      for (const std::uint32_t c : joints[b].spring->colliders) {
        if (!is_on_head(source_, head_node_, source_.colliders[c])) bones_of[c].push_back(b);
      }
    }
    for (auto& [number, bones] : bones_of) {
      const importer::SourceCollider& collider = source_.colliders[number];
      const std::string& name = source_.nodes[collider.node].name;
      BodyCandidate candidate;
      candidate.shape = shape_of(collider);
      if (!is_thick_) grow(candidate.shape, smallest_hit_radius(joints, bones));
      candidate.node = collider.node;
      candidate.bones = std::move(bones);
      candidate.words = fmt::format("the spring bones' collider {} on '{}'", number, name);
      const char* why = nullptr;
      if (!recipe_.body_from_file) why = "\"body.from_file\" is false";
      if (!has_size(collider)) why = "it has no size";
      if (name.empty()) why = "its bone has no name to be found by";
      if (why == nullptr) {
        candidates_.push_back(std::move(candidate));
      } else {
        findings_.leave_out({candidate.words, why, sizeof(ColliderRecord), 0});
      }
    }
  }

  /// Distance of the shape from the range of its hair, with the body at rest; negative within.
  [[nodiscard]] double gap(const BodyCandidate& candidate, const std::vector<BoneReach>& reach) const {
    double least = std::numeric_limits<double>::infinity();
    for (const std::uint32_t b : candidate.bones) {
      const double distance = candidate.shape.keeps_inside ? 0 : distance_at_least(candidate.shape, reach[b].root);
      least = std::min(least, distance - reach[b].length);
    }
    return least;
  }

  void keep_the_nearest() {
    if (candidates_.size() <= kMaxBodyColliders) return;
    const std::vector<BoneReach> reach = reach_of_bones(skeleton_);
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      const double first = -std::numeric_limits<double>::infinity();
      order.emplace_back(candidates_[i].of_recipe ? first : gap(candidates_[i], reach), i);
    }
    std::ranges::sort(order);
    std::set<std::size_t> far;
    for (std::size_t k = kMaxBodyColliders; k < order.size(); ++k) far.insert(order[k].second);
    std::vector<BodyCandidate> kept;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      if (far.count(i) == 0) {
        kept.push_back(std::move(candidates_[i]));
      } else {
        findings_.leave_out(
            {candidates_[i].words,
             fmt::format("an asset has room for {}, and as many are nearer to the hair", kMaxBodyColliders),
             sizeof(ColliderRecord), 0});
      }
    }
    candidates_ = std::move(kept);
  }

  void keep(const BodyCandidate& candidate) {
    const auto [known, is_new] = bone_of_.try_emplace(candidate.node, std::uint32_t(out_.bones.size()));
    if (is_new) {
      const importer::SourceNode& node = source_.nodes[candidate.node];
      out_.bones.push_back({node.name, node.model_from_node.translation(),
                            Eigen::Quaterniond(rotation_part(node.model_from_node)).normalized()});
    }
    for (const std::uint32_t b : candidate.bones) out_.of_bone[b] |= 1u << out_.shapes.size();
    out_.shapes.push_back(candidate.shape);
    out_.shapes.back().bone = known->second;
  }

  void tell() {
    if (out_.shapes.empty()) return;
    std::vector<std::string> names;
    for (const BodyBone& bone : out_.bones) names.push_back(bone.name);
    findings_.note(fmt::format("body colliders: {} on {}, whose poses the game gives", out_.shapes.size(),
                               fmt::join(names, ", ")));
    std::ranges::sort(names);
    const auto twice = std::ranges::adjacent_find(names);
    if (twice == names.end()) return;
    findings_.warn(
        "C121",
        fmt::format("two bones that carry body colliders are called '{}', and a game finds them by their names; rename "
                    "one in the model",
                    *twice));
  }

  const importer::SourceModel& source_;
  std::uint32_t head_node_;
  const Skeleton& skeleton_;
  bool is_thick_;  // bones have hit radii
  const RigRecipe& recipe_;
  Findings& findings_;
  std::vector<BodyCandidate> candidates_;
  std::map<std::uint32_t, std::uint32_t> bone_of_;  // Per node.
  BodyColliders out_;
};

}  // namespace

tl::expected<BodyColliders, ToolError> find_body_colliders(const importer::SourceModel& source,
                                                           const HeadBone& head_bone, const Skeleton& skeleton,
                                                           const Colliders& of_head, const RigRecipe& recipe,
                                                           Findings& findings) {
  tl::expected<BodyColliders, ToolError> body = BodyPass(source, head_bone, skeleton, of_head, recipe, findings).run();
  if (body && !body->shapes.empty()) {
    body->hit_radius = of_head.hit_radius;
    report_rest_penetration(skeleton, *body, "body collider", "set \"body.from_file\" to false", findings);
  }
  return body;
}

}  // namespace coif::cook
