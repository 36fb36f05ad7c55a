#pragma once

#include "render/camera.h"
#include "render/stage_renderer.h"

#include <array>
#include <optional>
#include <string_view>

namespace coif::render {

/// Three lights that move with the camera, the first of which casts shadows.
enum class LightRig {
  kMeasured,  ///< As the cook and its measurements expect (base/studio.h), on plain clay.
  kStudio,    ///< A portrait's: warm key from above, cool fill, rim from behind.
  kSun,       ///< One hard light, and the sky.
  kRim,       ///< Strong light from behind on both sides, little in front.
};

/// Right, up, back of the camera as in StudioLight, in world axes.
[[nodiscard]] std::array<Light, 3> rig_lights(LightRig rig, const Camera& camera);

/// How that light falls on bodies.
[[nodiscard]] BodyLook rig_body_look(LightRig rig);

/// "dark" (lighter in the middle), "light" (the gradient that measurements are made before), "clear" (transparent), or
/// a colour as #rrggbb. None for other words.
[[nodiscard]] std::optional<Backdrop> find_backdrop(std::string_view word);

}  // namespace coif::render
