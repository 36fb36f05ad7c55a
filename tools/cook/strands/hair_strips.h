#pragma once

#include "cook/recipe/patch_override.h"
#include "cook/select/hair_mesh.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace coif::cook {

/// What speaks against the roots that were found, as shares of the hair's area, 0..1.
struct RootDoubts {
  double unsure = 0;             ///< Hardly anything spoke.
  double rises = 0;              ///< Runs up, below the head's centre, of what runs up or down there.
  double rises_above = 0;        ///< The same above it, where hair may be combed up.
  double against_neighbour = 0;  ///< Runs against the hair beside it.
  double against_mirror = 0;     ///< Runs against its mirror image, patch by patch or within a shell.
  double against_ends = 0;       ///< Its own ends say the opposite.

  /// That a person would say the same of most of the hair. Set by hand; tests/corpus/fit_roots.py prints fitted
  /// weights.
  [[nodiscard]] double probability() const;
  /// In plain words, the heaviest first; "nothing speaks against them".
  [[nodiscard]] std::string reason() const;
};

/// The direction of the strands.
struct StrandField {
  std::vector<Eigen::Vector3f> tangent;  ///< Per vertex, unit, root to tip, perpendicular to the normal.
  std::vector<float> place;              ///< Per vertex, 0 root .. 1 tip.
  bool along_u = false;                  ///< Most patches run along U of the texture, not V.
  std::vector<std::uint32_t> unsure;     ///< Numbers of patches with little evidence of their root; ascending.
  RootDoubts doubts;
};

/// The vertices and triangles of one patch.
struct PatchView {
  std::vector<std::size_t> triangles;   ///< First index of each triangle.
  std::vector<std::uint32_t> vertices;  ///< Ascending, each once.
};

/// The recipe's values for some patches.
struct PatchOverrides {
  std::vector<PatchOverride> said;
  /// For each patch, by its number, the overrides that select it, ascending; empty: not determined.
  std::vector<std::vector<std::uint32_t>> of_patch;
};

/// The hair as strips. All its arrays stay consistent: once the patches are found, only the functions below add
/// vertices and regroup triangles. Members of passes that have not run are empty.
struct HairStrips {
  HairMesh mesh;
  std::vector<std::uint32_t> welded;  ///< For each vertex the one that stands for its place (weld_places()).
  PatchSet patches;                   ///< Patches of the mesh's triangles.
  StrandField strands;
  PatchOverrides overrides{};
  bool is_part = false;  ///< Patches were left out.

  /// Every patch's triangles and vertices.
  [[nodiscard]] std::vector<PatchView> views() const;

  /// The recipe's value for one patch, from the last override that has it; null: none.
  template <typename Value>
  [[nodiscard]] const Value* said_of(std::uint32_t patch, std::optional<Value> PatchOverride::*what) const {
    if (overrides.of_patch.empty()) return nullptr;
    const Value* said = nullptr;
    for (const std::uint32_t o : overrides.of_patch[patches.number_of(patch)]) {
      if (const auto& value = overrides.said[o].*what) said = &*value;
    }
    return said;
  }

  /// Leaves out patches (one value for each), and vertices that no other patch has. Call it before strands are known.
  void drop(const std::vector<bool>& dropped);

  /// Gives each patch its own vertices: copies shared ones, with all their data. Returns the original of each vertex
  /// appended.
  std::vector<std::uint32_t> separate_patches();

  /// Replaces normals that are missing or not unit by the mean of the faces around a place, weighted by area. Only
  /// faces in about the same direction as the vertex's own count, since a strip's two sides share places. Returns the
  /// number replaced.
  std::size_t complete_normals();

 private:
  void append_copy(std::uint32_t vertex);
};

/// "patch 3", "patches 1, 2 and 7".
[[nodiscard]] std::string patches_text(std::span<const std::uint32_t> numbers);

/// Twice the area of the triangle whose first index is at `t`, square metres.
[[nodiscard]] float doubled_area(const HairMesh& mesh, std::size_t t);

}  // namespace coif::cook
