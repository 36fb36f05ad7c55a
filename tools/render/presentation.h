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

/// A head with a face in place of the collider that stands for one, as large as that is: hair that comes without a body
/// is seen on somebody. Empty where there is no such collider. Made anew by each call, in a quarter of a second.
[[nodiscard]] std::vector<SolidMesh> bust_meshes(std::span<const ColliderRecord> colliders, bool faces_backwards);

/// Points that outline it, for framing: head space, metres.
[[nodiscard]] std::vector<Eigen::Vector3d> bust_outline(std::span<const ColliderRecord> colliders,
                                                        bool faces_backwards);

/// The base textures that a source's materials name, embedded or beside it, reduced to what a picture shows; for
/// PictureSettings. What cannot be had is a warning of `findings`. Only those of materials that some mesh has are read.
[[nodiscard]] BodyTextures read_body_textures(const importer::SourceModel& model, cook::Findings& findings);

}  // namespace coif::render
