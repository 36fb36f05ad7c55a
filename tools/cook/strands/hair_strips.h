#pragma once

#include "cook/recipe/patch_override.h"
#include "cook/select/hair_mesh.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace coif::cook {

/// Where the strands run.
struct StrandField {
  std::vector<Eigen::Vector3f> tangent;  ///< Per vertex, unit, root to tip, perpendicular to the normal.
  std::vector<float> place;              ///< Per vertex, 0 root .. 1 tip.
  bool along_u = false;                  ///< In the texture most patches run along U, not V.
  std::vector<std::uint32_t> unsure;     ///< Numbers of patches of which little tells which end is the root; ascending.
};

/// What belongs to one patch.
struct PatchView {
  std::vector<std::size_t> triangles;   ///< First index of each.
  std::vector<std::uint32_t> vertices;  ///< Ascending, each once.
};

/// What the recipe says of some patches alone.
struct PatchOverrides {
  std::vector<PatchOverride> said;
  /// For each patch, by its number, which of them select it, ascending; empty: none was looked for.
  std::vector<std::vector<std::uint32_t>> of_patch;
};

/// The hair as strips. What is known of its vertices and triangles keeps in step: once the patches are found, vertices
/// are added and triangles regrouped by the functions below alone. What no pass has found yet is empty.
struct HairStrips {
  HairMesh mesh;
  std::vector<std::uint32_t> welded;  ///< For each vertex the one that stands for its place (weld_places()).
  PatchSet patches;                   ///< Of the mesh's triangles.
  StrandField strands;
  PatchOverrides overrides{};
  bool is_part = false;  ///< Patches were left out.

  /// Every patch's triangles and vertices.
  [[nodiscard]] std::vector<PatchView> views() const;

  /// What the recipe says of one patch alone, the last override that says it; null: nothing.
  template <typename Value>
  [[nodiscard]] const Value* said_of(std::uint32_t patch, std::optional<Value> PatchOverride::*what) const {
    if (overrides.of_patch.empty()) return nullptr;
    const Value* said = nullptr;
    for (const std::uint32_t o : overrides.of_patch[patches.number_of(patch)]) {
      if (const auto& value = overrides.said[o].*what) said = &*value;
    }
    return said;
  }

  /// Leaves out patches (one value for each), and vertices that no other has. Before strands are known.
  void drop(const std::vector<bool>& dropped);

  /// Gives each patch its own vertices: copies those that several share, with all that is known of them. Returns, for
  /// each vertex appended, which it equals.
  std::vector<std::uint32_t> separate_patches();

  /// Fills in normals that are missing or not unit: the mean of the faces around a place, weighted by area, as far as
  /// they look the same way as the vertex's own faces (a strip's two sides share places). Returns how many there were.
  std::size_t complete_normals();

 private:
  void append_copy(std::uint32_t vertex);
};

/// "patch 3", "patches 1, 2 and 7".
[[nodiscard]] std::string patches_text(std::span<const std::uint32_t> numbers);

/// Twice the area of the triangle whose first index is at `t`, square metres.
[[nodiscard]] float doubled_area(const HairMesh& mesh, std::size_t t);

}  // namespace coif::cook
