#include "report/cards/card_sheets.h"

#include "base/encodings.h"
#include "cards/hair_picture.h"
#include "render/gallery.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace coif::report {
namespace {

constexpr std::uint32_t kTileSize = 384;  // pixels
constexpr std::uint32_t kColumns = 4;     // As many as a page shows without scaling.

struct ShownSide {
  const char* name;
  Eigen::Vector3f towards;
};
const std::array<ShownSide, 3>& shown_sides() {
  static const std::array<ShownSide, 3> sides{{{"front", {0, 0, -1}}, {"side", {-1, 0, 0}}, {"back", {0, 0, 1}}}};
  return sides;
}

std::vector<cards::PictureFrame> frames_of_sides(const groom::Groom& groom, const Eigen::Matrix3f& turn,
                                                 bool faces_backwards) {
  std::vector<Eigen::Vector3f> directions;
  for (const ShownSide& side : shown_sides()) directions.push_back(faces_backwards ? -side.towards : side.towards);
  std::vector<cards::PictureFrame> frames = frames_around(groom, turn, directions, kTileSize);
  for (cards::PictureFrame& frame : frames) frame = closer(frame, groom);
  return frames;
}

render::SheetSection row_of(std::string title, const std::vector<std::string>& captions,
                            const std::vector<render::Picture>& pictures) {
  render::SheetSection section{std::move(title), {}};
  for (std::size_t i = 0; i < pictures.size(); ++i) section.tiles.push_back({captions[i], pictures[i]});
  return section;
}

ReportSheet sheet_of(std::string caption, std::span<const render::SheetSection> sections) {
  const render::Picture sheet = render::contact_sheet(sections, kColumns);
  return {std::move(caption), encode_png(sheet.rgba, sheet.width, sheet.height)};
}

}  // namespace

CardSheets::CardSheets(const groom::Groom& groom, float width, const Eigen::Matrix3f& turn, bool faces_backwards,
                       const platform::Threads& threads)
    : threads_(threads),
      views_(groom, width, frames_of_sides(groom, turn, faces_backwards), threads),
      sides_(views_.count()) {}

void CardSheets::add(const std::string& caption, const cards::CardSurface& surface) {
  captions_.push_back(caption);
  textures_.push_back(texture_tile(surface, kTileSize));
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const cards::HairPicture seen = cards::draw_cards(surface, views_.frame(i), threads_);
    sides_[i].hair.push_back(hair_tile(seen, views_.frame(i)));
    sides_[i].wires.push_back(wire_tile(surface, views_.frame(i)));
    sides_[i].differences.push_back(difference_tile(views_.strands(i), seen));
  }
}

std::vector<ReportSheet> CardSheets::finish() const {
  if (captions_.empty()) return {};
  std::vector<ReportSheet> sheets;
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const Side& side = sides_[i];
    render::SheetSection hair = row_of(shown_sides()[i].name, captions_, side.hair);
    hair.tiles.insert(hair.tiles.begin(), {"strands", hair_tile(views_.strands(i), views_.frame(i))});
    const render::SheetSection sections[] = {
        std::move(hair), row_of("difference: red too bright or too much, blue missing", captions_, side.differences),
        row_of("triangles, without their texture", captions_, side.wires)};
    sheets.push_back(sheet_of(fmt::format("From the {}.", shown_sides()[i].name), sections));
  }
  const render::SheetSection textures[] = {row_of("textures: what of each texel strands cover", captions_, textures_)};
  sheets.push_back(sheet_of("What lies on the cards, all on one texture.", textures));
  return sheets;
}

}  // namespace coif::report
