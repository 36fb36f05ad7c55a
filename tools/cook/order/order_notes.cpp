#include "cook/order/choose_order.h"

#include <fmt/format.h>

#include <string>

namespace coif::cook {
namespace {

std::string quality_text(const visibility::OrderQuality& quality) {
  return fmt::format("{:.1f} dB (median {:.1f}, worst {:.1f}, moving {:.1f})", quality.psnr, quality.median,
                     quality.worst, quality.moving);
}

}  // namespace

void note_crossings(const Crossings& crossings, std::size_t triangles, Findings& findings) {
  if (crossings.pairs == 0) return;
  std::string text =
      fmt::format("crossings: {} pairs of triangles change places within a picture, {:.0f} % of what wrong order costs",
                  crossings.pairs, 100 * crossings.share);
  if (crossings.cut) {
    text +=
        fmt::format("; {} cuts add {} triangles ({:.1f} %), for {:.1f} dB", crossings.cut->cuts, crossings.cut->added,
                    100 * double(crossings.cut->added) / double(triangles), crossings.cut->gain);
  } else {
    text += "; none are cut, which would gain too little";
  }
  findings.note(text);
}

void note_orders(const visibility::FoundOrders& found, float usual_threshold, Findings& findings) {
  const std::size_t count = found.by_view.orders.size();
  const std::string what = count > 0 ? fmt::format("{} orders of triangles by direction", count)
                                     : std::string("one order of patches for all directions");
  findings.note(
      fmt::format("draw order: {}, faces {}; expected against exact order {}; by distance from the head {}, the best "
                  "single order of patches {}",
                  what, found.rule.faces_together ? "together" : "apart", quality_text(found.found),
                  quality_text(found.head), quality_text(found.single)));
  if (found.rule.opaque_threshold != usual_threshold) {
    findings.note(fmt::format(
        "opaque threshold {:.2f}, not {:.2f}: hair drawn in its orders looks most like the exact picture for what "
        "it costs, {:.1f} dB for each layer of a pixel that is blended; {:.1f} are, and the best order has {:.1f} dB",
        found.rule.opaque_threshold, usual_threshold, kGainPerLayer, found.found.blended, found.limit));
  }
}

OrderFigures figures_of(const visibility::FoundOrders& found, const Crossings& crossings) {
  OrderFigures figures;
  figures.orders = std::uint32_t(1 + found.by_view.orders.size());
  figures.psnr = found.found.psnr;
  figures.median = found.found.median;
  figures.worst = found.found.worst;
  figures.moving = found.found.moving;
  figures.crossings = std::uint32_t(crossings.pairs);
  if (crossings.cut) {
    figures.cuts = std::uint32_t(crossings.cut->cuts);
    figures.added = std::uint32_t(crossings.cut->added);
    figures.cut_gain = crossings.cut->gain;
  }
  return figures;
}

}  // namespace coif::cook
