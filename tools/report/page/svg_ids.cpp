#include "report/page/svg_ids.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace coif {
namespace {

// What an id stands behind, as gnuplot and most others write it.
constexpr std::string_view kBeforeId[] = {" id='",     " id=\"",   "xlink:href='#", "xlink:href=\"#",
                                          " href=\"#", " href='#", "url(#"};

std::string scoped_tag(std::string_view tag, std::string_view prefix) {
  std::string result;
  while (!tag.empty()) {
    const auto* const found =
        std::ranges::find_if(kBeforeId, [tag](std::string_view before) { return tag.starts_with(before); });
    const bool hit = found != std::end(kBeforeId);
    const std::size_t length = hit ? found->size() : 1;
    result += tag.substr(0, length);
    if (hit) result += prefix;
    tag.remove_prefix(length);
  }
  return result;
}

}  // namespace

std::string scope_svg_ids(std::string_view svg, std::string_view prefix) {
  std::string result;
  while (!svg.empty()) {
    const std::size_t open = std::min(svg.find('<'), svg.size());
    result += svg.substr(0, open);
    svg.remove_prefix(open);
    const std::size_t close = std::min(svg.find('>'), svg.size());
    result += scoped_tag(svg.substr(0, close), prefix);
    svg.remove_prefix(close);
  }
  return result;
}

}  // namespace coif
