#include "cook/recipe/hair_style.h"

namespace coif::cook {
namespace {

constexpr BuiltInStyle kStyles[] = {
    {"bob", R"({"length_top": 0.34, "length_front": 0.34, "length_sides": 0.3, "length_back": 0.3, "cut": -1.35,
      "parting": 32, "comb_strength": 0.35, "volume": 0.008, "layers": 0.009, "swing": -0.45, "clump": 0.5, "clump_size": 0.02,
      "length_random": 0.06, "frizz": 0.0012})"},
    {"fringe_bob", R"({"length_top": 0.34, "length_front": 0.3, "length_sides": 0.28, "length_back": 0.28, "cut": -1.05,
      "fringe_width": 62, "fringe_depth": 48, "fringe_length": 0.074, "whorl": 20, "volume": 0.008, "layers": 0.009, "swing": -0.4,
      "clump": 0.45, "length_random": 0.05, "frizz": 0.001, "root_color": [0.07, 0.06, 0.06], "tip_color": [0.16, 0.13, 0.12]})"},
    {"locks",
     R"({"length_top": 0.24, "length_front": 0.22, "length_sides": 0.19, "length_back": 0.17, "fringe_width": 56, "fringe_depth": 42,
      "fringe_length": 0.068, "whorl": 20, "lift": 26, "volume": 0.009, "layers": 0.009, "stiffness": 0.2, "swing": -0.25, "clump": 0.92,
      "hairline_wisps": 0, "clump_size": 0.042, "clump_shape": 1, "clump_children": 0, "length_random": 0.03, "frizz": 0, "flyaways": 0, "color_random": 0.03,
      "width": 0.0015, "root_color": [0.1, 0.12, 0.24], "tip_color": [0.26, 0.33, 0.58]})"},
    {"long", R"({"length_top": 0.5, "length_front": 0.47, "length_sides": 0.4, "length_back": 0.36, "parting": 0,
      "volume": 0.008, "clump": 0.7, "clump_size": 0.022, "length_random": 0.14, "frizz": 0.0025})"},
    {"wavy", R"({"length_top": 0.52, "length_front": 0.46, "length_sides": 0.42, "length_back": 0.42, "parting": 24,
      "lift": 20, "volume": 0.007, "layers": 0.009, "clump": 0.8, "clump_size": 0.034, "clump_shape": 0.6, "clump_children": 0.4,
      "curl_random": 0.05, "wave_height": 0.015, "wave_length": 0.105, "length_random": 0.2, "frizz": 0.0015, "flyaways": 0.012,
      "root_color": [0.36, 0.23, 0.13], "tip_color": [0.72, 0.52, 0.32]})"},
    {"curly", R"({"length_top": 0.29, "length_front": 0.22, "length_sides": 0.22, "length_back": 0.27, "parting": 26,
      "parting_strength": 0.7, "whorl": 15, "lift": 40, "volume": 0.01, "layers": 0.022, "stiffness": 0.25, "clump": 0.9, "clump_size": 0.016, "clump_shape": 0.2,
      "clump_children": 0.4, "curl_radius": 0.0095, "curl_pitch": 0.032, "curl_start": 0.15, "curl_random": 0.12,
      "length_random": 0.22, "frizz": 0.004, "flyaways": 0.04})"},
    {"coily", R"({"length_top": 0.17, "length_front": 0.12, "length_sides": 0.13, "length_back": 0.14, "parting": 18,
      "parting_strength": 0.5, "whorl": 15, "lift": 62, "volume": 0.014, "layers": 0.024, "stiffness": 0.4, "gravity": 0.7, "clump": 0.95,
      "clump_size": 0.011, "clump_shape": 0.12, "clump_children": 0.3, "curl_radius": 0.0052, "curl_pitch": 0.0135, "curl_start": 0.08,
      "curl_random": 0.08, "length_random": 0.25, "frizz": 0.002, "flyaways": 0.02, "flyaway_reach": 0.006,
      "root_color": [0.07, 0.05, 0.04], "tip_color": [0.2, 0.13, 0.09]})"},
    {"afro", R"({"length_top": 0.085, "length_front": 0.042, "length_sides": 0.055, "length_back": 0.062, "comb": "out",
      "comb_strength": 1, "lift": 85, "volume": 0.02, "layers": 0.02, "stiffness": 0.85, "gravity": 0.12, "whorl": 0, "clump": 0.8,
      "clump_size": 0.009, "clump_shape": 0.25, "curl_radius": 0.0045, "curl_pitch": 0.011, "curl_start": 0.1, "curl_random": 0.25,
      "length_random": 0.2, "frizz": 0.004, "root_color": [0.05, 0.04, 0.035], "tip_color": [0.14, 0.1, 0.08]})"},
    {"short", R"({"length_top": 0.095, "length_front": 0.085, "length_sides": 0.03, "length_back": 0.035, "parting": 40,
      "parting_strength": 0.7, "comb": "back", "comb_strength": 0.3, "lift": 24, "volume": 0.005, "layers": 0.007,
      "stiffness": 0.35, "clump": 0.35, "clump_size": 0.012, "clump_shape": 0.9, "clump_children": 0.2, "length_random": 0.3, "frizz": 0.0014,
      "flyaways": 0.01, "flyaway_reach": 0.003})"},
    {"spiky", R"({"length_top": 0.09, "length_front": 0.085, "length_sides": 0.05, "length_back": 0.06, "comb": "up",
      "comb_strength": 0.5, "lift": 58, "volume": 0.004, "layers": 0.004, "stiffness": 0.88, "gravity": 0.3, "clump": 1,
      "clump_size": 0.03, "clump_shape": 0.95, "clump_children": 0.3, "length_random": 0.25, "frizz": 0.0008, "flyaways": 0.006,
      "root_color": [0.35, 0.22, 0.1], "tip_color": [0.85, 0.68, 0.38]})"},
    {"slick", R"({"length_top": 0.15, "length_front": 0.16, "length_sides": 0.1, "length_back": 0.06, "comb": "back",
      "hairline_sideburns": 8, "comb_strength": 1, "lift": 12, "volume": 0.005, "layers": 0.006, "stiffness": 0.3, "clump": 0.6, "clump_size": 0.014,
      "length_random": 0.08, "frizz": 0.0006, "flyaways": 0.005, "root_color": [0.06, 0.05, 0.045], "tip_color": [0.13, 0.1, 0.09]})"},
    {"ponytail",
     R"({"length_top": 0.46, "length_front": 0.5, "length_sides": 0.45, "length_back": 0.4, "gather": [180, 22],
      "lift": 8, "hairline_fade": 14, "volume": 0.003, "layers": 0.004, "clump": 0.3, "clump_size": 0.014, "clump_children": 0.2,
      "length_random": 0.14, "frizz": 0.0012, "flyaways": 0.015})"},
};

}  // namespace

std::span<const BuiltInStyle> built_in_styles() { return kStyles; }

}  // namespace coif::cook
