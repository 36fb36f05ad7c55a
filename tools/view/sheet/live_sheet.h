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
  std::vector<LiveMoment> moments;  ///< For a tile whose motion plays; empty: it stands still.
};

struct LiveGallery {
  std::string title;
  std::vector<LiveTile> tiles;
};

/// Galleries in the form that the page of `coif view` can show.
struct LiveSheet {
  std::vector<LiveGallery> galleries;
  /// What happened to pictures without a tile of their own, in a sentence or two; empty: all have one.
  std::string note;
  std::size_t tiles = 0;
  std::size_t pictures_left_out = 0;  ///< Pictures that no tile shows.
};

/// One tile for each picture, but one for all moments of a motion, framed so that all of it is seen. Errors: those of
/// frame_picture().
[[nodiscard]] tl::expected<LiveSheet, ToolError> live_sheet(const Asset& asset,
                                                            std::span<const render::Gallery> galleries);

/// The size of one tile, in pixels of the page.
struct TileSize {
  std::uint32_t width = 0, height = 0;
};

/// JSON for a script element: {"width", "height", "note", "galleries": [{"title", "tiles": [{"caption", "settings":
/// {name: number, word or three numbers}, "moments": [{"caption", "seconds"}]}]}]}. `settings` has the differences from
/// the asset's own, by the names of controls_json().
[[nodiscard]] std::string sheet_json(const Asset& asset, const LiveSheet& sheet, TileSize size);

}  // namespace coif::view
