#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace coif::report {

/// A self-contained HTML document: no file beside it, no network. Its own policy forbids a browser to fetch any, and to
/// run any script but the page's. A script draws `report`, which has a "title", by the layout; both are in the page as
/// JSON. Readable on light and dark screens and on paper.
///
/// `layout`: JSON, a list of parts as in page_layout.schema.json.
[[nodiscard]] std::string page_html(const nlohmann::ordered_json& report, const char* layout);

// Links from a report to the page of `coif view`.

/// The settings of a link to the page of `coif view`, by the words of its controls; empty, or a rate of 0: the default.
struct ViewLink {
  std::string motion{}, solver{}, beside{};
  double rate = 0;  ///< Steps a second.
};

/// The relative URL of `target` for a page at `from`. Names may contain any byte.
[[nodiscard]] std::string relative_url(const std::filesystem::path& target, const std::filesystem::path& from);

/// `page`, a URL, with these settings; a motion plays.
[[nodiscard]] std::string view_url(const std::string& page, const ViewLink& link);

}  // namespace coif::report
