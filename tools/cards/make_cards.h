#pragma once

#include "base/tool_error.h"
#include "cards/card_surface.h"
#include "cards/card_texture.h"
#include "cards/choose_cards.h"
#include "cards/even_strands.h"
#include "cards/scalp_cards.h"
#include "groom/groom.h"
#include "import/source_model.h"
#include "platform/stop.h"

#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace coif::cards {

/// The budget of cards.
struct CardsBudget {
  std::size_t triangles = 8000;
  std::size_t texels = 7 * (std::size_t{1} << 18);  ///< With 20,000 triangles an asset has some 6 MB.
  int rounds = 6;                                   ///< Most rounds of fit_opacity().
  /// Metres, for strands whose groom has none; 0: so wide that they cover a head of their size as hair does.
  float strand_width = 0;
  /// Largest share of triangles and texels for cards that lie on the scalp (scalp_cards.h), 0..0.5.
  float caps = 0.04f;
  std::size_t levels = 1;    ///< Levels of detail of make_card_levels().
  double level_ratio = 0.5;  ///< Triangles of a level, against the next finer one.
  /// Most texels of the atlas in each direction; 0: any. It is larger if it would not hold all cards.
  std::uint32_t side = 0;
  /// Textures that all cards of a level share, of coarser ones by the ratio fewer; 0: each has its own; none: own ones
  /// if strands can be seen on them, else as few as make strands two texels wide (wisps_for()).
  std::optional<std::size_t> wisps = {};
  std::optional<CardsPlan> plan = {};  ///< How cards are made; none: as choose_plan() finds best (judge_cards.h).
};

/// A groom as cards are made from it.
struct GroomShape {
  std::vector<std::uint8_t> is_reversed;  ///< One for each strand: it begins with its tip.
  EvenStrands strands;                    ///< With a width.
  bool width_is_guessed = false;          ///< Neither the groom nor the caller gave it: usual_strand_width(), capped.
  bool width_is_capped = false;
};

[[nodiscard]] GroomShape shape_of(const groom::Groom& groom, float strand_width);

/// A strip for each wisp, and their textures in an atlas.
struct Cards {
  std::vector<Wisp> wisps;
  std::vector<CardStrip> strips;
  TextureShares shares;  ///< How the strips share `textures`.
  AtlasPlan plan;        ///< A place for each texture.
  std::vector<CardTexture> textures;
  CardsPlan made_by = {};  ///< Set by make_cards() and make_card_levels().
};

/// Textures for cards that are there. kOverBudget where the texels are too few for them.
[[nodiscard]] tl::expected<Cards, ToolError> texture_cards(const groom::Groom& groom, const GroomShape& shape,
                                                           ChosenCards cards, std::size_t texels,
                                                           const platform::Threads& threads);

/// Cards in place of the strands, of one level of detail. Repeats for equal input, whatever `threads` is. kOverBudget
/// where the budget is too small for the fewest cards that hold the hair.
[[nodiscard]] tl::expected<Cards, ToolError> make_cards(const groom::Groom& groom, const GroomShape& shape,
                                                        const CardsBudget& budget, const platform::Threads& threads);

/// As many levels of detail as the budget says, the finest first, each made from the strands. They share the texels, in
/// one atlas: a level is for pictures in which hair is smaller by the ratio of triangles, and has texels for these.
/// Levels end before one that would have no triangles.
[[nodiscard]] tl::expected<std::vector<Cards>, ToolError> make_card_levels(const groom::Groom& groom,
                                                                           const GroomShape& shape,
                                                                           const CardsBudget& budget,
                                                                           const platform::Threads& threads);

/// For drawing: strip by strip, two vertices at each of its stations.
[[nodiscard]] CardSurface surface_of(const Cards& cards);

/// Gives a surface mips and thresholds of opacity as a cook does (cook/texture): mips that cover as much as the
/// largest.
void draw_as_cooked(CardSurface& surface);

/// A model of strips with one texture in place of the strands, like an artist's model: the rest of a cook starts from
/// it. Coarser levels of detail are in SourceModel::coarser. Repeats for equal input, with any `threads`. kOverBudget
/// where the budget is too small for the fewest cards that hold the hair.
[[nodiscard]] tl::expected<importer::SourceModel, ToolError> model_of_cards(const groom::Groom& groom,
                                                                            const CardsBudget& budget,
                                                                            const platform::Threads& threads);

}  // namespace coif::cards
