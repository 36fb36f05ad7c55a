#pragma once

// Bodies that tests make up.

#include "grow/body_surface.h"
#include "import/source_model.h"

#include <Eigen/Core>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

namespace coif::grow::test {

struct MadeUpMesh {
  std::vector<Eigen::Vector3f> positions;
  std::vector<std::uint32_t> triangles;
};

/// An ellipsoid; `from` and `to`: which share of it from the top down there is.
inline MadeUpMesh ellipsoid(const Eigen::Vector3f& center, const Eigen::Vector3f& radii, float from = 0, float to = 1) {
  constexpr std::uint32_t kRings = 24, kAround = 48;
  MadeUpMesh mesh;
  for (std::uint32_t ring = 0; ring <= kRings; ++ring) {
    const float polar = std::numbers::pi_v<float> * (from + (to - from) * float(ring) / kRings);
    for (std::uint32_t k = 0; k < kAround; ++k) {
      const float around = 2 * std::numbers::pi_v<float> * float(k) / kAround;
      const Eigen::Vector3f unit(std::sin(polar) * std::sin(around), std::cos(polar),
                                 std::sin(polar) * std::cos(around));
      mesh.positions.emplace_back(center + radii.cwiseProduct(unit));
    }
  }
  for (std::uint32_t ring = 0; ring < kRings; ++ring) {
    for (std::uint32_t k = 0; k < kAround; ++k) {
      const std::uint32_t a = ring * kAround + k, b = ring * kAround + (k + 1) % kAround, c = a + kAround,
                          d = b + kAround;
      mesh.triangles.insert(mesh.triangles.end(), {a, c, b, b, c, d});
    }
  }
  return mesh;
}

inline void append(const MadeUpMesh& part, MadeUpMesh& whole) {
  const auto first = std::uint32_t(whole.positions.size());
  whole.positions.insert(whole.positions.end(), part.positions.begin(), part.positions.end());
  for (const std::uint32_t v : part.triangles) whole.triangles.push_back(first + v);
}

inline importer::SourceModel model_of(MadeUpMesh mesh, const char* name = "body") {
  importer::SourceModel model;
  model.path = "body.glb";
  model.nodes.push_back({name, importer::kNoIndex, Eigen::Affine3d::Identity()});
  importer::SourceMesh part;
  part.name = name;
  part.positions = std::move(mesh.positions);
  part.triangles = std::move(mesh.triangles);
  model.meshes.push_back(std::move(part));
  return model;
}

}  // namespace coif::grow::test
