#pragma once

#include <string>
#include <string_view>

namespace coif {

/// Puts `prefix` before every id of an SVG element and before every reference to one, so that several can stand in one
/// document. Text between tags stays as it is.
[[nodiscard]] std::string scope_svg_ids(std::string_view svg, std::string_view prefix);

}  // namespace coif
