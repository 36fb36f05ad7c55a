// What every listed solver promises, whatever its method.

#include "research/solver_trial.h"
#include "research/solvers/historical_solvers.h"
#include "research/solvers/particle_solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace coif::research::solvers_test {

using Eigen::Vector3d;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<Vector3d> ends_of(const lab::ChainSolver& solver) {
  return {solver.bone_ends().begin(), solver.bone_ends().end()};
}

bool all_finite(std::span<const Vector3d> ends) {
  for (const Vector3d& end : ends) {
    if (!end.allFinite()) return false;
  }
  return true;
}

class EverySolver : public testing::TestWithParam<ListedSolver> {
 protected:
  [[nodiscard]] std::unique_ptr<lab::ChainSolver> create(const lab::Rig& rig) const {
    return GetParam().create(rig, {}, GetParam().efforts.back());
  }
};

INSTANTIATE_TEST_SUITE_P(Listed, EverySolver, testing::ValuesIn(historical_solvers()),
                         [](const auto& tested) { return test_name(tested.param.name); });

TEST_P(EverySolver, IsListedWithAllThatAReportShows) {
  const ListedSolver& listed = GetParam();
  EXPECT_FALSE(listed.description.empty());
  EXPECT_EQ(listed.description.find('\n'), std::string_view::npos);
  EXPECT_FALSE(listed.source.empty());
  EXPECT_FALSE(listed.effort_unit.empty());
  ASSERT_FALSE(listed.efforts.empty());
  EXPECT_GT(listed.efforts.front(), 0);
  for (std::size_t i = 1; i < listed.efforts.size(); ++i) EXPECT_LT(listed.efforts[i - 1], listed.efforts[i]);
}

TEST(HistoricalSolvers, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (const ListedSolver& listed : historical_solvers()) EXPECT_TRUE(names.insert(listed.name).second) << listed.name;
  EXPECT_EQ(names.size(), 9u);
}

TEST_P(EverySolver, StartsFromTheRestPoseOfATurnedHead) {
  const lab::Rig rig = forked_rig();
  const auto solver = create(rig);
  solver->reset(walking(0.4));
  const auto ends = solver->bone_ends();
  ASSERT_EQ(ends.size(), rig.bones.size());
  EXPECT_LT((ends[0] - rig.bones[0].rest_direction * rig.bones[0].length).norm(), 1e-6);
  EXPECT_LT(worst_stretch(rig, ends), 1e-12);
}

TEST_P(EverySolver, RefusesWhatIsNoStepAndStaysAsItWas) {
  const auto solver = create(forked_rig());
  solver->reset({});
  ASSERT_TRUE(run(*solver, walking, 1.0 / 120, 0.25));
  const auto before = ends_of(*solver);
  HeadPose nowhere = walking(0.26), unturned = walking(0.26);
  nowhere.position[1] = kNaN;
  unturned.rotation.w = float(kNaN);
  for (const double dt : {0.0, -1.0 / 60, kNaN, kInfinity}) EXPECT_FALSE(solver->step(walking(0.26), dt)) << dt;
  EXPECT_FALSE(solver->step(nowhere, 1.0 / 60));
  EXPECT_FALSE(solver->step(unturned, 1.0 / 60));
  EXPECT_EQ(ends_of(*solver), before);

  const auto undisturbed = create(forked_rig());
  undisturbed->reset({});
  ASSERT_TRUE(run(*undisturbed, walking, 1.0 / 120, 0.25));
  ASSERT_TRUE(solver->step(walking(0.26), 1.0 / 120));
  ASSERT_TRUE(undisturbed->step(walking(0.26), 1.0 / 120));
  EXPECT_EQ(ends_of(*solver), ends_of(*undisturbed)) << "what bone_ends() does not show has changed";
}

TEST_P(EverySolver, RefusesToBeginWithoutReset) { EXPECT_FALSE(create(forked_rig())->step({}, 1.0 / 60)); }

TEST_P(EverySolver, GivesTheSameTwiceAndAfterReset) {
  const auto first = create(forked_rig()), second = create(forked_rig());
  for (lab::ChainSolver* solver : {first.get(), second.get()}) {
    solver->reset({});
    ASSERT_TRUE(run(*solver, walking, 1.0 / 60, 0.5));
  }
  EXPECT_EQ(ends_of(*first), ends_of(*second));
  second->reset({});
  ASSERT_TRUE(run(*second, walking, 1.0 / 60, 0.5));
  EXPECT_EQ(ends_of(*first), ends_of(*second));
}

TEST_P(EverySolver, MovesAMirroredRigMirrored) {
  const auto solver = create(forked_rig()), other = create(mirrored(forked_rig()));
  solver->reset({});
  other->reset({});
  double moved = 0;
  for (int i = 1; i <= 90; ++i) {
    const HeadPose head = walking(i / 60.0);
    ASSERT_TRUE(solver->step(head, 1.0 / 60));
    ASSERT_TRUE(other->step(mirrored(head), 1.0 / 60));
    std::vector<Vector3d> mirror = ends_of(*other);
    for (Vector3d& end : mirror) end.x() = -end.x();
    ASSERT_LT(worst_distance(solver->bone_ends(), mirror), 1e-9) << "step " << i;
    moved = std::max(moved, std::abs(solver->bone_ends()[3].x()));
  }
  EXPECT_GT(moved, 0.002);
}

/// A head that moves evenly moves nothing, wherever it is: only the air could tell, and it goes along.
TEST_P(EverySolver, DoesNotSeeThatTheHeadMovesEvenly) {
  const auto resting = create(forked_rig()), riding = create(forked_rig());
  const HeadMotion ride = [](double seconds) {
    HeadPose head;
    // Up to speed without a jolt, so that what is left of it has died down when the comparison is made.
    head.position[2] = 8 * (seconds - (1 - std::exp(-4 * seconds)) / 4);
    return head;
  };
  resting->reset({});
  riding->reset({});
  ASSERT_TRUE(run(*resting, still, 1.0 / 120, 6));
  ASSERT_TRUE(run(*riding, ride, 1.0 / 120, 6));
  EXPECT_LT(worst_distance(resting->bone_ends(), riding->bone_ends()), 1e-6);
}

TEST_P(EverySolver, SurvivesWhatItCannotSolveAndCanBeReset) {
  lab::Rig rig = forked_rig();
  rig.bones[2].stiffness = rig.bones[2].damping = rig.bones[2].resistance = 0;
  rig.bones[3].resistance = 1;
  rig.bones[4].friction = 1e6;
  rig.bones[5].rest_direction = -rig.bones[4].rest_direction;
  rig.colliders = {sphere({0, 0, 0}, 0.1), sphere({0, 0.05, 0}, 0.1)};
  for (lab::RigBone& bone : rig.bones) bone.colliders = 0xffu;
  const auto solver = create(rig);
  solver->reset({});
  HeadPose far;
  far.position[0] = 1e7;
  for (const double dt : {10.0, 1e-9, 0.1, 1.0 / 60}) {
    for (int i = 0; i < 20; ++i) static_cast<void>(solver->step(i % 2 == 0 ? far : HeadPose{}, dt));
    EXPECT_EQ(solver->bone_ends().size(), rig.bones.size());
  }
  solver->reset({});
  EXPECT_TRUE(all_finite(solver->bone_ends()));
  ASSERT_TRUE(run(*solver, still, 1.0 / 240, 0.1));
  EXPECT_TRUE(all_finite(solver->bone_ends()));
}

std::unique_ptr<lab::ChainSolver> implicit(const lab::Rig& rig) {
  return std::make_unique<ImplicitSolver>(rig, lab::SolverScene{});
}

HeadPose moved_to(double x) {
  HeadPose head;
  head.position[0] = x;
  return head;
}

TEST(SubSteps, MoveTheHeadEvenlyInBetween) {
  const lab::Rig rig = forked_rig();
  const auto whole = in_sub_steps(implicit(rig), 4), parts = implicit(rig);
  whole->reset({});
  parts->reset({});
  ASSERT_TRUE(whole->step(moved_to(0.08), 1.0 / 60));
  for (const double x : {0.02, 0.04, 0.06, 0.08}) ASSERT_TRUE(parts->step(moved_to(x), 1.0 / 240));
  EXPECT_LT(worst_distance(whole->bone_ends(), parts->bone_ends()), 1e-12);
}

TEST(SubSteps, TurnTheHeadTheShortWay) {
  const lab::Rig rig = forked_rig();
  const auto near = in_sub_steps(implicit(rig), 4), far = in_sub_steps(implicit(rig), 4);
  HeadPose turned;
  turned.rotation = {0, 0.1f, 0, 0.99498743f};
  near->reset({});
  far->reset({});
  ASSERT_TRUE(near->step(turned, 1.0 / 60));
  turned.rotation = {0, -0.1f, 0, -0.99498743f};  // The same turn.
  ASSERT_TRUE(far->step(turned, 1.0 / 60));
  EXPECT_LT(worst_distance(near->bone_ends(), far->bone_ends()), 1e-9);
}

TEST(SubSteps, BeginFromTheLastHeadThatWasTaken) {
  const lab::Rig rig = forked_rig();
  const auto solver = in_sub_steps(implicit(rig), 2), undisturbed = in_sub_steps(implicit(rig), 2);
  solver->reset({});
  undisturbed->reset({});
  EXPECT_FALSE(solver->step(moved_to(5), 0));
  ASSERT_TRUE(solver->step(moved_to(0.02), 1.0 / 60));
  ASSERT_TRUE(undisturbed->step(moved_to(0.02), 1.0 / 60));
  EXPECT_EQ(worst_distance(solver->bone_ends(), undisturbed->bone_ends()), 0);
}

TEST(SubSteps, OfOneAreTheSolverItself) {
  auto solver = implicit(forked_rig());
  const lab::ChainSolver* itself = solver.get();
  EXPECT_EQ(in_sub_steps(std::move(solver), 1).get(), itself);
}

using Eigen::Quaterniond;

void set(float (&to)[3], const Vector3d& value) {
  for (int axis = 0; axis < 3; ++axis) to[axis] = float(value[axis]);
}

/// A bone that keeps 1 cm from one collider.
lab::Rig rig_with(const ColliderRecord& collider) {
  lab::Rig rig = pendulum_rig();
  rig.bones[0].hit_radius = 0.01;
  rig.bones[0].colliders = 1;
  rig.colliders = {collider};
  return rig;
}

const Vector3d kFrom(0.02, 0.05, -0.01), kAxis(0.06, -0.09, 0.03);
constexpr double kThick = 0.08, kThin = 0.05;

ColliderRecord capsule(ColliderShape shape) {
  ColliderRecord record = sphere(kFrom, kThick);
  record.shape = shape;
  set(record.axis, kAxis);
  if (shape == ColliderShape::kTaperedCapsule) set(record.radii, {kThick, kThin, 0});
  return record;
}

/// To the surface of the union of balls along the capsule's segment, by trying many of them.
double distance_to_capsule(const Vector3d& point, double last_radius) {
  double nearest = 1e9;
  for (int i = 0; i <= 4000; ++i) {
    const double share = i / 4000.0;
    const double radius = kThick + (last_radius - kThick) * share;
    nearest = std::min(nearest, (point - kFrom - kAxis * share).norm() - radius);
  }
  return nearest;
}

/// A grid of points that fills half a metre around the origin and hits no centre.
template <typename Visit>
void for_points(Visit visit) {
  for (int i = 0; i < 1000; ++i) {
    visit(Vector3d(i % 10 - 4.6, i / 10 % 10 - 4.4, i / 100 - 4.55) * 0.05);
  }
}

const Quaterniond kTurned(Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()));

/// Points inside end `hit_radius` from the surface, points outside stay; whatever the head's rotation.
template <typename Distance>
void expect_clear(const lab::Rig& rig, double tolerance, Distance distance) {
  int moved = 0, stayed = 0;
  for_points([&](const Vector3d& point) {
    const Vector3d cleared = kTurned.conjugate() * clear_of_colliders(rig, 0, kTurned, kTurned * point);
    if (distance(point) >= 0.01 + tolerance) {
      EXPECT_LT((cleared - point).norm(), 1e-12);
      ++stayed;
    } else {
      EXPECT_NEAR(distance(cleared), 0.01, tolerance);
      ++moved;
    }
  });
  EXPECT_GT(moved, 10);
  EXPECT_GT(stayed, 10);
}

TEST(PointCollisions, ClearASphere) {
  expect_clear(rig_with(sphere(kFrom, 0.12)), 1e-6, [](const Vector3d& p) { return (p - kFrom).norm() - 0.12; });
}

TEST(PointCollisions, KeepInsideOfASphereThatHoldsHair) {
  ColliderRecord record = sphere(kFrom, 0.12);
  record.flags = kColliderKeepsInside;
  expect_clear(rig_with(record), 1e-6, [](const Vector3d& p) { return 0.12 - (p - kFrom).norm(); });
}

TEST(PointCollisions, ClearACapsule) {
  expect_clear(rig_with(capsule(ColliderShape::kCapsule)), 1e-5,
               [](const Vector3d& p) { return distance_to_capsule(p, kThick); });
}

TEST(PointCollisions, ClearATaperedCapsule) {
  expect_clear(rig_with(capsule(ColliderShape::kTaperedCapsule)), 1e-5,
               [](const Vector3d& p) { return distance_to_capsule(p, kThin); });
}

TEST(PointCollisions, ClearAPlane) {
  ColliderRecord record{};
  record.shape = ColliderShape::kPlane;
  const Vector3d normal = Vector3d(1, 3, 2).normalized();
  set(record.center, kFrom);
  set(record.axis, normal);
  expect_clear(rig_with(record), 1e-6, [&](const Vector3d& p) { return (p - kFrom).dot(normal); });
}

TEST(PointCollisions, ClearAnEllipsoid) {
  const Quaterniond turn(Eigen::AngleAxisd(0.5, Vector3d::UnitZ()));
  ColliderRecord record = sphere(kFrom, 0);
  record.shape = ColliderShape::kEllipsoid;
  set(record.radii, {0.08, 0.12, 0.1});
  for (int i = 0; i < 4; ++i) record.rotation[i] = float(turn.coeffs()[i]);
  const Vector3d grown = Vector3d(0.09, 0.13, 0.11);
  // 0.01 on the grown ellipsoid, below within, above outside.
  expect_clear(rig_with(record), 1e-6,
               [&](const Vector3d& p) { return (turn.conjugate() * (p - kFrom)).cwiseQuotient(grown).norm() - 0.99; });
}

TEST(PointCollisions, LeaveTheVeryCentreSomewhere) {
  for (const ColliderRecord& record : {sphere(kFrom, 0.1), capsule(ColliderShape::kCapsule)}) {
    const Vector3d center(double(record.center[0]), double(record.center[1]), double(record.center[2]));
    const Vector3d cleared = clear_of_colliders(rig_with(record), 0, kTurned, kTurned * center);
    ASSERT_TRUE(cleared.allFinite());
    EXPECT_NEAR((cleared - kTurned * center).norm(), double(record.radii[0]) + 0.01, 1e-6);
  }
}

TEST(PointCollisions, TouchOnlyWhatTheBoneMay) {
  lab::Rig rig = rig_with(sphere({0, 0, 0}, 0.1));
  const Vector3d inside(0.01, 0.02, 0.03);
  for (const std::uint32_t colliders : {0u, 2u}) {  // None, and one that does not exist.
    rig.bones[0].colliders = colliders;
    EXPECT_EQ(clear_of_colliders(rig, 0, kTurned, inside), inside);
  }
}

TEST(PointCollisions, PushOutTakesTheSpeedIntoTheMovingHeadAndNoOther) {
  const lab::Rig rig = rig_with(sphere({0, 0, 0}, 0.1));
  const Vector3d zero = Vector3d::Zero();
  ParticleStep step{1.0 / 60, Quaterniond::Identity(), Quaterniond::Identity(), zero, zero, Vector3d(0, 1, 0), zero};
  Vector3d position(0, 0.1, 0), velocity(3, 0.4, 0);  // Upwards, but the head comes after faster.
  ASSERT_TRUE(push_out(rig, 0, step, position, velocity));
  EXPECT_LT((position - Vector3d(0, 0.11, 0)).norm(), 1e-6);
  EXPECT_LT((velocity - Vector3d(3, 1, 0)).norm(), 1e-6);
  velocity = Vector3d(3, 2, 0);  // Leaves already.
  position.y() = 0.1;
  ASSERT_TRUE(push_out(rig, 0, step, position, velocity));
  EXPECT_EQ(velocity, Vector3d(3, 2, 0));
  EXPECT_FALSE(push_out(rig, 0, step, position = Vector3d(0, 0.2, 0), velocity));
}

TEST(PointCollisions, KeepTheLengthWhereTheyMust) {
  const lab::Rig rig = rig_with(sphere({0, 0, 0}, 0.1));  // The bone is 0.1 m long.
  const Vector3d start(0, 0.12, 0), wanted = start + Vector3d(0.02, -0.1, 0);
  const Vector3d end = clear_of_colliders_at_length(rig, 0, kTurned, start, wanted);
  EXPECT_NEAR((end - start).norm(), 0.1, 1e-9);
  EXPECT_GT(end.norm(), 0.109);
}

}  // namespace coif::research::solvers_test
