#pragma once

#include "base/tool_error.h"
#include "groom/groom.h"
#include "report/cards/cards_report.h"

#include <coif/asset.h>

#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace coif::report {

inline constexpr std::uint32_t kLeastCardsPicture = 16, kMostCardsPicture = 512;  ///< Pixels each way, from afar.

struct CardsSettings {
  std::vector<std::size_t> budgets{1000, 2000, 4000, 8000, 16000};  ///< Triangles of each set of cards, 2 at least.
  std::size_t directions = 32;                                      ///< View directions, 1 at least.
  std::uint32_t size = 256;  ///< Pixels of a picture from afar, each way; a close-up has four times as many.
  bool sheets = false;       ///< Also make the pictures of the page.
  bool ablation = false;     ///< Also fill CardsReport::ablation.

  // The next values come from the recipe.
  std::size_t texels = 7 * (std::size_t{1} << 18);  ///< Per set of cards.
  int rounds = 6;                                   ///< CardsBudget::rounds.
  float strand_width = 0;                           ///< Metres; CardsBudget::strand_width.
  float caps = 0.04f;                               ///< CardsBudget::caps.
  std::optional<std::size_t> wisps = {};            ///< CardsBudget::wisps.
};

/// Makes cards of `groom` for each budget, coif's own and the baselines, and compares all of them and the asset, which
/// was cooked from that groom, with the strands. `groom_hash`: XXH64 of its file. Errors: kUsage for settings out of
/// range; kBadInput for an asset without a mesh or from other strands; kOverBudget where no cards can be made at all.
tl::expected<CardsReport, ToolError> measure_cards(const Asset& asset, const groom::Groom& groom,
                                                   std::uint64_t groom_hash, const CardsSettings& settings,
                                                   const ReportProgress& progress);

}  // namespace coif::report
