#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace coif::report {

/// One HTML document that needs nothing but itself: no file beside it, no network; its own policy forbids a browser to
/// fetch any, and to run any script but the page's. A script draws `report`, which has a "title", as the layout says;
/// both lie in the page as JSON. Readable on light and dark screens and on paper.
///
/// `layout`: JSON, a list of parts as page_layout.schema.json has them.
[[nodiscard]] std::string page_html(const nlohmann::ordered_json& report, const char* layout);

// Links from a report to the page of `coif view`.

/// What a link sets on the page of `coif view`, by the words of its controls; empty, or a rate of 0: as the page comes.
struct ViewLink {
  std::string motion{}, solver{}, beside{};
  double rate = 0;  ///< Steps a second.
};

/// Where `target` lies, as a page at `from` links it: relative, as a URL. Any byte may be in a name.
[[nodiscard]] std::string relative_url(const std::filesystem::path& target, const std::filesystem::path& from);

/// `page`, a URL, with these settings; a motion plays.
[[nodiscard]] std::string view_url(const std::string& page, const ViewLink& link);

}  // namespace coif::report
