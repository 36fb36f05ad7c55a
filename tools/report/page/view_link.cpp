#include "report/page/report_page.h"

#include <fmt/format.h>

#include <string_view>

namespace coif::report {
namespace {

/// Escapes a name for a URL: a colon in it must not look like a scheme, nor a # end it.
std::string percent_encoded(std::string_view text) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._~/";
  std::string url;
  for (const char c : text) {
    if (kPlain.find(c) != kPlain.npos)
      url += c;
    else
      url += fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return url;
}

}  // namespace

std::string relative_url(const std::filesystem::path& target, const std::filesystem::path& from) {
  const auto whole = [](const std::filesystem::path& path) {
    return std::filesystem::absolute(path).lexically_normal();
  };
  return percent_encoded(whole(target).lexically_relative(whole(from).parent_path()).string());
}

std::string view_url(const std::string& page, const ViewLink& link) {
  std::string settings;
  const auto add = [&settings](std::string_view name, const std::string& value) {
    if (value.empty()) return;
    settings += fmt::format("{}{}={}", settings.empty() ? "#" : "&", name, percent_encoded(value));
  };
  add("motion", link.motion);
  add("plays", link.motion.empty() ? "" : "1");
  add("rate", link.rate > 0 ? fmt::format("{:g}", link.rate) : "");
  add("solver", link.solver);
  add("beside", link.beside);
  return page + settings;
}

}  // namespace coif::report
