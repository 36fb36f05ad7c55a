#pragma once

#include "report/page/plot.h"
#include "tool_error.h"

#include <tl/expected.hpp>

#include <chrono>
#include <string>

namespace coif {

/// The program that draws.
struct Plotter {
  std::string program = "gnuplot";                                ///< A name in PATH, or a path.
  std::chrono::milliseconds patience = std::chrono::seconds(20);  ///< Per plot; then it is killed.
};

/// Draws by gnuplot in a child process that reads its script and writes its picture through pipes and can write no
/// file. Returns an <svg> element for HtmlPage::figure(); its lines and letters take the page's colour. Errors:
/// kUnsupported with the cure where gnuplot is not installed, kInternal where it fails or takes too long.
tl::expected<std::string, ToolError> draw(const Plot& plot, const Plotter& plotter = {});

/// Tells before long work whether draw() will find its program. Errors: those of draw().
tl::expected<void, ToolError> check_plotter(const Plotter& plotter = {});

}  // namespace coif
