#include "cook/recipe/recipe_preset.h"

namespace coif::cook {
namespace {

constexpr RecipePreset kRecipePresets[] = {
    {"realistic",
     "long and wavy unless \"grow.style\" says otherwise: light that wanders among fibres, darker roots; fine cards "
     "and textures",
     R"({"grow": {"style": "wavy"}, "material": {"shading": "volume", "root_shade": 0.2, "variation": 0.2}, "cards": {"triangles": 20000}, "textures": {"max_size": 2048}})"},
    {"anime", "large pointed locks, flat colour, one sharp band of light, solid edges; locks keep their shape",
     R"({"grow": {"style": "locks"}, "material": {"shading": "kajiya-kay", "ambient": [0.5, 0.5, 0.54], "primary_color": [0.5, 0.52, 0.6],
      "primary_exponent": 220, "primary_shift": 0.1, "opaque_threshold": 0.5, "discard_threshold": 0.45},
      "dynamics": {"preset": "stiff"}, "cards": {"triangles": 4000}, "occlusion": {"strength": 0.4},
      "order": {"method": "head"}})"},
    {"stylised",
     "a smooth bob unless \"grow.style\" says otherwise: broad soft highlights and strong darkening inside, hair that "
     "bounces",
     R"({"grow": {"style": "bob"}, "material": {"shading": "thesis", "ambient": [0.22, 0.21, 0.22], "primary_exponent": 40,
      "primary_color": [0.7, 0.66, 0.62], "secondary_exponent": 12, "secondary_color": [0.9, 0.62, 0.42], "root_shade": 0.3,
      "variation": 0.08, "energy": "bounded"},
      "dynamics": {"preset": "bouncy"}, "cards": {"triangles": 6000}})"},
    {"ponytail", "tied hair: a tail that swings for long, the rest close to the head",
     R"({"grow": {"style": "ponytail"}, "dynamics": {"preset": "bouncy", "liveliness": 0.7}, "cards": {"triangles": 12000},
      "material": {"shading": "volume", "root_shade": 0.25, "variation": 0.12}})"},
    {"curly", "curls: more cards, of more triangles each, springy",
     R"({"grow": {"style": "curly"}, "dynamics": {"preset": "bouncy"}, "cards": {"triangles": 14000},
      "material": {"shading": "volume", "root_shade": 0.3, "variation": 0.2}})"},
    {"short", "short hair: stands by itself, few moving bones, cheap",
     R"({"grow": {"style": "short"}, "dynamics": {"preset": "stiff"}, "cards": {"triangles": 7000},
      "material": {"shading": "volume", "root_shade": 0.2, "variation": 0.15}})"},
};

}  // namespace

std::span<const RecipePreset> recipe_presets() { return kRecipePresets; }

}  // namespace coif::cook
