#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace coif::cook {

/// The style of grown hair: the recipe's section "grow". grow_keys.cpp has meanings, defaults and ranges. Angles are
/// degrees about the middle of the head: elevations above it, azimuths 0 at the face and 90 at the model's left.
/// Lengths are metres on a head of usual size, and grow with the head.
struct HairStyle {
  std::string grow_style;  ///< The built-in style that the other keys start from; "none": the defaults.
  std::uint32_t grow_strands = 0;
  std::uint32_t grow_seed = 0;
  // hairline: the lowest elevation of roots
  double grow_hairline_front = 0;
  double grow_hairline_temples = 0;
  double grow_hairline_recess = 0;     ///< Degrees above the smooth line from the front to the temples.
  double grow_hairline_sideburns = 0;  ///< Degrees below the line over the ears.
  double grow_hairline_sides = 0;
  double grow_hairline_nape = 0;
  double grow_hairline_fade = 0;   ///< Degrees over which roots become as dense as elsewhere.
  double grow_hairline_wisps = 0;  ///< Share; how many roots at the hairline have short, fine hair.
  // length
  double grow_length_top = 0;
  double grow_length_front = 0;
  double grow_length_sides = 0;
  double grow_length_back = 0;
  double grow_length_random = 0;   ///< Share.
  std::optional<double> grow_cut;  ///< Head radii above its middle, where tips are cut level.
  // fringe
  double grow_fringe_width = 0;  ///< Degrees to each side; 0: no fringe.
  double grow_fringe_depth = 0;  ///< Degrees from the hairline up.
  double grow_fringe_length = 0;
  // which way it is combed
  std::optional<double> grow_parting;  ///< Degrees to the model's left; none: no parting.
  double grow_parting_strength = 0;
  double grow_crown = 0;  ///< Degrees behind the top.
  double grow_whorl = 0;  ///< Degrees that hair turns about the crown.
  std::string grow_comb;  ///< "down", "back", "forward", "up" or "out".
  double grow_comb_strength = 0;
  // how it lies and falls
  double grow_lift = 0;       ///< Degrees off the scalp at the root.
  double grow_volume = 0;     ///< Metres off the scalp.
  double grow_layers = 0;     ///< Metres that hair from above lies over hair from below.
  double grow_stiffness = 0;  ///< 0..1
  double grow_gravity = 0;
  double grow_swing = 0;  ///< Share; how far tips turn out.
  // tail
  std::optional<std::array<double, 2>> grow_gather;  ///< Azimuth and elevation of the tie; none: hair hangs open.
  double grow_tie_radius = 0;
  double grow_tail_radius = 0;
  // clumps
  double grow_clump = 0;
  double grow_clump_size = 0;
  double grow_clump_shape = 0;
  double grow_clump_children = 0;
  // curls and waves
  double grow_curl_radius = 0;
  double grow_curl_pitch = 0;
  double grow_curl_start = 0;
  double grow_curl_random = 0;
  double grow_wave_height = 0;
  double grow_wave_length = 0;
  // noise
  double grow_frizz = 0;
  double grow_frizz_length = 0;
  double grow_flyaways = 0;
  double grow_flyaway_reach = 0;
  // strands
  double grow_width = 0;
  double grow_taper = 0;
  std::array<double, 3> grow_root_color{};
  std::array<double, 3> grow_tip_color{};
  double grow_color_random = 0;
};

struct BuiltInStyle {
  const char* name;
  const char* keys;  ///< JSON of the section "grow": differences from the defaults.
};

/// Every style that "grow.style" may name, except "none".
[[nodiscard]] std::span<const BuiltInStyle> built_in_styles();

/// The choices of "grow.style": "none" and the styles' names.
inline constexpr const char* kStyleWords =
    "none|bob|fringe_bob|locks|long|wavy|curly|coily|afro|short|spiky|slick|ponytail";

}  // namespace coif::cook
