#pragma once

#include "cook/select/hair_mesh.h"
#include "cook/texture/base_color.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace coif::cook {

/// The triangles that `takes` takes, in pieces that hang together by index; pieces and triangles in the order of the
/// mesh.
[[nodiscard]] std::vector<std::vector<std::size_t>> color_islands(const HairMesh& hair,
                                                                  const std::function<bool(std::size_t)>& takes);

struct DrawnRecipe;

// The runtime has no vertex colours: they become factors or part of the texture, so that hair without them costs
// nothing extra.

/// Takes `hair.colors` away where the recipe ignores them, or where they are all black or all clear and the recipe does
/// not insist: such are numbers for a program (wind, masks), not colours.
void judge_vertex_colors(const DrawnRecipe& recipe, HairMesh& hair, Findings& findings);

/// Prepares looks for bake_vertex_colors(). A look with one colour gets it as its factor. If strips show the same
/// texels in different colours, the look becomes several looks of the same image, so that each gets its own texels in
/// an atlas. Strips are connected by index. Reports how often an image is stored, with a warning where `max_size` makes
/// copies smaller. Without texture coordinates looks become one, whose factors are in the colours.
void split_by_vertex_colors(SurfaceLooks& looks, HairMesh& hair, std::uint32_t max_size, Findings& findings);

/// Puts the hair's colours that split_by_vertex_colors() left into the image, reduced to `max_size`. Runs long after
/// the image was found: strands are found from painted texels, not from the tint of vertices.
void keep_vertex_colors(std::uint32_t max_size, BaseColor& color, HairMesh& hair, Findings& findings);

/// Multiplies the image with the colours of the triangles that show it, and takes them from `hair`. A warning where
/// triangles still share texels that they have in different colours: those get the mean.
void bake_vertex_colors(Image& image, HairMesh& hair, Findings& findings);

/// For hair without texture coordinates: an image of its colours, and coordinates into it. Colours of one strip usually
/// vary in a plane of RGBA (from root to tip, and from side to side), which a square shows exactly; strips whose planes
/// differ get squares of their own. Removes the colours from `hair`.
[[nodiscard]] Image make_color_squares(HairMesh& hair, Findings& findings);

}  // namespace coif::cook
