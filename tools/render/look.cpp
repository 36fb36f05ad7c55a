#include "render/gallery.h"

#include "base/color_texels.h"
#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace coif::render {
namespace {

constexpr std::uint32_t kColumns = 5;

struct Side {
  const char* name;
  double yaw_degrees, pitch_degrees;
};

constexpr Side kSides[] = {
    {"front", 0, 5}, {"left side", 90, 5}, {"back", 180, 5}, {"right side", -90, 5}, {"from above", 0, 70}};

PictureSettings seen_from(PictureSettings picture, const Side& side) {
  picture.yaw_degrees = side.yaw_degrees;
  picture.pitch_degrees = side.pitch_degrees;
  return picture;
}

Gallery from_all_sides(const std::string& title, const PictureSettings& picture) {
  Gallery gallery{0, title, {}};
  for (const Side& side : kSides) gallery.pictures.push_back({side.name, seen_from(picture, side)});
  return gallery;
}

struct Moment {
  const char* caption;
  motion::Motion motion;
  double time, yaw_degrees;
};

constexpr Moment kMoments[] = {{"turn, 0.4 s", motion::Motion::kTurn, 0.4, 30},
                               {"nod, 0.4 s", motion::Motion::kNod, 0.4, 75},
                               {"charge, 0.5 s", motion::Motion::kCharge, 0.5, 75}};

/// One row: the colliders from two sides, and moments of motions where anything moves.
Gallery colliders_and_motion(const Asset& asset, const PictureSettings& picture) {
  Gallery gallery{0, "Colliders through the hair", {}};
  PictureSettings colliders = picture;
  colliders.colliders = true;
  for (const Side& side : std::span(kSides).first(2)) {
    gallery.pictures.push_back({side.name, seen_from(colliders, side)});
  }
  if (asset.chains().empty()) return gallery;
  gallery.title += "; in motion";
  PictureSettings moving = picture;
  for (const Moment& moment : kMoments) {
    moving.motion = moment.motion;
    moving.time = moment.time;
    moving.yaw_degrees = moment.yaw_degrees;
    gallery.pictures.push_back({moment.caption, moving});
  }
  return gallery;
}

/// Few samples and no shadows: drawn in software, those take most of the time, and show little of what a cook decides.
std::vector<Gallery> what_to_look_at(const Asset& asset, const LookSettings& settings) {
  PictureSettings picture;
  picture.width = settings.width;
  picture.height = settings.height;
  picture.warm_up = false;
  picture.edge_samples = 1;
  picture.coarse_mannequin = true;
  PictureSettings part = picture;
  part.oversampling = 2;
  part.ghost = settings.rest;
  const std::string title = settings.title + (settings.rest ? "; what is not hair is like glass" : "");
  std::vector<Gallery> galleries{from_all_sides(title, part)};
  part = picture;
  part.component = Component::kDirection;
  galleries.push_back(from_all_sides("Strands: green at the root, red at the tip, spikes point to the tip", part));
  part = picture;
  part.patches = true;
  galleries.push_back(from_all_sides("Patches, each in a colour", part));
  galleries.push_back(colliders_and_motion(asset, picture));
  return galleries;
}

/// As much of the texture as a tile shows, and its alpha alone beside it.
std::vector<SheetTile> base_texture(const Asset& asset, const LookSettings& settings) {
  const TextureRecord* const texture = asset.texture(TextureRole::kBaseColor);
  if (texture == nullptr) return {};
  const std::vector<std::byte> texels = color_texels(asset, *texture, 0);
  SheetTile color{fmt::format("{} x {} texels", texture->width, texture->height), {}}, alpha{"alpha", {}};
  for (SheetTile* tile : {&color, &alpha}) {
    tile->picture.width = settings.width;
    tile->picture.height = settings.height;
  }
  for (std::uint32_t y = 0; y < settings.height; ++y) {
    for (std::uint32_t x = 0; x < settings.width; ++x) {
      const std::size_t at = std::size_t(y) * texture->height / settings.height * texture->width +
                             std::size_t(x) * texture->width / settings.width;
      const auto channel = [&](std::size_t c) { return std::to_integer<std::uint8_t>(texels[4 * at + c]); };
      color.picture.rgba.insert(color.picture.rgba.end(), {channel(0), channel(1), channel(2), 255});
      alpha.picture.rgba.insert(alpha.picture.rgba.end(), {channel(3), channel(3), channel(3), 255});
    }
  }
  return {std::move(color), std::move(alpha)};
}

}  // namespace

tl::expected<GallerySheet, ToolError> render_look(const Asset& asset, const LookSettings& settings,
                                                  const std::function<void(const std::string&)>& progress) {
  if (const auto checked = check_tile_size(settings.width, settings.height); !checked)
    return tl::unexpected(checked.error());
  std::vector<SheetSection> last;
  if (auto tiles = base_texture(asset, settings); !tiles.empty()) last.push_back({"Base texture", std::move(tiles)});
  for (const std::string& told : settings.told) last.push_back({printable_ascii(told), {}});
  return draw_sheet(asset, what_to_look_at(asset, settings), kColumns, std::move(last), progress);
}

}  // namespace coif::render
