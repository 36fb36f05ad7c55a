#pragma once

#include "motion/head_path.h"

#include <coif/asset.h>
#include <coif/asset_records.h>
#include <coif/drawing.h>
#include <coif/hair.h>
#include <coif/shadow.h>
#include <coif/transparency.h>

#include <cstdint>
#include <memory>
#include <string>

namespace coif::view {

/// All settings of a visitor of the page. Floats without padding, so that the page's scripts see one array; a choice is
/// the number of its word. The rows of control_table() give each setting's name, range, and recipe key.
struct ViewSettings {
  float yaw = 30, pitch = 5;  ///< Degrees, as `coif render --view` takes them.
  float zoom = 1;             ///< 1: all is seen, as `coif render` frames it; 2: twice as large.

  float motion = 0, plays = 0;
  float rate = 60;  ///< Steps a second.
  float wind = 0, wind_from = 0, gusts = 0;

  float solver = 0, beside = 0;  ///< `beside`: of a second head, 0: none.
  float iterations = 1;
  float preset = 0;  ///< 0: none, the asset's own motion.
  float liveliness = 0, gravity_scale = 1, friction = 0, air_follow = 1;
  float angle_limit = 180;  ///< Degrees.
  float lod = 0;

  float shading = 0;
  float base_color[3] = {1, 1, 1};    ///< Factor on the asset's own colour.
  float cooked_color[3] = {1, 1, 1};  ///< The part of this colour that is already in the asset's own.
  float ambient[3] = {};
  float transparency = 0;
  float opaque_threshold = 1, discard_threshold = 0;
  float shadows = 4;

  float primary_color[3] = {};
  float primary_exponent = 100, primary_shift = 0;
  float secondary_color[3] = {};
  float secondary_exponent = 100, secondary_shift = 0;
  float tilt = 3, roughness = 8, scatter = 0.8f;  ///< Degrees, degrees, share.

  float view = 0;  ///< hair_view_of() it.
  float component = 0;
  float bones = 0, colliders = 0, contacts = 0, limits = 0;
  float samples = 2;  ///< Samples per pixel in each direction.
};
inline constexpr std::uint32_t kViewSettings = sizeof(ViewSettings) / sizeof(float);

/// Sets the look of this material, except for its tint, which is relative to an asset's own, and for values that only
/// fibres have.
void set_look(const MaterialRecord& material, ViewSettings& settings);

/// The asset's own look; with_motion() adds its motion.
[[nodiscard]] ViewSettings settings_of(const Asset& asset);

/// The asset's material with the visitor's changes.
[[nodiscard]] MaterialRecord material_of(const Asset& asset, const ViewSettings& settings);

[[nodiscard]] const TransparencyMode& transparency_of(const ViewSettings& settings);
/// Null: none.
[[nodiscard]] const ShadowTechnique* shadows_of(const ViewSettings& settings);
/// The solver with the choice's number.
[[nodiscard]] const Solver& solver_of(float choice);
[[nodiscard]] Component component_of(const ViewSettings& settings);

/// The rows of the control table as JSON, for the page: [{"name", "group", "label", "hint", "unit", "kind": "number" |
/// "choice" | "switch" | "color", "at", "count", "low", "high", "step", "words", "recipe", "recipe_words"}]. `at`:
/// place in the array, in floats. `has_clip`: "clip" is the last of the motions.
[[nodiscard]] std::string controls_json(const Asset& asset, bool has_clip = false);

/// The page's motions: the built-in ones by their numbers, those of head_looks(), and "clip" if the page has one.
/// Separated by '|'.
[[nodiscard]] std::string motion_words(bool has_clip);

/// Whether the choice's number is that of the clip.
[[nodiscard]] bool is_clip(float choice);

/// The path with the choice's number; the last one for any larger number. Never null.
[[nodiscard]] std::unique_ptr<motion::HeadPath> chosen_path(float choice);

}  // namespace coif::view
