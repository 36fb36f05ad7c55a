#pragma once

// What an artist may say about a cook. recipe_keys.cpp holds the one table of keys, defaults and ranges.

#include "base/tool_error.h"
#include "cook/recipe/body_collider.h"
#include "cook/recipe/bone_limit.h"
#include "cook/recipe/chain_links.h"
#include "cook/recipe/hair_style.h"
#include "cook/recipe/patch_override.h"
#include "cook/recipe/recipe_texture.h"

#include <tl/expected.hpp>

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace coif {

/// All values of a recipe. Their defaults and ranges stand in the table of recipe_keys.cpp alone: start from
/// default_recipe().
struct Recipe : HairStyle {
  std::string look_preset;  ///< "none", or what the values began from.
  // scene: what it needs
  bool scene_draw = false;
  bool scene_simulate = false;
  bool scene_names = false;
  bool scene_quality = false;
  bool scene_provenance = false;
  bool scene_shift_mask = false;
  bool scene_relief = false;
  double scene_largest_size = 0;  ///< Share of the viewport's height; 0: any.
  double scene_smallest_size = 0;
  // source
  double metres_per_unit = 0;  ///< 0: from the file.
  std::string up_axis;         ///< "file", "x", "y" or "z".
  std::string source_variant;
  // hair: patterns with * and ?, letters of either case
  std::vector<std::string> hair_meshes;
  std::vector<std::string> hair_materials;
  std::vector<std::string> hair_bones;
  bool hair_brows = false;  ///< And lashes, as far as they are part of the hair.
  bool hair_beard = false;
  // skeleton
  std::string head_bone;  ///< Pattern; "": found by name and hierarchy.
  std::string scalp;      ///< "thesis", "none" or "pattern".
  std::vector<std::string> scalp_bones;
  // cards, where the file has strands
  std::uint32_t cards_triangles = 0;
  std::uint32_t cards_texels = 0;
  std::uint32_t cards_rounds = 0;
  double cards_strand_width = 0;                    ///< Metres; 0: from how many strands there are.
  double cards_caps = 0;                            ///< Share of triangles and texels.
  std::string cards_body;                           ///< Path beside the recipe; "": none.
  std::optional<std::uint32_t> cards_follow_hairs;  ///< None: as the file says.
  double cards_follow_radius = 0;                   ///< Metres; 0: from how far apart the strands are.
  // chains, where the file has no bones
  std::string chain_source;  ///< "auto", "file", "fit" or "none".
  std::uint32_t chain_max_count = 0;
  std::uint32_t chain_max_bones = 0;
  double chain_bone_length = 0;
  double chain_shortest = 0;
  std::vector<std::string> chain_only;
  std::vector<std::string> chain_exclude;
  // patches
  std::string patch_connectivity;  ///< "auto", "island", "index" or "position".
  double patch_widest = 0;         ///< Metres; 0: from the head's size.
  double patch_weld_distance = 0;
  std::vector<std::string> acknowledged_warnings;  ///< Codes of the table of issues.
  std::vector<PatchOverride> patch_overrides;      ///< Where two say different things of a patch, the later one holds.
  // strands
  std::string strand_root;  ///< "auto", "low_u", "high_u", "low_v" or "high_v".
  // dynamics
  std::string dynamics_source;         ///< "auto", "curves" or "springs".
  std::string dynamics_preset;         ///< "natural", "stiff", "heavy", "bouncy" or "wet".
  std::string dynamics_model;          ///< "auto", "cascade" or "passive".
  std::optional<double> liveliness;    ///< 0..1; none: the preset's, or what a resistance or spring has.
  std::vector<CurvePoint> resistance;  ///< Empty: by the preset.
  std::optional<double> friction;      ///< 1/s; none: the preset's, or 2 beside a resistance.
  std::optional<double> air_follow;
  bool sags = false;
  double gravity_scale = 0;
  double authoring_rate = 0;
  std::optional<NumberOrCurve> damping_ratio;  ///< None: as `liveliness` says.
  std::string conditioning;                    ///< "auto" or "off".
  std::optional<double> torsion;               ///< 1/s; none: chosen for each chain.
  double angle_limit = 0;                      ///< Degrees.
  std::vector<RecipeBoneLimit> limits;         ///< Where two are of one bone, the later one holds.
  RecipeLinks links;
  double link_stretch = 0;  ///< Of the distance at rest.
  double link_shrink = 0;
  double parent_share = 0;
  // budget
  double budget_error = 0;  ///< Percent of the chain's length.
  double budget_error_mm = 0;
  double budget_max_error = 0;     ///< Percent of the chain's length.
  double budget_worst_second = 0;  ///< Percent of the chain's length.
  double budget_cost = 0;          ///< Nominal nanoseconds per head and frame.
  double slowest_rate = 0;
  double fastest_rate = 0;
  // head
  std::string head_shape;                            ///< "auto", "ellipsoid", "sphere", "capsule" or "none".
  std::optional<std::array<double, 3>> head_center;  ///< Model space, metres.
  std::optional<std::array<double, 3>> head_radii;
  // body
  bool body_from_file = false;  ///< The file's spring colliders that are not on the head.
  std::vector<RecipeBodyCollider> body_colliders;
  // levels of detail
  std::uint32_t lod_levels = 0;
  double lod_ratio = 0;
  double lod_max_error = 0;
  double lod_pixel_error = 0;
  double lod_still_pixels = 0;
  // draw order
  std::string order_method;  ///< "auto", "head", "single" or "views".
  std::uint32_t order_max = 0;
  std::uint32_t order_max_bytes = 0;
  double order_min_gain = 0;    ///< dB.
  double order_cut_budget = 0;  ///< Share of the triangles.
  std::string order_solver;     ///< "coif", "cascade", "passive" or "thesis".
  // textures
  RecipeTexture base_color_texture;  ///< None: the source's.
  RecipeTexture opacity_texture;     ///< None: the source's.
  RecipeTexture shift_texture;
  RecipeTexture mask_texture;
  RecipeTexture strand_id_texture;
  RecipeTexture root_to_tip_texture;
  std::string vertex_colors;   ///< "auto", "multiply" or "ignore".
  std::string normal_texture;  ///< Path beside the recipe; "": the source's.
  double normal_strength = 0;
  std::string normal_green;  ///< "auto", "up" or "down".
  std::optional<std::uint32_t>
      texture_max_size;  ///< None: texture_limit(), and cards' textures as large as "cards.texels" says.
  std::uint32_t texture_seed = 0;
  std::string shift_mask_format;  ///< "eac" or "rg8".
  // occlusion
  double occlusion_strength = 0;
  // material
  std::array<double, 4> base_color{};
  std::array<double, 3> ambient{};
  std::string sides;            ///< "auto", "both" or "front".
  double opaque_threshold = 0;  ///< 0: chosen from the file and the texture.
  double discard_threshold = 0;
  std::array<double, 3> primary_color{};
  double primary_exponent = 0;
  double primary_shift = 0;
  std::array<double, 3> secondary_color{};
  double secondary_exponent = 0;
  double secondary_shift = 0;
  std::string shading;   ///< A shading model's name.
  double tilt = 0;       ///< Degrees.
  double roughness = 0;  ///< Degrees.
  double scatter = 0;
  double glow = 0;
  double root_shade = 0;
  double variation = 0;
  std::string energy;  ///< "published" or "bounded".
};

/// What the caller of a cook says beside the recipe.
struct CookSettings {
  unsigned threads = 1;                              ///< The result's bytes do not depend on it.
  std::filesystem::path recipe_directory{};          ///< Where texture paths of the recipe start.
  std::uint64_t source_hash = 0;                     ///< XXH64 of the source file, for the provenance record.
  std::function<void(const char* pass)> progress{};  ///< Called before each pass, where set.
  bool list_patches = false;                         ///< Fill in CookResult::patches.
  bool draft = false;                                ///< Cook draft_of() the recipe, and do without what takes long.
};

/// Texels that images may have each way; larger ones are reduced.
[[nodiscard]] inline std::uint32_t texture_limit(const Recipe& recipe) {
  return recipe.texture_max_size.value_or(1024);
}

/// What shows how hair looks and moves, in a fraction of the time: one level of detail, drawn by distance from the head,
/// small textures stored as they come, no occlusion, cards fitted once.
[[nodiscard]] Recipe draft_of(Recipe recipe);

/// Every key at its default.
[[nodiscard]] Recipe default_recipe();

/// What a recipe begins from, whatever it says itself. Empty: as it says.
struct RecipeBeginning {
  std::string preset;  ///< Before its "look.preset".
  std::string style;   ///< Before its "grow.style".
};

/// Reads JSON (with // comments). Unknown keys, wrong types and values out of range are errors that name the key,
/// the range and, for a misspelt key, the nearest one.
/// What a preset ("look.preset", recipe_presets()) says holds where no other key does; so does, in "grow", what a built-in style
/// ("grow.style") says.
tl::expected<Recipe, ToolError> parse_recipe(const std::string& text, const std::string& name,
                                             const RecipeBeginning& beginning = {});
tl::expected<Recipe, ToolError> read_recipe(const std::filesystem::path& path, const RecipeBeginning& beginning = {});

/// Whether a path ends in ".recipe.json": as the source of a cook such a file says itself what hair grows.
[[nodiscard]] bool is_recipe_file(const std::filesystem::path& path);
/// The text of a recipe's file, not looked at yet. kFileAccess where it cannot be read or is too large for one.
tl::expected<std::string, ToolError> read_recipe_text(const std::filesystem::path& path);

/// The complete recipe as JSON with a comment for each key: default, range, unit, meaning. Parses back to `recipe`.
[[nodiscard]] std::string print_recipe(const Recipe& recipe);

/// The same without what was added to comments since: what a recipe's hash is taken of, so that it stays what it was.
[[nodiscard]] std::string canonical_recipe(const Recipe& recipe);

}  // namespace coif
