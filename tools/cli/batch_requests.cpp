#include "cli/batch_requests.h"

#include "files/output_file.h"

#include <fmt/format.h>

#include <charconv>
#include <map>

namespace coif {
namespace {

namespace fs = std::filesystem;
using Requests = std::vector<CookRequest>;

tl::expected<void, ToolError> check_options(const CookOptions& options) {
  std::error_code ignored;
  if (options.output.empty()) return usage("needs -o FOLDER for several sources; see 'coif cook --help'");
  if (!fs::is_directory(options.output, ignored)) {
    return usage(fmt::format("{}: several sources need a folder that exists; create it first", options.output));
  }
  if (!options.depfile.empty()) return usage("--depfile goes with one SOURCE; cook each by a call of its own");
  if (options.list) return usage("--list goes with one SOURCE");
  if (!options.manifest.empty()) {
    if (!options.sources.empty()) return usage("--manifest names the sources; leave SOURCE out");
    if (options.recipe) return usage("--manifest names recipes for each source; leave --recipe out");
  }
  return options.report.empty() ? tl::expected<void, ToolError>{} : check_output(options.report, {options.manifest});
}

tl::expected<Requests, ToolError> named_requests(const CookOptions& options) {
  Requests requests;
  std::map<std::string, std::string> owners;
  for (const std::string& source : options.sources) {
    const std::string output = (fs::path(options.output) / fs::path(source).stem()).string() + ".coif";
    const auto [owner, is_new] = owners.emplace(output, source);
    if (!is_new) return usage(fmt::format("{} and {} would both become {}", owner->second, source, output));
    requests.push_back({source, options.recipe, output});
  }
  return requests;
}

std::size_t number(std::string_view text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() ? value : 0;
}

}  // namespace

tl::expected<Requests, ToolError> batch_requests(const CookOptions& options) {
  if (auto checked = check_options(options); !checked) return tl::unexpected(checked.error());
  const auto share = parse_share(options.share);
  if (!share) return tl::unexpected(share.error());
  const auto all = options.manifest.empty() ? named_requests(options) : read_manifest(options.manifest, options.output);
  if (!all) return all;
  return share_of(*all, *share);
}

tl::expected<Share, ToolError> parse_share(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (slash != std::string::npos) {
    const Share share{number(std::string_view(text).substr(0, slash)),
                      number(std::string_view(text).substr(slash + 1))};
    if (share.index >= 1 && share.index <= share.count) return share;
  }
  return usage(fmt::format("--batch: '{}' is not K/N with K from 1 to N, as in 3/40", text));
}

}  // namespace coif
