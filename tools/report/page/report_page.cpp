#include "report/page/report_page.h"

#include "base/text.h"

#include <map>
#include <string_view>

// embed.cmake makes these of page.html, page.css, Chart.js and script/.
extern "C" {
extern const char coif_page_html[];
extern const char coif_page_css[];
extern const char coif_page_charts[];
extern const char coif_page_charts_hash[];
extern const char coif_page_script[];
extern const char coif_page_script_hash[];
}

namespace coif::report {
namespace {

/// JSON for an element <script>: no text in it can end the element.
std::string script_data(std::string json) {
  for (std::size_t at = json.find('<'); at != std::string::npos; at = json.find('<', at + 1)) {
    json.replace(at, 1, "\\u003c");
  }
  return json;
}

/// `text` with each "@NAME@" replaced once; inserted text is not scanned.
std::string filled(std::string_view text, const std::map<std::string_view, std::string>& values) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = text.find('@', at);
    if (begin == std::string_view::npos) return result.append(text.substr(at));
    const std::size_t end = text.find('@', begin + 1);
    result.append(text.substr(at, begin - at));
    result += values.at(text.substr(begin + 1, end - begin - 1));
    at = end + 1;
  }
  return result;
}

}  // namespace

std::string page_html(const nlohmann::ordered_json& report, const char* layout) {
  using nlohmann::ordered_json;
  const bool has_charts = std::string_view(layout).find("\"chart\"") != std::string_view::npos;
  const std::string data = report.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  const std::string hashes =
      has_charts ? coif_page_charts_hash + (" " + std::string(coif_page_script_hash)) : coif_page_script_hash;
  return filled(coif_page_html, {{"TITLE", markup_text(report.at("title").get<std::string>())},
                                 {"HASHES", hashes},
                                 {"STYLE", coif_page_css},
                                 {"REPORT", script_data(data)},
                                 {"LAYOUT", script_data(layout)},
                                 {"CHARTS", has_charts ? coif_page_charts : ""},
                                 {"SCRIPT", coif_page_script}});
}

}  // namespace coif::report
