#pragma once

#include "cook/recipe/findings.h"
#include "import/source_model.h"
#include "render/camera.h"
#include "render/stage_renderer.h"

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace coif::render {

/// Three lights that move with the camera, the first of which casts shadows.
enum class LightRig {
  kMeasured,  ///< The light that the cook and its measurements assume (base/studio.h), on plain clay.
  kStudio,    ///< A portrait's: warm key from above, cool fill, rim from behind.
  kSun,       ///< One hard light, and the sky.
  kRim,       ///< Strong light from behind on both sides, little in front.
};

/// Right, up, back of the camera as in StudioLight, in world axes.
[[nodiscard]] std::array<Light, 3> rig_lights(LightRig rig, const Camera& camera);

/// The look of bodies in that light.
[[nodiscard]] BodyLook rig_body_look(LightRig rig);

/// "dark" (lighter in the middle), "light" (the gradient that measurements are made before), "clear" (transparent), or
/// a colour as #rrggbb. None for other words.
[[nodiscard]] std::optional<Backdrop> find_backdrop(std::string_view word);

/// A head with a face in place of the head's collider and of its size, so that hair without a body is shown on
/// somebody. Empty where there is no such collider. Made anew by each call, in a quarter of a second.
[[nodiscard]] std::vector<SolidMesh> bust_meshes(std::span<const ColliderRecord> colliders, bool faces_backwards);

/// Points that outline it, for framing: head space, metres.
[[nodiscard]] std::vector<Eigen::Vector3d> bust_outline(std::span<const ColliderRecord> colliders,
                                                        bool faces_backwards);

/// The base textures of a source's materials, embedded or beside it, reduced to what a picture shows; for
/// PictureSettings. A texture that cannot be read is a warning in `findings`. Only materials of meshes are read.
[[nodiscard]] BodyTextures read_body_textures(const importer::SourceModel& model, cook::Findings& findings);

}  // namespace coif::render
