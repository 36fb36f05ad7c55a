#include "report/cards/cards_report.h"

#include <fmt/format.h>

#include <algorithm>

namespace coif::report {
namespace {

const CardsSummary* find_cards(const CardsReport& report, const std::string& baseline, std::uint64_t triangles) {
  const auto found = std::ranges::find_if(report.summary, [&](const CardsSummary& summary) {
    return summary.baseline == baseline && summary.triangles == triangles;
  });
  return found == report.summary.end() ? nullptr : &*found;
}

/// The last set of coif's own cards, which usually has the most triangles.
const CardsSummary* find_finest(const CardsReport& report) {
  const CardsSummary* finest = nullptr;
  for (const CardsSummary& summary : report.summary) {
    if (summary.baseline == "none" && (finest == nullptr || summary.triangles > finest->triangles)) finest = &summary;
  }
  return finest;
}

std::string nearness_text(const CardsFigures& figures) {
  return fmt::format("coverage IoU {:.3f} (worst {:.3f}), PSNR {:.1f} dB (worst {:.1f})", figures.mean_iou,
                     figures.worst_iou, figures.mean_psnr_db, figures.worst_psnr_db);
}

}  // namespace

std::string cards_name(const std::string& baseline) { return baseline == "none" ? "coif" : baseline; }

std::string cards_summary(const CardsReport& report) {
  const CardsSummary* const own = find_finest(report);
  if (own == nullptr) return "No cards of coif's own were made.";
  std::string text = fmt::format("With {} triangles coif's cards have {}", own->triangles, nearness_text(own->figures));
  for (const char* const baseline : {"kmeans", "even"}) {
    if (const CardsSummary* const other = find_cards(report, baseline, own->triangles)) {
      text += fmt::format("; {}, fitted alike: {:.3f}, {:.1f} dB", baseline, other->figures.mean_iou,
                          other->figures.mean_psnr_db);
    }
  }
  text += ".";
  if (report.asset.empty()) return text;
  const CardsAssetLevel& finest = report.asset.front();
  return text + fmt::format(" The asset, with {} triangles and {} texels, has {}.", finest.triangles, finest.texels,
                            nearness_text(finest.figures));
}

std::string cards_method(const CardsReport& report) {
  std::string text = fmt::format(
      "{} strands of {}, {:.3g} wide in the file's metres, by 64 samples of a pixel, and cards by 16, along {} "
      "directions "
      "all around, in pictures of {} x {} pixels, with mips and thresholds of opacity as in an asset; close up, along "
      "every fourth of them, in pictures of {} x {}. IoU: of coverage, intersection over union. PSNR and RMS error: of "
      "what a light at the eye shows of strands, over the pixels that either covers; 1 is white.",
      report.strands, report.source, report.strand_width, report.directions, report.size, report.size,
      report.close_size, report.close_size);
  if (!report.is_its_source) text += " The asset was cooked from another file, or from another state of this one.";
  if (report.asset_factor != 1) {
    text += fmt::format(" The cook multiplied lengths with {:g}, which is undone here.", report.asset_factor);
  }
  return text;
}

nlohmann::ordered_json cards_json(const ReportHeading& heading, const CardsReport& report) {
  nlohmann::ordered_json json = heading_json(heading);
  json["source"] = report.source;
  json["is_its_source"] = report.is_its_source;
  json["strands"] = report.strands;
  json["strand_width"] = number_json(report.strand_width);
  json["size"] = report.size;
  json["close_size"] = report.close_size;
  json["directions"] = report.directions;
  json["asset_factor"] = number_json(report.asset_factor);
  add_list(json, "rows", cards_columns(), report.rows);
  add_list(json, "summary", cards_summary_columns(), report.summary);
  add_list(json, "ablation", cards_ablation_columns(), report.ablation);
  add_list(json, "asset_levels", cards_asset_columns(), report.asset);
  json["left_out"] = json_list(cards_left_out_columns(), report.left_out);
  add_sheets(json, report.sheets);
  json["notes"] = {{"method", cards_method(report)}};
  end_report(json, heading, "cards", "How far cards are from strands", cards_summary(report));
  return json;
}

std::string cards_text(const ReportHeading& heading, const CardsReport& report) {
  std::string text = heading_text(heading) + "\n  " + cards_method(report) + "\n";
  text += text_table(cards_summary_columns(), report.summary);
  if (!report.ablation.empty()) text += text_table(cards_ablation_columns(), report.ablation);
  text += text_table(cards_asset_columns(), report.asset);
  for (const CardsLeftOut& left_out : report.left_out) {
    text += fmt::format("  left out: {}, {} triangles: {}\n", cards_name(left_out.baseline), left_out.triangles,
                        left_out.why);
  }
  return text + cards_summary(report) + "\n";
}

}  // namespace coif::report
