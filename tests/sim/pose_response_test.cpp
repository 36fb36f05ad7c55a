// The oscillator's exact answers against an integration of its equation in small steps.

#include <coif/coif_step_job.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace coif {
namespace {

PoseResponse response(float stiffness, float damping, float dt) {
  DynamicsRecord record{};
  record.stiffness = stiffness;
  record.damping = damping;
  PoseResponse out{};
  compute_pose_responses({&record, 1}, dt, {}, {&out, 1});
  return out;
}

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
  float stiffness, damping;
};

std::vector<Oscillator> oscillators() {
  std::vector<Oscillator> all;
  for (const float k : {0.0f, 1e-3f, 0.5f, 60.0f, 1543.0f, 2.4e4f, 1e6f}) {
    const float critical = 2 * std::sqrt(k);
    for (const float ratio : {0.0f, 0.1f, 0.9f, 0.9999f, 1.0f, 1.0001f, 1.5f, 4.0f})
      all.push_back({k, ratio * critical});
    all.push_back({k, 0.01f});
    all.push_back({k, 30});
  }
  return all;
}

void expect_close(double value, double truth, double scale, const char* what) {
  EXPECT_NEAR(value, truth, 1e-5 * scale + 2e-6 * std::fabs(truth)) << what;
}

void expect_integrates(const Oscillator& o, float dt) {
  SCOPED_TRACE(testing::Message() << "stiffness " << o.stiffness << ", damping " << o.damping << ", dt " << dt);
  const PoseResponse r = response(o.stiffness, o.damping, dt);
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

TEST(PoseResponse, IsWhatTheEquationIntegratesTo) {
  for (const Oscillator& o : oscillators()) {
    for (const float dt : {1e-6f, 1e-4f, 1.0f / 240, 1.0f / 60, 1.0f / 15, 0.1f}) {
      if (o.stiffness * dt * dt < 1e3f) expect_integrates(o, dt);
    }
  }
}

TEST(PoseResponse, TwoHalfStepsOfTheFreeOscillatorAreOneStep) {
  for (const Oscillator& o : oscillators()) {
    for (const float dt : {1e-4f, 1.0f / 60, 0.1f}) {
      SCOPED_TRACE(testing::Message() << "stiffness " << o.stiffness << ", damping " << o.damping << ", dt " << dt);
      const PoseResponse half = response(o.stiffness, o.damping, dt / 2), whole = response(o.stiffness, o.damping, dt);
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

/// The factors of one answer, as comparable numbers without unit.
std::array<float, 8> unitless(const PoseResponse& r, float dt) {
  return {r.offset_from_offset,      r.offset_from_velocity / dt, r.offset_from_load / (dt * dt),
          r.offset_from_bend,        r.velocity_from_offset * dt, r.velocity_from_velocity,
          r.velocity_from_bend * dt, r.velocity_per_offset * dt};
}

TEST(PoseResponse, NoFormulaHandsOverToAnotherWithAJump) {
  constexpr float kDt = 0.01f;
  for (const float damping : {0.0f, 1e-3f, 0.3f, 1.9f, 2.1f, 10.0f, 200.0f, 1e5f}) {
    std::array<float, 8> last = unitless(response(1e-6f, damping, kDt), kDt);
    for (float stiffness = 1e-6f; stiffness < 2e4f; stiffness *= 1.001f) {
      const std::array<float, 8> now = unitless(response(stiffness, damping, kDt), kDt);
      const float moved = stiffness * 0.001f * kDt * kDt;  // how far the stiffness itself changes the answer
      for (int i = 0; i < 8; ++i) {
        ASSERT_NEAR(now[i], last[i], 1.1f * moved + 1e-6f) << "factor " << i << ", stiffness " << stiffness;
      }
      last = now;
    }
  }
}

TEST(PoseResponse, InfinitelyStiffHairFollowsItsPose) {
  for (const float dt : {1e-3f, 1.0f / 60, 0.1f}) {
    const PoseResponse r = response(1e12f, 2e6f, dt);
    for (const float factor :
         {r.offset_from_offset, r.offset_from_velocity, r.velocity_from_offset, r.velocity_from_velocity}) {
      EXPECT_NEAR(factor, 0, 1e-9);
    }
    EXPECT_NEAR(r.offset_from_load, 1e-12, 1e-17);
  }
}

TEST(PoseResponse, IsFiniteForEverythingThatAnAssetMaySay) {
  constexpr float kMost = 3e38f;
  for (const float stiffness : {0.0f, 1e-30f, 1.0f, 1e12f, kMost}) {
    for (const float damping : {0.0f, 1e-30f, 1.0f, 1e12f, kMost}) {
      for (const float dt : {1e-9f, 1e-6f, 1.0f / 60, 0.1f}) {
        for (const float factor : unitless(response(stiffness, damping, dt), 1)) {
          EXPECT_TRUE(std::isfinite(factor)) << stiffness << " " << damping << " " << dt;
        }
      }
    }
  }
}

TEST(PoseResponse, AnUndampedPeriodPerStepMultipliesNoVelocity) {
  for (float stiffness = 1e5f; stiffness < 2e5f; stiffness *= 1.0001f) {  // about (2 pi 60 Hz)^2
    EXPECT_LE(std::fabs(response(stiffness, 0, 1.0f / 60).velocity_per_offset), 120.001f);
  }
}

TEST(PoseResponse, ScalesMultiplyWhatTheAssetSays) {
  DynamicsRecord soft{}, stiff{};
  soft.stiffness = 100, soft.damping = 5, soft.friction = 2;
  stiff.stiffness = 300, stiff.damping = 10, stiff.friction = 1;
  PoseResponse scaled{}, plain{};
  compute_pose_responses({&soft, 1}, 0.02f, {.stiffness = 3, .damping = 2, .friction = 0.5f}, {&scaled, 1});
  compute_pose_responses({&stiff, 1}, 0.02f, {}, {&plain, 1});
  EXPECT_EQ(unitless(scaled, 1), unitless(plain, 1));
}

}  // namespace
}  // namespace coif
