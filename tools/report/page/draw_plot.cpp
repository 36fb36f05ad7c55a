#include "report/page/plot.h"

#include "base/text.h"
#include "report/page/child_program.h"

#include <fmt/format.h>

#include <cerrno>
#include <system_error>

namespace coif {
namespace {

tl::unexpected<ToolError> failed(ToolError::Kind kind, const Plotter& plotter, std::string_view what) {
  return tl::unexpected(ToolError{kind, fmt::format("{}: {}", plotter.program, what)});
}

/// What gnuplot said, shortened to a line.
std::string last_words(const ProgramResult& result) {
  const std::string text = clean_text(std::string_view(result.messages).substr(0, 300));
  return text.empty() ? "without a word" : text;
}

tl::expected<std::string, ToolError> run_plotter(const std::string& script, const Plotter& plotter) {
  // -d: no start-up files of the system or the user.
  const ProgramResult result = run_program({plotter.program, "-d"}, script, {plotter.patience});
  using End = ProgramResult::End;
  switch (result.end) {
    case End::kFinished:
      if (result.code == 0) return result.output;
      return failed(ToolError::Kind::kInternal, plotter,
                    fmt::format("ended with status {}: {}", result.code, last_words(result)));
    case End::kKilled:
      return failed(ToolError::Kind::kInternal, plotter, fmt::format("ended by signal {}", result.code));
    case End::kTooSlow:
      return failed(
          ToolError::Kind::kInternal, plotter,
          fmt::format("not ready after {} ms, killed; run it again on a less busy machine", plotter.patience.count()));
    case End::kTooMuchOutput: return failed(ToolError::Kind::kInternal, plotter, "its picture has no end");
    case End::kNotStarted: break;
  }
  if (result.code == ENOENT) {
    return failed(ToolError::Kind::kUnsupported, plotter,
                  "not found, and the page's plots need it; install it (apt-get install gnuplot-nox), or write .json");
  }
  return failed(ToolError::Kind::kInternal, plotter,
                fmt::format("cannot start: {}", std::generic_category().message(result.code)));
}

void erase_all(std::string& text, std::string_view begin, std::string_view end) {
  for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at)) {
    const std::size_t stop = text.find(end, at);
    if (stop == std::string::npos) return;
    text.erase(at, stop + end.size() - at);
  }
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
}

/// From gnuplot's file to an element of a page.
void adapt_to_page(std::string& svg) {
  svg.erase(0, svg.find("<svg"));
  // Browsers would show the titles, names of gnuplot's own, as a tip over each curve.
  erase_all(svg, "<title>", "</title>");
  erase_all(svg, "<desc>", "</desc>");
  for (const char quote : {'\'', '"'}) {
    for (const char* attribute : {"stroke", "fill", "color"}) {
      replace_all(svg, fmt::format("{0}={1}black{1}", attribute, quote),
                  fmt::format("{0}={1}currentColor{1}", attribute, quote));
    }
  }
}

}  // namespace

tl::expected<std::string, ToolError> draw(const Plot& plot, const Plotter& plotter) {
  auto svg = run_plotter(plot_script(plot), plotter);
  if (!svg) return svg;
  if (svg->find("<svg") == std::string::npos || svg->find("</svg>") == std::string::npos) {
    return failed(ToolError::Kind::kInternal, plotter, "wrote no picture; is it gnuplot 5 with its SVG terminal?");
  }
  adapt_to_page(*svg);
  return svg;
}

tl::expected<void, ToolError> check_plotter(const Plotter& plotter) {
  if (auto svg = draw({}, plotter); !svg) return tl::unexpected(svg.error());
  return {};
}

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
