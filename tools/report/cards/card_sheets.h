#pragma once

#include "cards/card_surface.h"
#include "groom/groom.h"
#include "platform/stop.h"
#include "render/picture.h"
#include "report/cards/cards_report.h"
#include "report/cards/groom_views.h"

#include <cstdint>
#include <string>
#include <vector>

namespace coif::report {

// One surface as tiles of a contact sheet.

/// Lit from the eye, and darker the farther behind.
[[nodiscard]] render::Picture hair_tile(const cards::HairPicture& hair, const cards::PictureFrame& frame);

/// The seen picture minus the wanted one: red where a surface is too bright, or wrongly there; blue where it is
/// missing.
[[nodiscard]] render::Picture difference_tile(const cards::HairPicture& wanted, const cards::HairPicture& seen);

/// Its triangles without their texture, solid, each outlined.
[[nodiscard]] render::Picture wire_tile(const cards::CardSurface& surface, const cards::PictureFrame& frame);

/// Its texture's opacity, white on black, reduced to `size` pixels in each direction.
[[nodiscard]] render::Picture texture_tile(const cards::CardSurface& surface, std::uint32_t size);

/// Strands beside sets of cards, from the front, a side and the back.
class CardSheets {
 public:
  /// The first arguments as in frames_around() and GroomViews; `faces_backwards`: the hair's front is towards -Z.
  CardSheets(const groom::Groom& groom, float width, const Eigen::Matrix3f& turn, bool faces_backwards,
             const platform::Threads& threads);

  /// In the order of the sheet.
  void add(const std::string& caption, const cards::CardSurface& surface);

  /// One sheet for each side, and one of textures.
  [[nodiscard]] std::vector<ReportSheet> finish() const;

 private:
  /// All sets of cards, from one side.
  struct Side {
    std::vector<render::Picture> hair, wires, differences;
  };

  platform::Threads threads_;
  GroomViews views_;
  std::vector<std::string> captions_;
  std::vector<Side> sides_;
  std::vector<render::Picture> textures_;
};

}  // namespace coif::report
