#pragma once

#include "base/studio.h"
#include "base/tool_error.h"
#include "render/camera.h"

#include <coif/asset.h>
#include <coif/asset_records.h>
#include <coif/character.h>
#include <coif/math.h>
#include <coif/renderer.h>
#include <coif/research.h>
#include <coif/shadow.h>

#include <Eigen/Core>
#include <tl/expected.hpp>

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace coif::importer {
struct SourceMesh;
struct SourceModel;
}  // namespace coif::importer

namespace coif::render {

struct SolidVertex {
  Eigen::Vector3f position;
  Eigen::Vector3f normal;                        ///< Unit.
  Eigen::Vector2f uv = Eigen::Vector2f::Zero();  ///< V grows downwards in the texture.

  bool operator==(const SolidVertex&) const = default;
};

/// RGBA, colour sRGB-encoded, alpha not premultiplied, rows top to bottom; it repeats.
struct SolidTexture {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint8_t> rgba;
};

/// An opaque thing beneath the hair. Head space, metres.
struct SolidMesh {
  std::vector<SolidVertex> vertices;
  std::vector<std::uint32_t> triangles;
  Eigen::Vector3f color{kClay[0], kClay[1], kClay[2]};  ///< Linear; the default is a mannequin's clay.
  std::shared_ptr<const SolidTexture> texture;          ///< Times `color`; null: none.
  float alpha_cutoff = 0;                               ///< Texels with less alpha are holes, 0..1.
  float roughness = 0.8f;                               ///< 0 a mirror .. 1 matte; only where BodyLook has gloss.
  bool is_ghost = false;                                ///< Drawn by draw_ghosts() alone.

  bool operator==(const SolidMesh&) const = default;  ///< The same texture, not one with equal texels.
};

/// The background: a gradient, and light in the middle of it. Linear colours.
struct Backdrop {
  std::array<float, 3> bottom = kBackdropBottom, top = kBackdropTop;
  std::array<float, 3> glow{};  ///< Added in the middle, fades outwards.
  float vignette = 0;           ///< Share that the corners lose.
  float opacity = 1;            ///< 0: nothing is there, and the picture transparent.
};

/// The reflection of light on bodies. The default is matte clay.
struct BodyLook {
  float ambient = kClayAmbient;  ///< Light from everywhere.
  float wrap = kClayWrap;        ///< How far light reaches around.
  float bleed = 0;               ///< How much farther red does than blue, as in skin.
  float gloss = 0;               ///< Share of the surface's mirror reflection that is shown.

  bool operator==(const BodyLook&) const = default;
};

/// Colliders as smooth bodies, a little smaller than they collide. Left out: planes, and shapes that keep hair inside,
/// which would hide it. Coarse ones have a ninth of the triangles.
[[nodiscard]] std::vector<SolidMesh> mannequin_meshes(std::span<const ColliderRecord> colliders,
                                                      bool is_coarse = false);

/// Colliders of the game beside a head at `head`, in its space: balls and capsules; other shapes are left out.
[[nodiscard]] std::vector<SolidMesh> moving_meshes(std::span<const MovingCollider> colliders, const HeadPose& head);

/// How a standing body follows the turn of its head.
struct BodyTurn {
  std::string head_bone;  ///< Its name in the source. Without it, or without skin weights, everything turns.
  Quat turn{};            ///< The head's rotation, world.
};

/// A mesh of the source model; `head_joint` as in the asset's skeleton. A mesh without normals gets smooth ones. Parts
/// on the head bone or below turn, parts on the neck above turn half as far, the rest stays: since all is drawn under
/// the head's pose, these are turned back here.
[[nodiscard]] SolidMesh body_mesh(const importer::SourceModel& model, const importer::SourceMesh& mesh,
                                  const Eigen::Vector3f& head_joint, const BodyTurn& pose = {});

/// For each vertex of a body its share of the head's turn, 0..1: 1 on the head bone or below, half on the neck above.
/// Empty where nothing follows that bone, and all turns.
[[nodiscard]] std::vector<float> turning_shares(const importer::SourceModel& model, const importer::SourceMesh& mesh,
                                                const std::string& head_bone);

/// Reduces the head's whole turn to each vertex' share of it, for vertices that are drawn under the head's pose. Empty
/// `shares` change nothing.
void turn_back(std::span<const float> shares, const Quat& turn, std::span<SolidVertex> vertices);

/// For each material of a source its base texture, null where none is known.
using BodyTextures = std::vector<std::shared_ptr<const SolidTexture>>;

/// Gives a mesh of body_mesh() its texture, and the material's own colour with it.
void dress(const importer::SourceModel& model, const importer::SourceMesh& mesh, const BodyTextures& textures,
           SolidMesh& solid);

/// Every patch of a level as a surface of its own, without its texture's holes, in colours that differ most between
/// patches that follow each other in the draw order, so that wrong joins and cuts are seen at a glance. Skinned with
/// `palette`, one matrix per bone; head space, metres.
[[nodiscard]] std::vector<SolidMesh> patch_surfaces(const Asset& asset, std::span<const Mat34> palette,
                                                    std::uint32_t lod);

/// Paints one of `patches` red and all others grey.
void mark_patch(std::size_t marked, std::span<SolidMesh> patches);

// The surroundings of the hair in a picture: background and opaque bodies.

/// Draws into the bound sRGB framebuffer. Its objects are freed with the OpenGL context.
class StageRenderer {
 public:
  /// `shadow`: the one for draw_bodies(), or null.
  static tl::expected<StageRenderer, ToolError> create(std::span<const SolidMesh> meshes,
                                                       const HairShadow* shadow = nullptr, const BodyLook& look = {});

  /// Frees them before that.
  void destroy();

  /// Replaces the vertices of mesh `mesh` by as many others.
  void move(std::size_t mesh, std::span<const SolidVertex> vertices) const;

  /// Clears depth and fills the picture.
  void draw_backdrop(const Backdrop& backdrop = {}) const;

  /// Draws every mesh once, lit by directional `lights`, under the head's pose. `shadow` is the first light's.
  void draw_bodies(const Camera& camera, const HeadPose& head, std::span<const Light> lights,
                   const HairShadow* shadow = nullptr) const;

  /// Draws their depth alone, so that the hair behind them is hidden, with OpenGL's initial colour mask.
  void cut_out_bodies(const Camera& camera, const HeadPose& head) const;

  /// Draws ghosts over all else, a single layer that one can see through: what is behind their nearest surface is not
  /// hidden by it.
  void draw_ghosts(const Camera& camera, const HeadPose& head, std::span<const Light> lights) const;

  /// Draws bodies without colour, for the bound shadow's depth.
  void draw_casters(const Eigen::Matrix4f& clip_from_world, const HeadPose& head) const;

 private:
  void set_placement(const Eigen::Matrix4f& clip_from_world, const HeadPose& head) const;
  void draw_meshes(bool ghosts = false) const;

  struct Body {
    std::uint32_t vertex_array = 0;
    std::uint32_t buffers[2] = {};
    std::int32_t index_count = 0;
    std::uint32_t texture = 0;
    Eigen::Vector3f color;
    float alpha_cutoff = 0;
    float roughness = 1;
    bool is_ghost = false;
  };
  [[nodiscard]] std::uint32_t texture_of(const SolidMesh& mesh);

  std::uint32_t backdrop_program_ = 0;
  std::uint32_t body_program_ = 0;
  std::uint32_t empty_vertex_array_ = 0;
  std::vector<Body> bodies_;
  /// One for each image, whatever number of meshes shows it; null: white.
  std::map<std::shared_ptr<const SolidTexture>, std::uint32_t> textures_;
  BodyLook look_;
};

/// The ball around heads at these places (world, metres) of which each has these points (from its place); neither may
/// be empty. With room for hair that swings.
[[nodiscard]] ShadowBall ball_around(std::span<const Eigen::Vector3d> points, std::span<const Eigen::Vector3d> places);

/// The key light's shadow in a picture: of hair and bodies, on both. The context must be current as long as it lives.
class StudioShadow {
 public:
  StudioShadow(StudioShadow&&) noexcept = default;
  StudioShadow& operator=(StudioShadow&&) = delete;
  ~StudioShadow();

  /// Error: kUnsupported where the driver has no memory for it. `renderer` must outlive this object.
  static tl::expected<StudioShadow, ToolError> create(HairRenderer& renderer, const GlLoader& loader,
                                                      const ShadowDesc& desc);

  /// Draws the map. `crowd` may be null: hair casts none. Leaves no framebuffer bound.
  Status draw(const Light& light, const ShadowBall& ball, const StageRenderer& stage, std::span<const HeadPose> heads,
              const ShadowCrowd* crowd);

  [[nodiscard]] const HairShadow& shadow() const { return *shadow_; }

 private:
  StudioShadow() = default;

  std::unique_ptr<HairShadow> shadow_;
};

/// The mode draws some of a pixel's samples (alpha to coverage), so there should be more than one.
[[nodiscard]] inline bool covers_samples(const TransparencyMode& mode) {
  return &mode == &kCoverageMode || &mode == &kProportionalMode || &mode == &kJitteredMode;
}

}  // namespace coif::render
