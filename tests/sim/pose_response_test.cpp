// The oscillator's exact answers against an integration of its equation in small steps.

#include "sim/solver.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace coif::pose_response_test {

struct Motion {
  long double offset = 0, velocity = 0;
};

/// What drives the oscillator: y'' = -stiffness y - damping y' + load + bend 6 (1 - 2 t/dt) / dt^2.
struct Drive {
  long double load = 0;
  long double bend = 0;  ///< Metres that the end of the target's path is from a parabola's.
};

/// By the classical Runge-Kutta method.
Motion integrated(double stiffness, double damping, double dt, Motion y, const Drive& drive) {
  const auto rate = [&](long double t, const Motion& m) {
    const long double force = drive.load + drive.bend * 6 / dt / dt * (1 - 2 * t / dt);
    return Motion{m.velocity, -stiffness * m.offset - damping * m.velocity + force};
  };
  const auto moved = [](const Motion& m, const Motion& by, long double h) {
    return Motion{m.offset + by.offset * h, m.velocity + by.velocity * h};
  };
  const double fastest = std::sqrt(stiffness) + damping;
  const int count = 64 + int(64 * fastest * dt);
  const long double h = dt / (long double)(count);
  for (int i = 0; i < count; ++i) {
    const long double t = i * h;
    const Motion a = rate(t, y), b = rate(t + h / 2, moved(y, a, h / 2)), c = rate(t + h / 2, moved(y, b, h / 2));
    const Motion d = rate(t + h, moved(y, c, h));
    y.offset += h / 6 * (a.offset + 2 * b.offset + 2 * c.offset + d.offset);
    y.velocity += h / 6 * (a.velocity + 2 * b.velocity + 2 * c.velocity + d.velocity);
  }
  return y;
}

struct Oscillator {
  double stiffness, damping;
};

std::vector<Oscillator> oscillators() {
  std::vector<Oscillator> all;
  for (const double k : {0.0, 1e-3, 0.5, 60.0, 1543.0, 2.4e4, 1e6}) {
    const double critical = 2 * std::sqrt(k);
    for (const double ratio : {0.0, 0.1, 0.9, 0.9999, 1.0, 1.0001, 1.5, 4.0}) all.push_back({k, ratio * critical});
    all.push_back({k, 0.01});
    all.push_back({k, 30});
  }
  return all;
}

void expect_close(double value, double truth, double scale, const char* what) {
  EXPECT_NEAR(value, truth, 1e-5 * scale + 2e-6 * std::fabs(truth)) << what;
}

void expect_integrates(const Oscillator& o, double dt) {
  SCOPED_TRACE(testing::Message() << "stiffness " << o.stiffness << ", damping " << o.damping << ", dt " << dt);
  const PoseResponse r = pose_response(o.stiffness, o.damping, dt);
  const auto from = [&](Motion start, Drive drive) { return integrated(o.stiffness, o.damping, dt, start, drive); };
  const Motion by_offset = from({1, 0}, {}), by_velocity = from({0, 1}, {});
  const Motion by_load = from({}, {.load = 1}), by_bend = from({}, {.bend = 1});
  expect_close(r.offset_from_offset, double(by_offset.offset), 1, "offset from offset");
  expect_close(r.offset_from_velocity, double(by_velocity.offset), 0.1 * dt, "offset from velocity");
  expect_close(r.offset_from_load, double(by_load.offset), 0.01 * dt * dt, "offset from load");
  expect_close(r.offset_from_velocity, double(by_load.velocity), 0.1 * dt, "velocity from load");
  expect_close(r.velocity_from_offset, double(by_offset.velocity), 1 / dt, "velocity from offset");
  expect_close(r.velocity_from_velocity, double(by_velocity.velocity), 1, "velocity from velocity");
  expect_close(r.offset_from_bend, double(by_bend.offset), 1, "offset from bend");
  expect_close(r.velocity_from_bend, double(by_bend.velocity), 1 / dt, "velocity from bend");
  if (o.stiffness * dt * dt < 9) {  // under half an oscillation
    expect_close(r.velocity_per_offset, double(by_load.velocity / by_load.offset), 0.1 / dt, "velocity per offset");
  }
}

/// The factors of one answer, as comparable numbers without unit.
std::array<double, 8> unitless(const PoseResponse& r, double dt) {
  return {r.offset_from_offset,      r.offset_from_velocity / dt, r.offset_from_load / (dt * dt),
          r.offset_from_bend,        r.velocity_from_offset * dt, r.velocity_from_velocity,
          r.velocity_from_bend * dt, r.velocity_per_offset * dt};
}

TEST(PoseResponse, IsWhatTheEquationIntegratesTo) {
  for (const Oscillator& o : oscillators()) {
    for (const double dt : {1e-6, 1e-4, 1.0 / 240, 1.0 / 60, 1.0 / 15, 0.1}) {
      if (o.stiffness * dt * dt < 1e3) expect_integrates(o, dt);
    }
  }
}

/// Where springs are soft for the step, the answers are a series: exact as far as its terms go.
TEST(PoseResponse, OfSoftSpringsIsExactToTheLastDigits) {
  constexpr double kDt = 0.01;
  for (const double share : {0.0, 0.2, 0.5, 1.0}) {
    const double most = 0.005, damping = share * most / kDt, stiffness = (1 - share) * most / (kDt * kDt);
    SCOPED_TRACE(testing::Message() << "stiffness " << stiffness << ", damping " << damping);
    const auto r = unitless(pose_response(stiffness, damping, kDt), kDt);
    const auto from = [&](Motion start, Drive drive) { return integrated(stiffness, damping, kDt, start, drive); };
    const Motion by_offset = from({1, 0}, {}), by_velocity = from({0, 1}, {});
    const Motion by_load = from({}, {.load = 1}), by_bend = from({}, {.bend = 1});
    const long double truth[] = {by_offset.offset,
                                 by_velocity.offset / kDt,
                                 by_load.offset / (kDt * kDt),
                                 by_bend.offset,
                                 by_offset.velocity * kDt,
                                 by_velocity.velocity,
                                 by_bend.velocity * kDt,
                                 by_load.velocity / by_load.offset * kDt};
    for (std::size_t i = 0; i < r.size(); ++i) EXPECT_NEAR(r[i], double(truth[i]), 5e-10) << "factor " << i;
  }
}

TEST(PoseResponse, TwoHalfStepsOfTheFreeOscillatorAreOneStep) {
  for (const Oscillator& o : oscillators()) {
    for (const double dt : {1e-4, 1.0 / 60, 0.1}) {
      SCOPED_TRACE(testing::Message() << "stiffness " << o.stiffness << ", damping " << o.damping << ", dt " << dt);
      const PoseResponse half = pose_response(o.stiffness, o.damping, dt / 2),
                         whole = pose_response(o.stiffness, o.damping, dt);
      const auto twice = [&](double offset, double velocity) {
        for (int i = 0; i < 2; ++i) {
          const double next = half.offset_from_offset * offset + half.offset_from_velocity * velocity;
          velocity = half.velocity_from_offset * offset + half.velocity_from_velocity * velocity;
          offset = next;
        }
        return std::array{offset, velocity};
      };
      const double frequency = std::sqrt(o.stiffness);  // the largest velocity per metre
      EXPECT_NEAR(twice(1, 0)[0], whole.offset_from_offset, 1e-6);
      EXPECT_NEAR(twice(1, 0)[1], whole.velocity_from_offset, 1e-6 * frequency);
      EXPECT_NEAR(twice(0, 1)[0], whole.offset_from_velocity, 1e-6 * dt);
      EXPECT_NEAR(twice(0, 1)[1], whole.velocity_from_velocity, 1e-6);
    }
  }
}

TEST(PoseResponse, NoFormulaHandsOverToAnotherWithAJump) {
  constexpr double kDt = 0.01;
  for (const double damping : {0.0, 1e-3, 0.3, 1.9, 2.1, 10.0, 200.0, 1e5}) {
    std::array<double, 8> last = unitless(pose_response(1e-6, damping, kDt), kDt);
    for (double stiffness = 1e-6; stiffness < 2e4; stiffness *= 1.001) {
      const std::array<double, 8> now = unitless(pose_response(stiffness, damping, kDt), kDt);
      const double moved = stiffness * 0.001 * kDt * kDt;  // how far the stiffness itself changes the answer
      for (int i = 0; i < 8; ++i) {
        ASSERT_NEAR(now[i], last[i], 1.1 * moved + 1e-6) << "factor " << i << ", stiffness " << stiffness;
      }
      last = now;
    }
  }
}

TEST(PoseResponse, InfinitelyStiffHairFollowsItsPose) {
  for (const double dt : {1e-3, 1.0 / 60, 0.1}) {
    const PoseResponse r = pose_response(1e12, 2e6, dt);
    for (const double factor :
         {r.offset_from_offset, r.offset_from_velocity, r.velocity_from_offset, r.velocity_from_velocity}) {
      EXPECT_NEAR(factor, 0, 1e-9);
    }
    EXPECT_NEAR(r.offset_from_load, 1e-12, 1e-17);
  }
}

TEST(PoseResponse, IsFiniteForEverythingThatAnAssetMaySay) {
  constexpr double kMost = 3e38;
  for (const double stiffness : {0.0, 1e-30, 1.0, 1e12, kMost}) {
    for (const double damping : {0.0, 1e-30, 1.0, 1e12, kMost}) {
      for (const double dt : {1e-9, 1e-6, 1.0 / 60, 0.1}) {
        for (const double factor : unitless(pose_response(stiffness, damping, dt), 1)) {
          EXPECT_TRUE(std::isfinite(factor)) << stiffness << " " << damping << " " << dt;
        }
      }
    }
  }
}

TEST(PoseResponse, AnUndampedPeriodPerStepMultipliesNoVelocity) {
  for (double stiffness = 1e5; stiffness < 2e5; stiffness *= 1.0001) {  // about (2 pi 60 Hz)^2
    EXPECT_LE(std::fabs(pose_response(stiffness, 0, 1.0 / 60).velocity_per_offset), 120.001);
  }
}

}  // namespace coif::pose_response_test
