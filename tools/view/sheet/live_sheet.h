#pragma once

#include "base/tool_error.h"
#include "render/gallery.h"
#include "view/page/view_settings.h"

#include <coif/asset.h>

#include <tl/expected.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace coif::view {

/// A time of a motion that a sheet has a picture of.
struct LiveMoment {
  std::string caption;
  double seconds = 0;
};

struct LiveTile {
  std::string caption;
  ViewSettings settings;
  std::vector<LiveMoment> moments;  ///< Of a tile whose motion plays; empty: it holds still.
};

struct LiveGallery {
  std::string title;
  std::vector<LiveTile> tiles;
};

/// Galleries as far as the page of `coif view` can show them.
struct LiveSheet {
  std::vector<LiveGallery> galleries;
  std::string
      note;  ///< What became of pictures that have no tile of their own, in a sentence or two; empty: all have one.
  std::size_t tiles = 0;
  std::size_t pictures_left_out = 0;  ///< That no tile shows.
};

/// One tile for each picture, but one for all moments of a motion, framed so that all of it is seen. Errors: those of
/// frame_picture().
[[nodiscard]] tl::expected<LiveSheet, ToolError> live_sheet(const Asset& asset,
                                                            std::span<const render::Gallery> galleries);

/// Of one tile, in pixels of the page.
struct TileSize {
  std::uint32_t width = 0, height = 0;
};

/// As JSON that may stand between the tags of a script: {"width", "height", "note", "galleries": [{"title", "tiles":
/// [{"caption", "settings": {name: number, word or three numbers}, "moments": [{"caption", "seconds"}]}]}]}. `settings`
/// has what differs from the asset's own, by the names of controls_json().
[[nodiscard]] std::string sheet_json(const Asset& asset, const LiveSheet& sheet, TileSize size);

}  // namespace coif::view
