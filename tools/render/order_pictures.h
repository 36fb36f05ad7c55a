#pragma once
// Pictures of one head of hair drawn in several ways, for comparing them pixel by pixel.

#include "base/tool_error.h"
#include "render/picture.h"
#include "render/stage_renderer.h"

#include <coif/asset.h>
#include <coif/renderer.h>

#include <Eigen/Core>
#include <tl/expected.hpp>

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <tuple>
#include <vector>

namespace coif::render {

/// The settings of one picture: model, view and mode. The head stands at the origin, unturned, so views are in head
/// space.
struct HairShot {
  std::size_t model = 0;  ///< From OrderPictures::add().
  const TransparencyMode* transparency = &kBlendMode;
  const MaterialRecord* material = nullptr;  ///< Instead of the asset's own, unless null.
  std::span<const Mat34> palette;            ///< Head space, one per bone.
  TriangleOrder* order = nullptr;            ///< Instead of the model's own orders, unless null.
  double yaw_degrees = 0;                    ///< As in PictureSettings.
  double pitch_degrees = 0;
  std::uint32_t width = 256, height = 256;  ///< Pixels, 16..8192.
  std::uint32_t samples = 1;                ///< Per pixel.
  std::uint32_t lod = 0;
};

/// Keeps an OpenGL context in which variants of an asset, such as its patches in another order, are drawn before the
/// studio's backdrop, over the head that its colliders outline, by the studio's lights and perspective camera.
class OrderPictures {
 public:
  /// `asset`: source of bones and colliders, which all variants share; not kept. Errors: kUnsupported without an EGL
  /// display with OpenGL ES 3.0, kBadInput for an asset without a mesh.
  static tl::expected<std::unique_ptr<OrderPictures>, ToolError> create(const Asset& asset,
                                                                        const RendererDesc& desc = {});
  ~OrderPictures();

  /// Uploads a variant, which may go afterwards, and returns its number. Error (kUnsupported): the driver refuses it.
  tl::expected<std::size_t, ToolError> add(const Asset& variant);
  /// Uploads another one in its place.
  tl::expected<void, ToolError> replace(std::size_t model, const Asset& variant);

  /// The picture's alpha is the share of each pixel that hair covers: the head and things behind it do not count.
  /// Errors: kBadInput, kUnsupported with the reason.
  tl::expected<Picture, ToolError> take(const HairShot& shot);

  /// Draws a frame as take() does, the hair alone, and waits for the device; for timing.
  tl::expected<void, ToolError> draw(const HairShot& shot);

  /// Position of a shot's camera in head space, metres.
  [[nodiscard]] Eigen::Vector3d eye(const HairShot& shot) const;
  /// The asset's own, or the default where it has none.
  [[nodiscard]] const MaterialRecord& material(std::size_t model) const;
  [[nodiscard]] std::string device() const;

 private:
  struct Device;
  OrderPictures();
  tl::expected<void, ToolError> draw_scene(const HairShot& shot, bool with_stage);

  std::vector<Eigen::Vector3d> points_;
  std::unique_ptr<Device> device_;
};

}  // namespace coif::render
