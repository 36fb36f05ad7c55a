#include "report/page/plotted_page.h"

namespace coif {

void PlottedPage::plot(const Figure& figure) {
  if (!drawn_) return;
  const auto svg = draw(figure.plot, plotter_);
  if (svg) {
    HtmlPage::figure(*svg, figure.caption);
  } else {
    drawn_ = tl::unexpected(svg.error());
  }
}

tl::expected<std::string, ToolError> PlottedPage::finish() const {
  if (!drawn_) return tl::unexpected(drawn_.error());
  return text();
}

}  // namespace coif
