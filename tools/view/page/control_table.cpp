// The page's controls, row by row. Numbers of a recipe have its ranges, or those that look like hair.

#include "base/hair_runtime.h"
#include "view/page/view_settings.h"

#include <cstddef>
#include <cstdio>

namespace coif::view {
namespace {

struct Control {
  const char* name;
  const char* group;  ///< "": no control of its own.
  const char* label;
  const char* hint;
  const char* unit;
  const char* kind;
  std::size_t at;  ///< Bytes, in ViewSettings.
  float low, high, step;
  const char* words = "";         ///< Words of a choice, separated by '|'.
  const char* recipe = "";        ///< Its key in a recipe; "": the recipe has none.
  const char* recipe_words = "";  ///< Those that the recipe knows; "": all.
};

#define COIF_AT(field) offsetof(ViewSettings, field)

constexpr char kModeWords[] = "blend|opaque|coverage|proportional|jittered|screendoor|checkerboard|bayer|hashed";
constexpr char kShadowWords[] = "none|plain|opacity|deep|deep-shadow";
constexpr char kSolverWords[] = "coif|cascade|passive|thesis";
constexpr char kBesideWords[] = "none|coif|cascade|passive|thesis";
constexpr char kViewWords[] = "hair|patches|overdraw|draw order";
constexpr char kPresetWords[] = "its own numbers|natural|stiff|heavy|bouncy|wet";
constexpr char kComponentWords[] = "all|ambient|diffuse|specular|primary|secondary|direction";

constexpr Control kControls[] = {
    {"yaw", "", "Around", "", "deg", "number", COIF_AT(yaw), -180, 180, 1},
    {"pitch", "", "Above", "", "deg", "number", COIF_AT(pitch), -89, 89, 1},
    {"zoom", "", "Zoom", "", "", "number", COIF_AT(zoom), 0.3f, 8, 0.01f},

    {"motion", "Motion", "Head", "How the head moves", "", "choice", COIF_AT(motion), 0, 0, 1},
    {"plays", "Motion", "Play", "The head moves; space bar", "", "switch", COIF_AT(plays), 0, 1, 1},
    {"rate", "Motion", "Frame rate", "Steps of the simulation, as of a game's frames", "1/s", "number", COIF_AT(rate),
     15, 240, 1},
    {"wind", "Motion", "Wind", "How fast the air moves", "m/s", "number", COIF_AT(wind), 0, 20, 0.1f},
    {"wind_from", "Motion", "Wind from", "0: it blows into the face", "deg", "number", COIF_AT(wind_from), -180, 180,
     1},
    {"gusts", "Motion", "Gusts", "The strongest, on top of the wind; for the solver coif", "m/s", "number",
     COIF_AT(gusts), 0, 12, 0.1f},

    {"preset", "Simulation", "Kind of hair",
     "How long it has to be to hang, and how it swings; for hair that nobody gave numbers to", "", "choice",
     COIF_AT(preset), 0, 5, 1, kPresetWords, "dynamics.preset", "natural|stiff|heavy|bouncy|wet"},
    {"liveliness", "Simulation", "Liveliness", "0: no bone swings past where it rests, 1: only the air stops it", "",
     "number", COIF_AT(liveliness), 0, 1, 0.01f, "", "dynamics.liveliness"},
    {"gravity_scale", "Simulation", "Weight", "Share of gravity that hair feels", "x", "number", COIF_AT(gravity_scale),
     0, 3, 0.01f, "", "dynamics.gravity_scale"},
    {"friction", "Simulation", "Friction of air", "How fast hair takes on the air's velocity", "1/s", "number",
     COIF_AT(friction), 0, 20, 0.1f, "", "dynamics.friction"},
    {"air_follow", "Simulation", "Air goes along",
     "Share of the head's velocity; 0: hair streams back when the head runs", "", "number", COIF_AT(air_follow), 0, 1,
     0.01f, "", "dynamics.air_follow"},
    {"angle_limit", "Simulation", "Bend limit", "From its modelled direction, each bone; 180: any way", "deg", "number",
     COIF_AT(angle_limit), 0, 180, 1, "", "dynamics.angle_limit"},
    {"solver", "Simulation", "Solver", "What moves the bones; coif takes what the asset was cooked for", "", "choice",
     COIF_AT(solver), 0, 3, 1, kSolverWords, "dynamics.model", "cascade|passive"},
    {"beside", "Simulation", "Beside it", "A second head, to compare", "", "choice", COIF_AT(beside), 0, 4, 1,
     kBesideWords},
    {"iterations", "Simulation", "Iterations", "Of thesis: how often a step repeats its constraints", "", "number",
     COIF_AT(iterations), 1, 16, 1},
    {"lod", "Simulation", "Level of detail", "0 is the finest", "", "number", COIF_AT(lod), 0, 0, 1},

    {"shading", "Hair", "Shading", "How strands reflect light", "", "choice", COIF_AT(shading), 0, 2, 1,
     kShadingWords.data(), "material.shading"},
    {"base_color", "Hair", "Tint", "Times the colour that was cooked", "", "color", COIF_AT(base_color), 0, 4, 0.01f,
     "", "material.base_color"},
    {"cooked_color", "", "", "", "", "color", COIF_AT(cooked_color), 0, 4, 0.01f},
    {"ambient", "Hair", "Light around", "Light from everywhere, times the hair's colour", "", "color", COIF_AT(ambient),
     0, 1, 0.005f, "", "material.ambient"},
    {"transparency", "Hair", "Soft edges", "How they are drawn", "", "choice", COIF_AT(transparency), 0, 8, 1,
     kModeWords},
    {"opaque_threshold", "Hair", "Solid from", "Texels with at least this alpha count as solid", "alpha", "number",
     COIF_AT(opaque_threshold), 0.01f, 1, 0.01f, "", "material.opaque_threshold"},
    {"discard_threshold", "Hair", "Clear below", "Texels with less alpha are left out", "alpha", "number",
     COIF_AT(discard_threshold), 0, 1, 0.01f, "", "material.discard_threshold"},
    {"shadows", "Hair", "Shadows", "How the key light's shadows are drawn", "", "choice", COIF_AT(shadows), 0, 4, 1,
     kShadowWords},

    {"primary_color", "Highlights", "First", "Colour of the first highlight", "", "color", COIF_AT(primary_color), 0, 4,
     0.01f, "", "material.primary_color"},
    {"primary_exponent", "Highlights", "First: exponent", "The larger, the narrower", "", "number",
     COIF_AT(primary_exponent), 1, 1000, 1, "", "material.primary_exponent"},
    {"primary_shift", "Highlights", "First: shift", "Along the strand", "", "number", COIF_AT(primary_shift), -2, 2,
     0.01f, "", "material.primary_shift"},
    {"secondary_color", "Highlights", "Second", "Colour of the second highlight", "", "color", COIF_AT(secondary_color),
     0, 4, 0.01f, "", "material.secondary_color"},
    {"secondary_exponent", "Highlights", "Second: exponent", "The larger, the narrower", "", "number",
     COIF_AT(secondary_exponent), 1, 1000, 1, "", "material.secondary_exponent"},
    {"secondary_shift", "Highlights", "Second: shift", "Along the strand", "", "number", COIF_AT(secondary_shift), -2,
     2, 0.01f, "", "material.secondary_shift"},
    {"tilt", "Highlights", "Tilt", "Of the fibre's scales; for marschner, volume", "deg", "number", COIF_AT(tilt), -20,
     20, 0.1f, "", "material.tilt"},
    {"roughness", "Highlights", "Roughness", "Width of the first highlight; for marschner, volume", "deg", "number",
     COIF_AT(roughness), 1.2f, 57, 0.1f, "", "material.roughness"},
    {"scatter", "Highlights", "Scatter", "Light that other strands scatter; for marschner", "", "number",
     COIF_AT(scatter), 0, 1, 0.01f, "", "material.scatter"},

    {"view", "Show", "View",
     "The hair, or of what it is made. Overdraw counts every texel of its triangles that is not clear, whatever Soft "
     "edges says; draw order is that within each pass. Key V",
     "", "choice", COIF_AT(view), 0, 3, 1, kViewWords},
    {"component", "Show", "Part of the light", "Or the strands' direction: green roots, red tips", "", "choice",
     COIF_AT(component), 0, 6, 1, kComponentWords},
    {"bones", "Show", "Bones", "Key B", "", "switch", COIF_AT(bones), 0, 1, 1},
    {"colliders", "Show", "Colliders", "Key C", "", "switch", COIF_AT(colliders), 0, 1, 1},
    {"contacts", "Show", "Contacts", "Where bones touch", "", "switch", COIF_AT(contacts), 0, 1, 1},
    {"limits", "Show", "Limits", "How far bones may turn", "", "switch", COIF_AT(limits), 0, 1, 1},
    {"samples", "Show", "Samples", "Of each pixel, each way; 1 is for slow graphics cards", "", "number",
     COIF_AT(samples), 1, 2, 1},
};
#undef COIF_AT

void add_text(std::string& json, const char* key, std::string_view text) {
  json.append("\"").append(key).append("\":\"").append(text).append("\",");  // no text has a quotation mark
}

void add_number(std::string& json, const char* key, double number) {
  char text[64];
  std::snprintf(text, sizeof text, "\"%s\":%.9g,", key, number);
  json += text;
}

}  // namespace

std::string controls_json(const Asset& asset, bool has_clip) {
  std::string json = "[";
  for (const Control& control : kControls) {
    const std::string_view name = control.name, kind = control.kind;
    json += json.size() > 1 ? ",{" : "{";
    add_text(json, "name", name);
    add_text(json, "group", control.group);
    add_text(json, "label", control.label);
    add_text(json, "hint", control.hint);
    add_text(json, "unit", control.unit);
    add_text(json, "words", name == "motion" ? motion_words(has_clip) : control.words);
    add_text(json, "recipe", control.recipe);
    add_text(json, "recipe_words", control.recipe_words);
    add_number(json, "at", double(control.at / sizeof(float)));
    add_number(json, "count", kind == "color" ? 3 : 1);
    add_number(json, "low", double(control.low));
    add_number(json, "high", name == "lod" ? asset.lod_count() - 1.0 : double(control.high));
    add_number(json, "step", double(control.step));
    json.append("\"kind\":\"").append(kind).append("\"}");
  }
  return json + "]";
}

}  // namespace coif::view
