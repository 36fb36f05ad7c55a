#pragma once

#include "report/page/draw_plot.h"
#include "report/page/html_page.h"

#include <tl/expected.hpp>

#include <string>
#include <string_view>

namespace coif {

/// A page under way whose figures gnuplot draws. After the first that fails the rest is skipped, and there is no page.
class PlottedPage : public HtmlPage {
 public:
  /// `plotter` must outlive this object.
  PlottedPage(std::string_view title, const Plotter& plotter) : HtmlPage(title), plotter_(plotter) {}

  void plot(const Figure& figure);

  /// The whole document. Errors: those of draw().
  [[nodiscard]] tl::expected<std::string, ToolError> finish() const;

 private:
  const Plotter& plotter_;
  tl::expected<void, ToolError> drawn_;
};

}  // namespace coif
