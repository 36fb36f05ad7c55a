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

// Nothing at run time knows vertex colours: what they say goes into the factor or the texture, so that hair without
// them pays nothing.

/// Takes `hair.colors` away where the recipe ignores them, or where they are all black or all clear and the recipe does
/// not insist: such are numbers for a program (wind, masks), not colours.
void judge_vertex_colors(const DrawnRecipe& recipe, HairMesh& hair, Findings& findings);

/// Readies looks for bake_vertex_colors(). A look of one colour gets it as its factor. Where strips show the same
/// texels in different colours, the look becomes several of the same image, so that each gets texels of its own in an
/// atlas. Strips hang together by index. Says how often an image is stored, with a warning where `max_size` makes
/// copies smaller. Without texture coordinates looks become one, whose factors are in the colours.
void split_by_vertex_colors(SurfaceLooks& looks, HairMesh& hair, std::uint32_t max_size, Findings& findings);

/// Puts the hair's colours, of which split_by_vertex_colors() left some, into the image, reduced to `max_size`. Long
/// after the image was found: how strands run shows in what is painted, not in how vertices are tinted.
void keep_vertex_colors(std::uint32_t max_size, BaseColor& color, HairMesh& hair, Findings& findings);

/// Multiplies the image with the colours of the triangles that show it, and takes them from `hair`. A warning where
/// triangles still share texels that they have in different colours: those get the mean.
void bake_vertex_colors(Image& image, HairMesh& hair, Findings& findings);

/// For hair without texture coordinates: an image of its colours, and coordinates into it. Colours of one strip vary in
/// a plane of RGBA as a rule (from root to tip, and from side to side), which a square shows exactly; strips whose
/// planes differ get squares of their own. Takes the colours from `hair`.
[[nodiscard]] Image make_color_squares(HairMesh& hair, Findings& findings);

}  // namespace coif::cook
