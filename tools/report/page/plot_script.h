#pragma once

#include "report/page/plot.h"

#include <string>

namespace coif {

/// The plot as a gnuplot 5 script that writes SVG to its standard output. The data are in it; texts are quoted so that
/// gnuplot expands nothing in them.
[[nodiscard]] std::string plot_script(const Plot& plot);

}  // namespace coif
