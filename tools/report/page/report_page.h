#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace coif::report {

/// One HTML document that needs nothing but itself: no file beside it, no network; its own policy forbids a browser to
/// fetch any, and to run any script but the page's. A script draws `report`, which has a "title", as the layout says;
/// both lie in the page as JSON. Readable on light and dark screens and on paper.
///
/// `layout`: JSON, a list of parts as page_layout.schema.json has them.
[[nodiscard]] std::string page_html(const nlohmann::ordered_json& report, const char* layout);

}  // namespace coif::report
