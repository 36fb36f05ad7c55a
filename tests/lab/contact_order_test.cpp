// How fast the runtime's error falls with the step where hair comes to lie on a collider, and on which energy it then has.

#include "lab/hair_segment.h"
#include "lab/passive_model.h"
#include "lab/reference_solver.h"
#include "lab/reference_trial.h"
#include "lab/runtime_solver.h"
#include "models/test_rig.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <ostream>
#include <string>

namespace coif::contact_order_test {

using Eigen::Vector3d;

/// The head bows, and hair falls onto what is in front of it. It starts from its rest, and the runtime knows the head's way: what is left
/// is the order of contacts.
std::unique_ptr<HeadPath> bow() { return held_turn(Vector3d(1, 0.1, 0.2).normalized(), 1.9, 0.8); }
constexpr double kSeconds = 1.6;
constexpr int kRate = 60;

struct Lying {
  const char* name;
  ChainModel model;
  int bones;
  std::function<void(TestRig&)> add_collider;
};

void PrintTo(const Lying& lying, std::ostream* out) { *out << lying.name; }

TestRig rig_of(const Lying& lying) {
  TestRig rig;
  rig.model = lying.model;
  TestBone bone;
  bone.length = 0.3f / float(lying.bones);
  bone.friction = 1.5f;
  bone.stiffness = 25;
  bone.damping = 3;
  bone.torsion = kShortestArc;
  rig.add_strand(lying.bones, bone);
  lying.add_collider(rig);
  return rig;
}

struct Fall {
  double error = 0;    ///< Root mean square of the tip's distance to the reference, share of the chain's length.
  double nearest = 1;  ///< Metres, of any bone to the collider.
  ConstraintErrors held;
};

class Falls {
 public:
  explicit Falls(const Lying& lying) : opened_(rig_of(lying).contents()), rig_(coif::rig_of(opened_.asset())) {
    reference_ = solve_reference(rig_, {}, *bow(),
                                 {.sample_times = evenly(kRate, kSeconds),
                                  .steps_per_second = 20e3,
                                  .most_steps_per_second = 40e3,
                                  .wanted_self_difference_pct = 0});
  }

  [[nodiscard]] const ReferenceRun& reference() const { return reference_; }

  [[nodiscard]] Fall at(int substeps) const {
    RuntimeSolver solver(opened_.asset(), {}, kCoifSolver, substeps);
    const auto path = bow();
    solver.reset(path->pose(0));
    ConstraintMeter meter(rig_);
    const std::vector<SolidShape> solids = solid_shapes(rig_.colliders);
    Fall fall;
    const int frames = int(std::lround(kSeconds * kRate));
    for (int frame = 1; frame <= frames; ++frame) {
      const HeadState head = path->at(double(frame) / kRate);
      EXPECT_TRUE(solver.step_told(pose_of(head), velocity_of(head), 1.0 / kRate));
      const auto ends = solver.bone_ends();
      meter.look(ends);
      fall.error += (ends.back() - reference_.path_of_tip(0)[std::size_t(frame)]).squaredNorm();
      for (std::size_t i = 0; i < ends.size(); ++i) {
        const Vector3d start = i == 0 ? rig_.bones[0].joint : ends[i - 1];
        const HairSegment segment{start, (ends[i] - start).normalized(), rig_.bones[i].length, 0};
        fall.nearest = std::min(fall.nearest, nearest_contact(solids[0], segment).gap);
      }
    }
    fall.error = std::sqrt(fall.error / frames) / rig_.tip_length[0];
    fall.held = meter.worst();
    return fall;
  }

 private:
  OpenedAsset opened_;
  Rig rig_;
  ReferenceRun reference_;
};

class ContactOrder : public testing::TestWithParam<Lying> {};

TEST_P(ContactOrder, HalvingTheStepDividesTheErrorOfHairThatComesToLie) {
  const Falls falls(GetParam());
  std::array<Fall, 5> steps;
  for (std::size_t k = 0; k < steps.size(); ++k) steps[k] = falls.at(1 << k);
  std::string all;
  for (const Fall& fall : steps) all += std::to_string(100 * fall.error) + " ";
  printf("%s: %s self %.5f\n", GetParam().name, all.c_str(), falls.reference().self_difference_pct());
  EXPECT_LT(steps[0].nearest, 1e-5) << "nothing was touched";
}

std::vector<Lying> all_lying() {
  std::vector<Lying> all;
  static std::vector<std::string> names;
  names.reserve(100);
  const std::pair<const char*, std::function<void(TestRig&)>> colliders[] = {
      {"Sphere", [](TestRig& rig) { rig.add_sphere({0.02f, -0.2f, 0.12f}, 0.09f); }},
      {"Ellipsoid", [](TestRig& rig) { rig.add_ellipsoid({0.02f, -0.16f, 0.12f}, {0.08f, 0.1f, 0.09f}); }},
      {"Capsule", [](TestRig& rig) { rig.add_capsule({-0.1f, -0.2f, 0.12f}, {0.2f, -0.18f, 0.12f}, 0.08f); }},
      {"Nothing", [](TestRig& rig) { rig.add_sphere({5, 0, 0}, 0.01f); }},
      {"Plane", [](TestRig& rig) { rig.add_plane({0, -0.2f, 0.12f}, {0, 0.3162278f, -0.9486833f}); }},
  };
  for (const auto& [name, add] : colliders) {
    for (const auto& [kind, model, bones] : {std::tuple{"BoneOfACascade", ChainModel::kCascade, 1}, {"CascadeOfTwo", ChainModel::kCascade, 2},
                                             {"PassiveBone", ChainModel::kPassive, 1}, {"PassiveTwo", ChainModel::kPassive, 2},{"PassiveChain", ChainModel::kPassive, 5}}) {
      names.push_back(std::string(kind) + "On" + name);
      all.push_back({names.back().c_str(), model, bones, add});
    }
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Colliders, ContactOrder, testing::ValuesIn(all_lying()),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace coif::contact_order_test
