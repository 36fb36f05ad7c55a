#include "view/server/request_guard.h"

#include "view/view_page.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace coif::view {
namespace {

/// Tags of tools/view/page/script/page.html in their order, and their replacements.
struct Mark {
  std::string_view tag;
  std::string_view begin;  ///< Beginning of the new tag; where it does not end, the nonce follows.
};
constexpr std::array<Mark, 4> kMarks{{{"<html lang=\"en\">", "<html lang=\"en\" data-live>"},
                                      {"<style>", "<style"},
                                      {"<script>", "<script"},
                                      {"<script type=\"module\">", "<script type=\"module\""}}};

}  // namespace

tl::expected<std::string, ToolError> live_page(std::string_view page, std::string_view nonce) {
  auto filled = view_page(page, {}, "");
  if (!filled) return filled;
  std::string out;
  std::string_view rest = *filled;
  for (const Mark& mark : kMarks) {
    const std::size_t at = rest.find(mark.tag);
    if (at == rest.npos)
      return failure(ToolError::Kind::kBadInput, "not the page of coif view; tools/view/built/view.html is");
    out.append(rest.substr(0, at)).append(mark.begin);
    if (!mark.begin.ends_with('>')) out += fmt::format(" nonce=\"{}\">", nonce);
    rest.remove_prefix(at + mark.tag.size());
  }
  return out.append(rest);
}

std::string live_policy(std::string_view nonce) {
  return fmt::format(
      "default-src 'none'; script-src 'nonce-{0}' 'wasm-unsafe-eval'; style-src 'nonce-{0}'; img-src data: blob:; "
      "connect-src 'self' data:; "
      "base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
      nonce);
}

}  // namespace coif::view
