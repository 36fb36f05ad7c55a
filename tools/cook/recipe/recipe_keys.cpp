#include "cook/recipe/recipe_keys.h"

#include "base/hair_runtime.h"
#include "cook/recipe/recipe_preset.h"

namespace coif::cook {
namespace {

using R = Recipe;

constexpr bool kNamesFile = true, kIsLater = true;
// clang-format off
constexpr const char* kOrChannel = "; or {\"file\": ..., \"channel\": \"r\", \"g\", \"b\", \"a\" or \"luminance\", \"invert\": true}";

const RecipeKey kCookKeys[] = {
  {"scene", "draw", &R::scene_draw, "true", 0, 0, nullptr, "",
   "false: the hair is simulated but never drawn from this asset; leaves mesh, material and textures out"},
  {"scene", "simulate", &R::scene_simulate, "true", 0, 0, nullptr, "",
   "false: the hair is rigid with the head; leaves bones and dynamics out"},
  {"scene", "names", &R::scene_names, "true", 0, 0, nullptr, "", "false: nothing looks for a bone by its name"},
  {"scene", "quality", &R::scene_quality, "true", 0, 0, nullptr, "",
   "false: nothing asks what other settings than the chosen would cost"},
  {"scene", "provenance", &R::scene_provenance, "true", 0, 0, nullptr, "",
   "false: nothing asks what the asset was made from"},
  {"scene", "shift_mask", &R::scene_shift_mask, "true", 0, 0, nullptr, "",
   "false: highlights are smooth, without the texture that moves and masks them"},
  {"scene", "relief", &R::scene_relief, "true", 0, 0, nullptr, "",
   "false: strips are lit by their own form alone, without the maps of normals and strands"},
  {"scene", "largest_size", &R::scene_largest_size, "0", 0, 100, nullptr, "screens",
   "most of the screen's height that the head ever covers; leaves finer levels of detail out; 0: any"},
  {"scene", "smallest_size", &R::scene_smallest_size, "0", 0, 100, nullptr, "screens",
   "least of the screen's height that the head ever covers; leaves coarser levels of detail out"},

  {"warnings", "acknowledged", &R::acknowledged_warnings, "[]", 0, 0, nullptr, "",
   "codes of warnings that are meant to be so, such as \"C144\": they are told as notes and fail no build; 'coif validate --list-codes' lists them",
   "", false, nullptr, false, false},

  {"look", "preset", &R::look_preset, "\"none\"", 0, 0, kPresetWords, "",
   "which preset all other keys begin from, those that are given here go before it; 'coif cook --list-presets' says what they are for"},

  {"source", "metres_per_unit", &R::metres_per_unit, "0", 0, 1000, nullptr, "m",
   "size of the file's unit; 0 takes the file's own, unless the model's size speaks clearly for another; OBJ has none"},
  {"source", "up_axis", choice_of<&R::up_axis>, "\"file\"", 0, 0, "file|x|y|z", "",
   "axis that points up in the file; file: the one it says, unless bones and hair speak clearly for another"},
  {"source", "variant", &R::source_variant, "\"\"", 0, 0, nullptr, "",
   "which look of a glTF with KHR_materials_variants, by its name; empty: the materials that its meshes have", "", false, nullptr, kIsLater},

  {"hair", "meshes", &R::hair_meshes, "[]", 0, 0, nullptr, "", "names of the meshes that are hair; * and ? are wildcards; all empty: whatever is called hair, else everything"},
  {"hair", "materials", &R::hair_materials, "[]", 0, 0, nullptr, "",
   "names of the materials that are hair; with meshes given too, both must match"},
  {"hair", "bones", &R::hair_bones, "[]", 0, 0, nullptr, "",
   "names of hair bones; connected pieces that they move are hair, to cut hair out of a merged body"},
  {"hair", "parts", &R::hair_parts, "[]", 0, 0, nullptr, "m", "points on parts that are hair, beside what is named; 'coif cook SOURCE --list candidates' prints one of each", "", false, nullptr, kIsLater},
  {"hair", "brows", &R::hair_brows, "true", 0, 0, nullptr, "",
   "false: brows and lashes among the hair are left out; the cook says which patches they are"},
  {"hair", "beard", &R::hair_beard, "true", 0, 0, nullptr, "",
   "false: a beard or moustache among the hair is left out, where its mesh or material is called so"},

  {"skeleton", "head", &R::head_bone, "\"\"", 0, 0, nullptr, "",
   "name of the head bone; empty: found by its name above the hair bones"},
  {"skeleton", "scalp", choice_of<&R::scalp>, "\"thesis\"", 0, 0, "thesis|none|pattern", "",
   "rigid bones: 'thesis' the first bone of each chain below the head, 'none', or 'pattern' those in scalp_bones"},
  {"skeleton", "scalp_bones", &R::scalp_bones, "[]", 0, 0, nullptr, "",
   "names of the bones that stay rigid with the head, where scalp is 'pattern'"},

  {"cards", "triangles", &R::cards_triangles, "8000", 2, 1000000, nullptr, "triangles",
   "where the file has strands instead of strips: what the cards that are made of them may have"},
  {"cards", "texels", &R::cards_texels, "1835008", 4096, 67108864, nullptr, "texels", "what their texture may have, all cards together"},
  {"cards", "wisps", &R::cards_wisps, "null", 0, 1024, nullptr, "textures",
   "how many textures of strands all cards share: the fewer, the more finely strands are drawn on each, and the more cards look alike; 0: each card has its own; null: its own if strands are wide enough to be seen there, else some hundred"},
  {"cards", "rounds", &R::cards_rounds, "6", 0, 100, nullptr, "rounds",
   "how often cards are compared with the strands from 32 directions and made more like them, at most: it ends where that gains little; with 2 or more also how many quads a card has, and how cards are cut, are chosen by such pictures"},
  {"cards", "strand_width", &R::cards_strand_width, "0", 0, 0.1, nullptr, "m",
   "how wide a strand is where the file does not say; 0: so wide that the strands cover what all hair of a head does"},
  {"cards", "caps", &R::cards_caps, "0.04", 0, 0.5, nullptr, "",
   "share of triangles and texels, at most, of cards that lie on the scalp and hide the skin between roots; 0: none"},
  {"cards", "body", &R::cards_body, "\"\"", 0, 0, nullptr, "",
   "model of the head and body that strands belong to, which come without, and that hair grows on; path from the recipe", "", kNamesFile},
  {"cards", "follow_hairs", &R::cards_follow_hairs, "null", 0, 64, nullptr, "strands",
   "made up around each strand of the file, where these are guides; null: as many as the file asks for (TressFX)"},
  {"cards", "follow_radius", &R::cards_follow_radius, "0", 0, 0.1, nullptr, "m",
   "how far from it; 0: as far as they need to cover the scalp between the file's strands"},

  {"chains", "source", choice_of<&R::chain_source>, "\"auto\"", 0, 0, "auto|file|fit|none", "",
   "where moving bones come from: the file, fitted to the hair, or neither; auto: fitted where the file has none"},
  {"chains", "max_count", &R::chain_max_count, "16", 1, 128, nullptr, "chains",
   "most chains that are fitted"},
  {"chains", "max_bones", &R::chain_max_bones, "6", 1, 64, nullptr, "bones",
   "most bones of a fitted chain"},
  {"chains", "bone_length", &R::chain_bone_length, "0.06", 0.001, 10, nullptr, "m",
   "length that a fitted bone should have; on a head of more than 12 cm radius longer in proportion"},
  {"chains", "shortest", &R::chain_shortest, "0.06", 0, 10, nullptr, "m",
   "hair that hangs free for less than this gets no chain; on a head of more than 12 cm radius longer in proportion"},
  {"chains", "only", &R::chain_only, "[]", 0, 0, nullptr, "",
   "names of the meshes or materials that get fitted chains; empty: all"},
  {"chains", "exclude", &R::chain_exclude, "[]", 0, 0, nullptr, "",
   "names of the meshes or materials that stay rigid with the head"},

  {"patches", "connectivity", choice_of<&R::patch_connectivity>, "\"auto\"", 0, 0, "auto|island|index|position", "",
   "triangles are one patch when they share a texture island, vertices (index) or places; auto: what does not shatter"},
  {"patches", "widest", &R::patch_widest, "0", 0, 100, nullptr, "m",
   "patches wider than this across their strands are cut along them; 0: three quarters of the head's radius"},
  {"patches", "weld_distance", &R::patch_weld_distance, "0", 0, 0.01, nullptr, "m",
   "vertices closer than this are at one place; 0: a 50,000th of the hair's size"},
  {"patches", "overrides", &R::patch_overrides, "[]", 0, 0, nullptr, "",
   "what holds for some patches alone: {\"select\": {mesh, material, island, index, box, near, within}, \"keep\", \"root\","
   " \"chain\", \"resistance\", ...}; 'coif cook SOURCE --list patches -o PICTURE.png' numbers them"},

  {"strands", "root", &R::strand_root, "\"auto\"", 0, 0, "auto|low_u|high_u|low_v|high_v", "",
   "side of the texture where the roots are; auto: found for each patch ('coif render --component direction' shows it)"},

  {"dynamics", "source", choice_of<&R::dynamics_source>, "\"auto\"", 0, 0, "auto|curves|springs", "",
   "auto: the file's spring bones (VRM) where a bone has one, else the curve and numbers here; springs: the same, and a"
   " warning where one is missing; curves: never the file's"},
  {"dynamics", "preset", &R::dynamics_preset, "\"natural\"", 0, 0, "natural|stiff|heavy|bouncy|wet", "",
   "what hair it is, where neither the file nor \"resistance\" says how it moves: how long it has to be to hang, and how it swings"},
  {"dynamics", "liveliness", &R::liveliness, "null", 0, 1, nullptr, "",
   "0: no bone swings past where it rests, 1: only the air stops it; null: the preset's, or what a resistance or spring brings"},
  {"dynamics", "model", choice_of<&R::dynamics_model>, "\"auto\"", 0, 0, "auto|cascade|passive", "",
   "passive: bones hold back the one before, which soft hair needs to swing; cascade: they do not, at half the price; auto:"
   " passive for presets; for springs and resistances cascade, unless hair that soft would have to be damped as one"},
  {"dynamics", "resistance", &R::resistance, "[]", 0, 1, nullptr, "per step",
   "pull to the modelled pose, points [place along the chain from root 0 to tip 1, value 0..1]; none: as the preset says"},
  {"dynamics", "friction", &R::friction, "null", 0, 1.0e4, nullptr, "1/s",
   "how fast hair takes on the velocity of the air; null: the preset's, or 2 beside a resistance"},
  {"dynamics", "air_follow", &R::air_follow, "null", 0, 1, nullptr, "",
   "share of the head's velocity that the air around it takes on: 1: a head that runs steadily leaves its hair alone, 0: hair"
   " streams back in the world's air; null: 0.5 for presets, 0 for springs, 1 beside a resistance"},
  {"dynamics", "sags", &R::sags, "false", 0, 0, nullptr, "",
   "true: the modelled pose is that of hair without weight, and hair sags from it; false: an upright head wears it as modelled;"
   " the file's springs sag as they say"},
  {"dynamics", "gravity_scale", &R::gravity_scale, "1", -100, 100, nullptr, "",
   "share of the scene's gravity that hair feels; 0 keeps the modelled pose at rest"},
  {"dynamics", "authoring_rate", &R::authoring_rate, "60", 1, 1000, nullptr, "1/s",
   "frame rate at which the resistance was tuned"},
  {"dynamics", "damping_ratio", &R::damping_ratio, "null", 0, 10, nullptr, "",
   "the same as a share of what would keep a bone from swinging past its pose, the air's friction included; null: as"
   " \"liveliness\" says", "; one number, or points [place along the chain from root 0 to tip 1, value 0..10]"},
  {"dynamics", "conditioning", choice_of<&R::conditioning>, "\"auto\"", 0, 0, "auto|off", "",
   "auto: where a chain's motion would not be the same twice, damps it, by what changes it least, and says so; off: never"},
  {"dynamics", "torsion", &R::torsion, "null", 0, 1.0e6, nullptr, "1/s",
   "how fast a twist of a bone against its parent goes back; 1e6: there never is one; null: 20 for chains that fold back"
   " over themselves in some motion, never one for others"},
  {"dynamics", "angle_limit", &R::angle_limit, "180", 0, 180, nullptr, "degrees",
   "how far a bone may bend from its modelled direction; 180: any way"},
  {"dynamics", "limits", &R::limits, "[]", 0, 0, nullptr, "",
   "which directions single bones may have, about the modelled one: {\"bones\": names, \"kind\": \"cone\", \"hinge\", \"spherical\" or"
   " \"none\", \"angle\" and \"yaw\" in degrees, \"axis\": what a hinge turns about}; before the file's own (VRM 1.0)"},
  {"dynamics", "links", &R::links, "\"none\"", 0, 0, nullptr, "",
   "which chains stay beside each other, so that strips that hang on two are not torn: \"none\"; \"shared_strips\", those that a strip"
   " hangs on together; or pairs of bones' names, [[\"left_1\", \"middle_1\"], ...], each standing for its chain, * and ? are wildcards"},
  {"dynamics", "link_stretch", &R::link_stretch, "0.1", 0, 1, nullptr, "",
   "how much farther apart than modelled linked bones may get, as a share of their distance"},
  {"dynamics", "link_shrink", &R::link_shrink, "0.5", 0, 1, nullptr, "",
   "how much closer together than modelled, as a share of their distance"},
  {"dynamics", "parent_share", &R::parent_share, "1", 0, 1, nullptr, "",
   "share of the pull to the modelled pose that turns with the bone before; the rest turns with the head"},

  {"budget", "error", &R::budget_error, "0", 0, 100, nullptr, "% of length",
   "largest RMS error of the hair's tips against the exact motion; sub-steps are chosen to keep it, exit code 4 where none do; 0: 0.7 at 60 frames a second and more, up to 2 at fewer or where it takes more than 240 steps a second, if it can be had"},
  {"budget", "error_mm", &R::budget_error_mm, "0", 0, 1000, nullptr, "mm",
   "the same as a length; with both, both are kept"},
  {"budget", "max_error", &R::budget_max_error, "0", 0, 100, nullptr, "% of length",
   "the same for the tip and the frame that are furthest off; 0: any"},
  {"budget", "worst_second", &R::budget_worst_second, "0", 0, 100, nullptr, "% of length",
   "the same for the RMS over the worst second of each motion; 0: any"},
  {"budget", "ns_per_frame", &R::budget_cost, "0", 0, 1.0e9, nullptr, "ns",
   "most that a head may cost per frame, in nominal nanoseconds; 0: any"},
  {"budget", "slowest_rate", &R::slowest_rate, "30", 10, 1000, nullptr, "1/s",
   "lowest frame rate at which the budget holds"},
  {"budget", "fastest_rate", &R::fastest_rate, "120", 10, 1000, nullptr, "1/s",
   "highest frame rate at which the budget holds"},
  {"head", "shape", choice_of<&R::head_shape>, "\"auto\"", 0, 0, "auto|ellipsoid|sphere|capsule|none", "",
   "what hair stays out of; auto: the file's spring colliders on the head, else an ellipsoid"},
  {"head", "faces", choice_of<&R::head_faces>, "\"auto\"", 0, 0, "auto|+Z|-Z", "",
   "where the model looks once +Y is up; auto: where joints of eyes and toes, or the hair, show it"},
  {"head", "center", &R::head_center, "null", -1000, 1000, nullptr, "m",
   "centre of the head in the model, metres, Y up; null: fitted"},
  {"head", "radii", &R::head_radii, "null", 0.001, 1000, nullptr, "m",
   "half sizes of the head along X, Y, Z; null: fitted"},
  {"body", "from_file", &R::body_from_file, "true", 0, 0, nullptr, "",
   "false: the file's spring colliders (VRM) that are not on the head are left out"},
  {"body", "colliders", &R::body_colliders, "[]", 0, 0, nullptr, "",
   "what else hair stays out of, on bones that the game moves: {\"bone\": name, \"center\", \"radius\", \"tail\", \"tail_radius\","
   " \"normal\", \"inside\", \"hair\": bones that may touch it}; in the model at rest, metres, Y up"},

  {"lods", "levels", &R::lod_levels, "3", 1, 8, nullptr, "levels",
   "levels of detail at most, the finest included; fewer where a coarser one would save little; of strands each has its own cards"},
  {"lods", "ratio", &R::lod_ratio, "0.5", 0.05, 0.95, nullptr, "",
   "triangles of a level, as a share of the next finer one's"},
  {"lods", "max_error", &R::lod_max_error, "0.01", 0, 10, nullptr, "m",
   "simplified hair stays this close to the finest, and dropped hair lies this close to other hair that stays"},
  {"lods", "pixel_error", &R::lod_pixel_error, "1", 0.01, 1000, nullptr, "pixels",
   "largest error on a screen of 1080 lines, of cards its root mean square; decides from which size on a level is drawn"},
  {"lods", "still_pixels", &R::lod_still_pixels, "24", 0, 10000, nullptr, "pixels",
   "on such a screen hair of a coarser level that hangs free for less than this is rigid"},

  {"order", "method", choice_of<&R::order_method>, "\"auto\"", 0, 0, "auto|head|single|views", "",
   "how blended hair is sorted: by distance from the head, in the best single order of patches, or in orders of triangles for"
   " directions to look from; auto: what comes closest to the exact picture, but by distance above 250000 triangles"},
  {"order", "max_orders", &R::order_max, "8", 1, 32, nullptr, "orders",
   "most draw orders, the one for all directions included"},
  {"order", "max_bytes", &R::order_max_bytes, "786432", 0, 4294967295.0, nullptr, "bytes",
   "most that further orders take in the asset, 4 bytes for each triangle and order; fewer orders where they would take more"},
  {"order", "min_gain", &R::order_min_gain, "0.5", 0, 100, nullptr, "dB",
   "with method auto orders for directions must be better by this than the best single one"},
  {"order", "cut_budget", &R::order_cut_budget, "0.1", 0, 1, nullptr, "",
   "most triangles that cutting those of soft hair where they cross may add, as a share of all; 0: none is cut"},
  {"order", "solver", &R::order_solver, "\"coif\"", 0, 0, "coif|cascade|passive|thesis", "",
   "which of the runtime's solvers moves the hair in the poses that orders are searched in: the one that the game will run"},

  {"textures", "base_color", &R::base_color_texture, "\"\"", 0, 0, nullptr, "",
   "image with colour and alpha, path from the recipe; empty: the source's own", kOrChannel, kNamesFile},
  {"textures", "opacity", &R::opacity_texture, "\"\"", 0, 0, nullptr, "",
   "image whose numbers are the hair's alpha, path from the recipe; empty: the source's own", kOrChannel, kNamesFile, nullptr, kIsLater},
  {"textures", "shift", &R::shift_texture, "\"\"", 0, 0, nullptr, "",
   "image whose red moves both highlights along the strand; empty: generated", kOrChannel, kNamesFile},
  {"textures", "mask", &R::mask_texture, "\"\"", 0, 0, nullptr, "",
   "image whose red scales the secondary highlight; empty: generated", kOrChannel, kNamesFile},
  {"textures", "strand_id", &R::strand_id_texture, "\"\"", 0, 0, nullptr, "",
   "image with a number for each strand, as packed hair atlases have it: shift and mask then follow the painted strands", kOrChannel,
   kNamesFile, nullptr, kIsLater},
  {"textures", "root_to_tip", &R::root_to_tip_texture, "\"\"", 0, 0, nullptr, "",
   "image that grows from 0 at the root to 1 at the tip, as packed hair atlases have it: says which end of each card is the root",
   kOrChannel, kNamesFile, nullptr, kIsLater},
  {"textures", "vertex_colors", choice_of<&R::vertex_colors>, "\"auto\"", 0, 0, "auto|multiply|ignore", "",
   "whether the source's vertex colours multiply colour and alpha, as glTF says; auto: unless all are black or clear, which are"
   " numbers for something else", "", false, nullptr, kIsLater},
  {"textures", "normal", &R::normal_texture, "\"\"", 0, 0, nullptr, "",
   "image of normals or heights that the hair is lit by; empty: the source's own", "", kNamesFile},
  {"textures", "normal_strength", &R::normal_strength, "1", 0, 16, nullptr, "",
   "multiplies the slopes of that image; 0: none is used"},
  {"textures", "normal_green", choice_of<&R::normal_green>, "\"auto\"", 0, 0, "auto|up|down", "",
   "where green of it leads, up the image (OpenGL) or down (DirectX); auto: up in glTF, else what its slopes show"},
  {"textures", "max_size", &R::texture_max_size, "null", 1, 16384, nullptr, "texels",
   "larger images are reduced to this", "; null: 1024, and cards of strands get all of cards.texels", false, "1024"},
  {"textures", "seed", &R::texture_seed, "1", 0, 4294967295.0, nullptr, "", "start of the generated shift and mask"},
  {"textures", "color_format", choice_of<&R::color_format>, "\"auto\"", 0, 0, "auto|etc2|rgba8", "",
   "how colour and alpha are stored: etc2 takes a quarter of the bytes, rgba8 keeps every value; auto: etc2 for textures of"
   " 1048576 texels or more that hardly change by it", "", false, nullptr, kIsLater},
  {"textures", "shift_mask_format", choice_of<&R::shift_mask_format>, "\"eac\"", 0, 0, "eac|rg8", "",
   "how shift and mask, normals and strands are stored: eac takes half the bytes, rg8 keeps every value"},

  {"occlusion", "strength", &R::occlusion_strength, "1", 0, 1, nullptr, "",
   "how far hair before hair and the head take away light from everywhere; 0: ambient light reaches all of it"},

  {"material", "base_color", &R::base_color, "[1, 1, 1, 1]", 0, 100, nullptr, "linear",
   "multiplies the base texture (red, green, blue, alpha)"},
  {"material", "ambient", &R::ambient, "[0.09, 0.09, 0.1]", 0, 100, nullptr, "linear",
   "light from everywhere, times the base colour"},
  {"material", "sides", choice_of<&R::sides>, "\"auto\"", 0, 0, "auto|both|front", "",
   "which sides of the triangles are seen; auto: both, unless the file has closed pieces or says single-sided"},
  {"material", "opaque_threshold", &R::opaque_threshold, "0", 0, 1, nullptr, "alpha",
   "texels from this alpha on are drawn opaque, the others are blended; 0: the material's, else chosen from the texture, then for"
   " pictures nearest to the exact one, of which each layer of a pixel that is blended must gain 0.5 dB up to 50 dB"},
  {"material", "discard_threshold", &R::discard_threshold, "0.02", 0, 1, nullptr, "alpha", "texels below this alpha are never drawn"},
  {"material", "primary_color", &R::primary_color, "[1, 0.95, 0.9]", 0, 100, nullptr, "linear",
   "colour of the primary highlight, towards the tip"},
  {"material", "primary_exponent", &R::primary_exponent, "150", 0.1, 1.0e5, nullptr, "", "sharpness of the primary highlight"},
  {"material", "primary_shift", &R::primary_shift, "0.7", -10, 10, nullptr, "",
   "how far the normal moves the primary highlight"},
  {"material", "secondary_color", &R::secondary_color, "[1.3, 0.9, 0.6]", 0, 100, nullptr, "linear",
   "colour of the secondary highlight, towards the root"},
  {"material", "secondary_exponent", &R::secondary_exponent, "30", 0.1, 1.0e5, nullptr, "",
   "sharpness of the secondary highlight"},
  {"material", "secondary_shift", &R::secondary_shift, "0.5", -10, 10, nullptr, "",
   "how far the normal moves the secondary highlight"},
  {"material", "shading", &R::shading, "\"volume\"", 0, 0, kShadingWords.data(), "",
   "how strands reflect light: through many fibres (volume, nearest to path tracing) or one (marschner), with highlights by the"
   " base colour and the next numbers; the thesis's, the default where a recipe gives its highlights; Kajiya-Kay's, with one of them"},
  {"material", "tilt", &R::tilt, "3", -20, 20, nullptr, "degrees",
   "marschner, volume: how far a strand's scales lean towards the tip; parts its two highlights"},
  {"material", "roughness", &R::roughness, "null", 1.2, 57, nullptr, "degrees",
   "marschner, volume: width of the first highlight along the strand, the second is twice as wide; null: 8; volume: 17"},
  {"material", "scatter", &R::scatter, "0.8", 0, 1, nullptr, "",
   "marschner: share of the light through strands that others scatter before it is seen; more for light or thick hair"},
  {"material", "glow", &R::glow, "0", 0, 8, nullptr, "",
   "light that comes through hair from behind; more for light or thin hair, 0 costs nothing"},
  {"material", "root_shade", &R::root_shade, "0", 0, 1, nullptr, "",
   "share of their colour that strands lack at the root, as hair does that has grown since it was dyed or lies deep"},
  {"material", "variation", &R::variation, "0", 0, 1, nullptr, "",
   "share by which strands are lighter and darker than each other, where a texture tells them apart"},
  {"material", "energy", choice_of<&R::energy>, "\"published\"", 0, 0, "published|bounded", "",
   "bounded: lights add less, so that hair never reflects more light than it gets however many there are; published: as"
   " the model's authors have it"},
};
// clang-format on

}  // namespace

std::span<const RecipeKey> recipe_keys() {
  static const std::vector<RecipeKey> keys = [] {
    std::vector<RecipeKey> all(std::begin(kCookKeys), std::end(kCookKeys));
    all.insert(all.end(), grow_keys().begin(), grow_keys().end());
    return all;
  }();
  return keys;
}

}  // namespace coif::cook
