#pragma once

#include "cook/hair_mesh.h"

#include <string>

namespace coif {

struct ExtractSettings {
  std::string connectivity = "auto";  ///< "auto", "index" or "position".
  double weld_distance = 1.0e-5;      ///< Metres; for "position".
};

struct ExtractedPatches {
  PatchSet patches;
  std::uint32_t by_index = 0;     ///< Groups of triangles that share vertices.
  std::uint32_t by_position = 0;  ///< Groups of triangles that share places.
  bool chose_position = false;
};

/// Algorithm 2 of the thesis: triangles that share vertices are one patch. Done by union-find, so near-linear where the
/// published form compares each triangle with each group. "auto" takes index groups as the thesis does, unless they
/// average under 8 triangles while groups by position are larger: then the file was exported with split vertices.
[[nodiscard]] ExtractedPatches extract_patches(const HairMesh& mesh, const ExtractSettings& settings);

}  // namespace coif
