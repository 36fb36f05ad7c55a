#include "cli/report_options.h"

#include "base/files.h"
#include "base/parallel_for.h"
#include "cli/input_files.h"
#include "groom/read_groom.h"
#include "payload_hash.h"

#include <fmt/format.h>

#include <utility>

namespace coif::cli {

tl::expected<ReportStrands, ToolError> read_report_strands(const ReportOptions& options, const Messages& messages) {
  const std::string& source = options.cards.source;
  if (!groom::has_strand_suffix(source)) {
    return usage(
        fmt::format("--source: {} is no file of strands; name one that is: {}", source, groom::strand_suffixes()));
  }
  report::CardsSettings settings = options.cards.settings;
  if (options.size_option->count() > 0) {
    if (options.size.width != options.size.height) return usage("--size: pictures of cards are as wide as high");
    settings.size = options.size.width;
  }
  const auto choice = choose_recipe(source, options.cards.recipe, messages);
  if (!choice) return tl::unexpected(choice.error());
  settings.texels = choice->recipe.cards_texels;
  if (const auto side = choice->recipe.texture_max_size)
    settings.texels = std::min<std::size_t>(settings.texels, std::size_t{*side} * *side);
  settings.rounds = int(choice->recipe.cards_rounds);
  settings.strand_width = float(choice->recipe.cards_strand_width);
  settings.caps = float(choice->recipe.cards_caps);
  settings.wisps = choice->recipe.cards_wisps;
  const auto bytes = FileBytes::read(source);
  if (!bytes) return tl::unexpected(bytes.error());
  auto groom = groom::read_groom(source, options.cards.limits.of_import(import_settings(choice->recipe, {}), messages));
  if (!groom) return tl::unexpected(groom.error());
  messages.tell(groom->warnings, source);
  return ReportStrands{std::move(*groom), xxh64(bytes->span()), std::move(settings)};
}

}  // namespace coif::cli
