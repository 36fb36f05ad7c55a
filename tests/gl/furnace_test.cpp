// White furnace: light from everywhere alike, so strong that a white matte surface sends out 1. What sends out more
// adds energy, and with many lights looks as if it glowed. Prints the table of shaders/SHADING.md.

#include "cook/pack/pack.h"
#include "gl/reference_shading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

namespace coif::furnace_test {

using Eigen::Array3d;
using Eigen::Vector3d;

constexpr int kLights = 20000;
constexpr int kViews = 16;

/// The i-th of n directions that are spread evenly over the sphere.
Vector3d spread_direction(int i, int n) {
  const double z = 1 - (2 * i + 1.0) / n;
  const double turn = i * std::numbers::pi * (3 - std::sqrt(5.0));
  const double radius = std::sqrt(1 - z * z);
  return {radius * std::cos(turn), z, radius * std::sin(turn)};
}

const ShadedPoint kPoint{.position = Vector3d::Zero(),
                         .normal = Vector3d::UnitZ(),
                         .tangent = -Vector3d::UnitY(),
                         .base_texel = {255, 255, 255, 255},
                         .shift_mask = {128, 255}};

/// Sum over the lights, whose colours add up to 4: over the sphere that is 1 on a surface.
template <typename Reflection>
Array3d furnace_sum(Reflection reflection) {
  Array3d sum = Array3d::Zero();
  for (int i = 0; i < kLights; ++i) sum += reflection(spread_direction(i, kLights));
  return sum * 4 / kLights;
}

struct Albedo {
  double mean = 0;  ///< Over directions of view, channel that returns most.
  double most = 0;
};

Albedo furnace_albedo(const MaterialRecord& material) {
  Albedo albedo;
  for (int v = 0; v < kViews; ++v) {
    Vector3d view = spread_direction(v, kViews);
    if (view.z() < 0) view = -view;  // in front of the side that is seen
    const Array3d sum =
        furnace_sum([&](const Vector3d& l) { return reference_reflection(kPoint, view, l, material).sum(); });
    albedo.mean += sum.maxCoeff() / kViews;
    albedo.most = std::max(albedo.most, sum.maxCoeff());
  }
  return albedo;
}

struct Case {
  const char* name;
  MaterialRecord material;
};

MaterialRecord white() {
  MaterialRecord m{};
  std::fill_n(m.base_color, 4, 1.0f);
  return m;
}

MaterialRecord thesis(float color, float primary_exponent, float secondary_exponent) {
  MaterialRecord m = white();
  std::fill_n(m.primary_color, 3, color);
  std::fill_n(m.secondary_color, 3, color);
  m.primary_exponent = primary_exponent;
  m.secondary_exponent = secondary_exponent;
  m.primary_shift = 0.7f;
  m.secondary_shift = 0.5f;
  return m;
}

MaterialRecord kajiya_kay(float color, float exponent) {
  MaterialRecord m = thesis(color, exponent, 1);
  m.shading = ShadingModel::kKajiyaKay;
  return m;
}

MaterialRecord marschner(float base, float roughness, float scatter) {
  MaterialRecord m = thesis(1, 1, 1);
  m.shading = ShadingModel::kMarschner;
  std::fill_n(m.base_color, 3, base);
  m.tilt = 0.05f;
  m.roughness = roughness;
  m.scatter = scatter;
  return m;
}

MaterialRecord volume(float base, float roughness) {
  MaterialRecord m = marschner(base, roughness, 0);
  m.shading = ShadingModel::kVolume;
  return m;
}

std::vector<Case> published_cases() {
  return {{"thesis, no highlights", thesis(0, 150, 30)}, {"thesis 150, 30", thesis(1, 150, 30)},
          {"thesis 1000, 70", thesis(1, 1000, 70)},      {"thesis 5000, 100", thesis(1, 5000, 100)},
          {"thesis 5, 0.5", thesis(1, 5, 0.5f)},         {"kajiya-kay, no highlight", kajiya_kay(0, 150)},
          {"kajiya-kay 150", kajiya_kay(1, 150)},        {"kajiya-kay 20", kajiya_kay(1, 20)}};
}

std::vector<Case> fiber_cases() {
  return {{"marschner, white, scatter 0", marschner(1, 0.14f, 0)},
          {"marschner, white, scatter 0.8", marschner(1, 0.14f, 0.8f)},
          {"marschner, white, scatter 1", marschner(1, 0.14f, 1)},
          {"marschner, white, roughness 1", marschner(1, 1, 0.8f)},
          {"marschner, white, roughness 0.02", marschner(1, 0.02f, 0.8f)},
          {"marschner, grey 0.5", marschner(0.5f, 0.14f, 0.8f)},
          {"marschner, black", marschner(0, 0.14f, 0.8f)}};
}

std::vector<Case> volume_cases() {
  return {{"volume, white", volume(1, 0.29f)},
          {"volume, white, roughness 0.1", volume(1, 0.1f)},
          {"volume, grey 0.5", volume(0.5f, 0.29f)},
          {"volume, grey 0.2", volume(0.2f, 0.29f)},
          {"volume, black", volume(0, 0.29f)}};
}

void print_row(const Case& c, const Albedo& albedo, double bound) {
  std::printf("| %-32s | %5.2f | %5.2f | %5.2f |\n", c.name, albedo.mean, albedo.most, bound);
}

TEST(Furnace, ReturnsOneFromAWhiteMatteSurface) {
  const Array3d matte = furnace_sum([](const Vector3d& l) { return Array3d::Constant(std::max(l.z(), 0.0)); });
  EXPECT_NEAR(matte[0], 1, 1e-3);
}

TEST(Furnace, ModelsOfSurfacesStayBelowTheirBoundAndComeNearIt) {
  for (const Case& c : published_cases()) {
    const Albedo albedo = furnace_albedo(c.material);
    const double bound = cook::furnace_bound(c.material);
    print_row(c, albedo, bound);
    EXPECT_LE(albedo.most, 1.005 * bound) << c.name;
    EXPECT_GE(albedo.most, 0.8 * bound) << c.name;
    EXPECT_GT(albedo.mean, 1) << c.name << ": as published, more comes out than goes in";
  }
}

TEST(Furnace, BoundedMaterialsReturnNoMoreThanTheyGet) {
  for (Case c : published_cases()) {
    c.material.light_cut = cook::bounding_cut(c.material);
    const Albedo albedo = furnace_albedo(c.material);
    print_row(c, albedo, 1);
    EXPECT_LE(albedo.most, 1.005) << c.name;
    EXPECT_GE(albedo.most, 0.8) << c.name << ": cut no more than needed";
  }
}

TEST(Furnace, FibersReturnNoMoreThanTheyGet) {
  for (const Case& c : fiber_cases()) {
    const Albedo albedo = furnace_albedo(c.material);
    print_row(c, albedo, cook::furnace_bound(c.material));
    EXPECT_LE(albedo.most, 1.005) << c.name;
    EXPECT_EQ(cook::bounding_cut(c.material), 0) << c.name;
  }
}

TEST(Furnace, VolumesOfFibersReturnNoMoreThanTheyGetOnTheWhole) {
  for (const Case& c : volume_cases()) {
    const Albedo albedo = furnace_albedo(c.material);
    print_row(c, albedo, cook::furnace_bound(c.material));
    EXPECT_LE(albedo.mean, 1.005) << c.name;
    EXPECT_LE(albedo.most, cook::furnace_bound(c.material)) << c.name;
  }
}

}  // namespace coif::furnace_test
