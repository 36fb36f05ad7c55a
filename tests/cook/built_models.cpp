#include "cook/built_models.h"

#include "cook/recipe/recipe.h"
#include "cook/select/select_hair.h"
#include "cook/select/triangle_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace coif::cook {

importer::SourceMesh make_strip(const StripDesc& desc) {
  importer::SourceMesh mesh;
  mesh.name = "hair";
  for (std::uint32_t row = 0; row <= desc.rows; ++row) {
    const float t = float(row) / float(desc.rows);
    const Eigen::Vector3f across = desc.across * (1 + t * (desc.tip_width - 1));
    for (int side = 0; side < 2; ++side) {
      mesh.positions.push_back(desc.root + desc.along * t + across * (float(side) - 0.5f));
      const float v = desc.v_upwards ? 1 - t : t;
      mesh.uvs.push_back(desc.uv_sideways ? Eigen::Vector2f(v, float(side)) : Eigen::Vector2f(float(side), v));
    }
  }
  for (std::uint32_t row = 0; row < desc.rows; ++row) {
    const std::uint32_t a = 2 * row;
    mesh.triangles.insert(mesh.triangles.end(), {a, a + 2, a + 1, a + 1, a + 2, a + 3});
  }
  return mesh;
}

importer::SourceMesh make_cap(std::uint32_t columns, std::uint32_t rows, float turn, float radius) {
  importer::SourceMesh mesh;
  mesh.name = "hair";
  for (std::uint32_t row = 0; row <= rows; ++row) {
    const float t = 2 * float(row) / float(rows), down = 0.1f + 1.47f * std::min(t, 1.0f);
    const float hanging = 1.5f * radius * std::max(t - 1, 0.0f);
    for (std::uint32_t column = 0; column <= columns; ++column) {
      const float u = float(column) / float(columns), around = turn * u;
      mesh.positions.emplace_back(radius * std::sin(down) * std::cos(around), 1.6f + radius * std::cos(down) - hanging,
                                  radius * std::sin(down) * std::sin(around));
      mesh.uvs.emplace_back(u, float(row) / float(rows));
    }
  }
  const std::uint32_t width = columns + 1;
  for (std::uint32_t row = 0; row < rows; ++row) {
    for (std::uint32_t column = 0; column < columns; ++column) {
      const std::uint32_t a = row * width + column, b = a + width;
      mesh.triangles.insert(mesh.triangles.end(), {a, a + 1, b, b, a + 1, b + 1});
    }
  }
  return mesh;
}

void append_piece(importer::SourceMesh& mesh, const importer::SourceMesh& part, std::uint32_t node) {
  const auto base = std::uint32_t(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
  mesh.uvs.insert(mesh.uvs.end(), part.uvs.begin(), part.uvs.end());
  for (std::uint32_t index : part.triangles) mesh.triangles.push_back(base + index);
  if (mesh.influence_begin.empty()) return;
  for (std::size_t v = 0; v < part.positions.size(); ++v) {
    mesh.influences.push_back({node, 1.0f});
    mesh.influence_begin.push_back(std::uint32_t(mesh.influences.size()));
  }
}

HairMesh hair_from(const importer::SourceMesh& source) {
  HairMesh mesh;
  mesh.positions = source.positions;
  mesh.uvs = source.uvs;
  mesh.normals = source.normals;
  mesh.triangles = source.triangles;
  mesh.influences.assign(source.positions.size(), {0, 1.0f});
  for (std::uint32_t v = 0; v <= source.positions.size(); ++v) mesh.influence_begin.push_back(v);
  return mesh;
}

void split_vertices(importer::SourceMesh& mesh) {
  importer::SourceMesh split = mesh;
  split.positions.clear();
  split.uvs.clear();
  split.normals.clear();
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::size_t t = i / 3 * 3;
    const Eigen::Vector3f& a = mesh.positions[mesh.triangles[t]];
    const Eigen::Vector3f face =
        (mesh.positions[mesh.triangles[t + 1]] - a).cross(mesh.positions[mesh.triangles[t + 2]] - a);
    split.positions.push_back(mesh.positions[mesh.triangles[i]]);
    split.uvs.push_back(mesh.uvs[mesh.triangles[i]]);
    split.normals.push_back(face.normalized());
    split.triangles[i] = std::uint32_t(i);
  }
  mesh = split;
}

std::uint32_t add_node(importer::SourceModel& model, const std::string& name, std::uint32_t parent,
                       const Eigen::Vector3d& at) {
  importer::SourceNode node;
  node.name = name;
  node.parent = parent;
  node.model_from_node.translation() = at;
  model.nodes.push_back(node);
  return std::uint32_t(model.nodes.size() - 1);
}

importer::SourceModel make_spine() {
  importer::SourceModel model;
  add_node(model, "Hips", importer::kNoIndex, {0, 1, 0});
  add_node(model, "Neck", 0, {0, 1.48, 0});
  add_node(model, "Head", 1, {0, 1.555, -0.015});
  add_node(model, "Mesh", 2, {0, 0, 0});
  return model;
}

importer::SourceMesh make_shell(double radius, double low, double high, double open) {
  constexpr std::uint32_t kRows = 12, kColumns = 36;
  importer::SourceMesh mesh;
  for (std::uint32_t row = 0; row <= kRows; ++row) {
    const double y = low + (high - low) * row / kRows, across = std::sqrt(1 - y * y);
    for (std::uint32_t column = 0; column <= kColumns; ++column) {
      const double turn = 2 * std::numbers::pi * (open / 2 + (1 - open) * column / kColumns);
      const Eigen::Vector3d at(across * std::sin(turn), y, across * std::cos(turn));
      mesh.positions.push_back((Eigen::Vector3d(0, 1.65, 0) + radius * at).cast<float>());
    }
  }
  for (std::uint32_t row = 0; row < kRows; ++row) {
    for (std::uint32_t column = 0; column < kColumns; ++column) {
      const std::uint32_t a = row * (kColumns + 1) + column, b = a + kColumns + 1;
      mesh.triangles.insert(mesh.triangles.end(), {a, a + 1, b, b, a + 1, b + 1});
    }
  }
  return mesh;
}

importer::SourceModel make_wig() {
  importer::SourceModel model;
  model.path = "wig.glb";
  add_node(model, "root", importer::kNoIndex, {0, 0, 0});
  const std::uint32_t head = add_node(model, "Head", 0, {0, 1.6, 0});
  const std::uint32_t scalp = add_node(model, "scalp", head, {0, 1.65, -0.1});
  const std::uint32_t hair1 = add_node(model, "hair_1", scalp, {0, 1.6, -0.1});
  const std::uint32_t hair2 = add_node(model, "hair_2", hair1, {0, 1.5, -0.1});
  add_node(model, "hair_2_end", hair2, {0, 1.4, -0.1});

  importer::SourceMesh mesh =
      make_strip({.root = {0, 1.65f, -0.1f}, .along = {0, -0.25f, 0}, .tip_width = 0.4f, .rows = 5});
  mesh.node = head;
  mesh.influence_begin.push_back(0);
  for (const Eigen::Vector3f& p : mesh.positions) {
    const std::uint32_t node = p.y() > 1.599f ? scalp : p.y() > 1.499f ? hair1 : hair2;
    mesh.influences.push_back({node, 1.0f});
    mesh.influence_begin.push_back(std::uint32_t(mesh.influences.size()));
  }
  model.meshes.push_back(mesh);
  return model;
}

importer::SourceMesh strip_over(const Eigen::Vector2f& low, const Eigen::Vector2f& high) {
  importer::SourceMesh mesh = make_strip({});
  for (Eigen::Vector2f& uv : mesh.uvs) uv = low + uv.cwiseProduct(high - low);
  return mesh;
}

importer::SourceMaterial& add_surface(importer::SourceModel& model, const std::string& material,
                                      const Eigen::Vector2f& low, const Eigen::Vector2f& high) {
  if (model.nodes.empty()) add_node(model, "Head", importer::kNoIndex, {0, 1.6, 0});
  importer::SourceMesh mesh = strip_over(low, high);
  for (Eigen::Vector3f& p : mesh.positions) p.x() += 0.1f * float(model.meshes.size());
  mesh.material = std::uint32_t(model.materials.size());
  model.meshes.push_back(mesh);
  model.materials.emplace_back();
  model.materials.back().name = material;
  return model.materials.back();
}

HairMesh whole_hair(const importer::SourceModel& model) {
  const auto selected = select_hair(model, default_recipe(), unheard());
  EXPECT_TRUE(selected) << (selected ? "" : selected.error().message);
  return selected ? *selected : HairMesh{};
}

HairStrips strips_from(HairMesh mesh, PatchSet patches) {
  if (patches.count == 0 && !mesh.triangles.empty()) {
    patches = {std::vector<std::uint32_t>(mesh.triangle_count(), 0), 1};
  }
  std::vector<std::uint32_t> welded = weld_places(mesh.positions, 0);
  return {std::move(mesh), std::move(welded), std::move(patches), {}};
}

importer::SourceMesh make_card(const CardDesc& desc) {
  importer::SourceMesh mesh;
  mesh.name = "hair";
  for (std::uint32_t row = 0; row <= desc.rows; ++row) {
    for (std::uint32_t column = 0; column <= desc.columns; ++column) {
      const float u = float(column) / float(desc.columns), v = float(row) / float(desc.rows);
      const float angle = desc.bend_radius > 0 ? v * desc.length / desc.bend_radius : 0;
      const float down = desc.bend_radius > 0 ? desc.bend_radius * std::sin(angle) : v * desc.length;
      const float out = desc.bend_radius > 0 ? desc.bend_radius * (1 - std::cos(angle)) : 0;
      mesh.positions.push_back(desc.root + Eigen::Vector3f((u - 0.5f) * desc.width, -down, -out));
      mesh.uvs.emplace_back(u, v);
    }
  }
  const std::uint32_t stride = desc.columns + 1;
  for (std::uint32_t row = 0; row < desc.rows; ++row) {
    for (std::uint32_t column = 0; column < desc.columns; ++column) {
      const std::uint32_t a = row * stride + column;
      mesh.triangles.insert(mesh.triangles.end(), {a, a + stride, a + 1, a + 1, a + stride, a + stride + 1});
    }
  }
  return mesh;
}

void append_card(const importer::SourceMesh& card, importer::SourceMesh& mesh) {
  const auto first = std::uint32_t(mesh.positions.size());
  mesh.name = card.name;
  mesh.positions.insert(mesh.positions.end(), card.positions.begin(), card.positions.end());
  mesh.uvs.insert(mesh.uvs.end(), card.uvs.begin(), card.uvs.end());
  for (std::uint32_t v : card.triangles) mesh.triangles.push_back(first + v);
}

PatchSurface surface_of(const HairMesh& mesh, std::span<const Pose> poses) {
  HairStrips hair = strips_from(mesh);
  hair.welded = weld_places(mesh.positions, 1.0e-6);
  return make_patch_surface(hair, hair.views()[0], poses);
}

std::vector<std::uint32_t> after(const HairMesh& mesh, const PatchSurface& surface, const CollapseSequence& sequence,
                                 std::size_t steps) {
  return collapsed_triangles(surface, sequence, steps, mesh.triangles);
}

double distance_from(const HairMesh& mesh, std::span<const std::uint32_t> triangles, const Eigen::Vector3f& point) {
  const auto corner = [&](std::size_t i) -> Eigen::Vector3d { return mesh.positions[triangles[i]].cast<double>(); };
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    nearest = std::min(nearest, squared_distance(point.cast<double>(), corner(i), corner(i + 1), corner(i + 2)));
  }
  return std::sqrt(nearest);
}

}  // namespace coif::cook
