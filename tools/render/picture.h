#pragma once

#include "base/encodings.h"
#include "base/linear_picture.h"
#include "base/tool_error.h"
#include "import/source_model.h"
#include "motion/head_path.h"
#include "render/camera.h"
#include "render/debug_overlay.h"
#include "render/ground.h"
#include "render/kept_order.h"
#include "render/presentation.h"

#include <coif/asset.h>
#include <coif/hair.h>
#include <coif/renderer.h>
#include <coif/shadow.h>
#include <coif/transparency.h>

#include <tl/expected.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace coif::render {

/// The asset's material with another shading model; without one, that of the thesis's first gallery. Numbers that the
/// model needs and the material lacks get a recipe's defaults; a light_cut that was made for another model is dropped.
[[nodiscard]] MaterialRecord shaded_material(const Asset& asset, ShadingModel model);

/// Every way to draw shadows, for tools that offer or compare them; name_of() has their names.
[[nodiscard]] std::span<const ShadowTechnique* const> shadow_techniques();

/// Every way to draw transparent hair, for tools that offer or compare them; name_of() has their names.
[[nodiscard]] std::span<const TransparencyMode* const> transparency_modes();

/// Samples per pixel of a target that the mode draws to at its best; 0: a target without multisampling.
[[nodiscard]] std::uint32_t samples_for(const TransparencyMode& mode);

// Headless pictures of a cooked asset through EGL and the runtime's own renderer.

/// Light in place of a rig's.
struct PictureLight {
  std::vector<Light> lights;   ///< The first casts shadows.
  std::array<float, 3> sky{};  ///< Radiance from everywhere alike, linear, in place of the material's own.
};

struct PictureSettings {
  std::uint32_t width = 1024;  ///< Pixels, 16..8192.
  std::uint32_t height = 768;
  double yaw_degrees = 30;   ///< 0: from the front, positive: towards the model's left.
  double pitch_degrees = 5;  ///< Positive: from above.
  double margin = 1.08;      ///< Times the distance from which all is seen, in the motion's first seconds too, 1..10.
  std::optional<CameraPlace> camera;             ///< Instead of angles and margin, one head.
  std::optional<motion::Motion> motion;          ///< None: the settled pose at rest.
  std::shared_ptr<const motion::HeadPath> clip;  ///< Instead of `motion`, unless null.
  double time = 0;                               ///< Seconds into the motion.
  StepSettings step;
  const Solver* solver = &kCoifSolver;
  /// Null: none. Balls and capsules among its colliders are drawn, solid.
  std::shared_ptr<const motion::HairCompany> company;
  Component component = Component::kAll;
  std::optional<MaterialRecord> material;  ///< Instead of the asset's.
  bool patches = false;                    ///< Instead of shaded hair: each patch in its own colour, without holes.
  bool colliders = false;  ///< The hair's colliders, seen through it, also with a body. No shadows then.
  std::optional<std::uint32_t> marked_patch;  ///< With `patches`: this one of the level in red, the others grey.
  std::uint32_t lod = 0;                      ///< Level of detail, below the asset's lod_count().
  const TransparencyMode* transparency = &kBlendMode;
  OrderChoice order = OrderChoice::kCooked;
  const ShadowTechnique* shadows = nullptr;  ///< Shadows of the key light; null: none.
  std::uint32_t heads = 1;                   ///< Drawn in a grid.
  std::uint32_t oversampling = 1;            ///< Shaded samples per pixel in each direction, 1..4.
  /// Samples of edges in each of those, by the driver, which may have fewer; 0: the driver's default with
  /// `oversampling` 1, else one.
  std::uint32_t edge_samples = 0;
  DebugView debug;      ///< Over the hair.
  bool warm_up = true;  ///< Draw once before the timed frame, for work that drivers put off.
  LightRig lights = LightRig::kMeasured;
  std::optional<PictureLight> light;  ///< Instead of `lights`.
  Backdrop backdrop;
  GroundChoice ground = GroundChoice::kNever;  ///< The shade below opaque things.
  const importer::SourceModel* body =
      nullptr;                 ///< Drawn opaque instead of the collider: the source's meshes that are not hair.
  BodyTextures body_textures;  ///< The body's materials'; empty: clay where there should be one.
  const importer::SourceModel* ghost = nullptr;  ///< Beside what the hair is on: drawn over all as clay like glass.
  bool bust = false;                             ///< A head with a face in place of the largest of them.
  bool cuts_out_bodies = false;                  ///< They hide hair and shade it, but are holes in the picture.
  bool keeps_light = false;                      ///< Also Picture::light.
  bool mannequin = true;  ///< Without `body`: draw the colliders that hair stays out of, as a plain head.
  /// Draw colliders with a ninth of their triangles: as good up to some hundred pixels.
  bool coarse_mannequin = false;
};

struct Picture {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint8_t> rgba;  ///< Rows top to bottom, sRGB.
  std::string device;              ///< GL_RENDERER.
  double draw_ms = 0;              ///< Last frame, glFinish to glFinish.
  std::uint32_t edge_samples = 1;  ///< The driver's number.
  CameraPlace camera{};            ///< Metres from the head's joint.
  std::vector<Light> lights{};
  LinearPicture light{};  ///< Before the tone curve; empty unless PictureSettings::keeps_light.
};

/// The contents and the frame of a picture.
struct FramedPicture {
  /// Points that must be in it, of each head, from its joint; world axes, metres.
  std::vector<Eigen::Vector3d> points;
  CrowdView view;
};

/// Frames like PictureMaker. Errors: those of simulate_poses().
tl::expected<FramedPicture, ToolError> frame_picture(const Asset& asset, const PictureSettings& settings);

/// Pictures of one asset, which must outlive this object, in one OpenGL ES context; one of these at a time.
class PictureMaker {
 public:
  /// Errors: kUnsupported where no EGL display with OpenGL ES 3.0 can be had, kBadInput for an asset without a mesh.
  static tl::expected<PictureMaker, ToolError> create(const Asset& asset);
  PictureMaker(PictureMaker&&) noexcept;
  PictureMaker& operator=(PictureMaker&&) = delete;
  ~PictureMaker();

  /// kUsage for settings out of range.
  tl::expected<Picture, ToolError> take(const PictureSettings& settings);

 private:
  struct Loaded;
  explicit PictureMaker(std::unique_ptr<Loaded> loaded);

  std::unique_ptr<Loaded> loaded_;
};

/// One picture. Errors: those of PictureMaker.
tl::expected<Picture, ToolError> render_picture(const Asset& asset, const PictureSettings& settings);

/// PNG bytes. Empty only when out of memory.
[[nodiscard]] inline std::vector<std::uint8_t> encode_png(const Picture& picture) {
  return coif::encode_png(picture.rgba, picture.width, picture.height);
}

/// Writes a PNG of encode_png_quickly() to `path`, whole or not at all.
tl::expected<void, ToolError> write_png(const std::string& path, const Picture& picture);

}  // namespace coif::render
