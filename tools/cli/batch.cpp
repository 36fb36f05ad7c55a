#include "cli/batch.h"

#include "base/files.h"
#include "base/json.h"
#include "cli/messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <fstream>
#include <map>

namespace coif::cli {

bool is_cooked(const nlohmann::ordered_json& outcome) { return outcome["exit_code"] == 0; }

BatchCounts count(const Outcomes& outcomes) {
  BatchCounts counts{.asked = outcomes.size()};
  for (const auto& file : outcomes) {
    const bool done = is_cooked(file);
    ++(done ? counts.cooked : counts.failed);
    if (done && file["from_cache"].get<bool>()) ++counts.from_cache;
  }
  return counts;
}

std::string sentence(const BatchCounts& counts) {
  return fmt::format("{} asked, {} cooked ({} from the cache), {} failed", counts.asked, counts.cooked,
                     counts.from_cache, counts.failed);
}

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

using Requests = std::vector<cache::CookRequest>;

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

/// A cook may write to a file that another one names, which neither knows. So only assets and empty files may be
/// replaced.
bool may_be_replaced(const fs::path& output) {
  std::error_code error;
  if (!fs::is_regular_file(output, error) || fs::file_size(output, error) == 0) return true;
  std::string begin(sizeof kAssetMagic, '\0');
  std::ifstream(output, std::ios::binary).read(begin.data(), std::streamsize(begin.size()));
  return std::memcmp(begin.data(), kAssetMagic, sizeof kAssetMagic) == 0;
}

/// No cook of a batch may overwrite another's source or recipe, or the manifest. Each cook itself checks the files that
/// its source names.
tl::expected<void, ToolError> check_outputs_of(const CookOptions& options, const Requests& requests) {
  std::vector<fs::path> inputs{options.manifest, options.body};
  std::vector<NamedOutput> outputs{{"--report", options.report}};
  for (const cache::CookRequest& request : requests) {
    inputs.emplace_back(request.source);
    inputs.push_back(fs::path(request.source).replace_extension(".recipe.json"));
    if (request.recipe) inputs.emplace_back(*request.recipe);
    outputs.push_back({"an output", request.output});
  }
  std::map<std::string, const char*> places;
  for (const fs::path& input : inputs) places.emplace(file_identity(input), "is also an input");
  for (const NamedOutput& output : outputs) {
    if (output.path.empty()) continue;
    const auto [place, is_new] = places.emplace(file_identity(output.path), "is also another output");
    if (!is_new) return file_failure(ToolError::Kind::kUsage, output.path, "{}; choose another output", place->second);
    if (output.path != options.report && !may_be_replaced(output.path)) {
      return file_failure(
          ToolError::Kind::kUsage, output.path,
          "is there and no cooked asset, but may be what another source names; remove it, or choose another output");
    }
  }
  return {};
}

tl::expected<Requests, ToolError> named_requests(const CookOptions& options) {
  Requests requests;
  std::map<std::string, std::string> owners;
  for (const std::string& source : options.sources) {
    fs::path stem = fs::path(source).stem();
    if (cook::is_recipe_file(source)) stem = stem.stem();
    const std::string output = (fs::path(options.output) / stem).string() + ".coif";
    const auto [owner, is_new] = owners.emplace(output, source);
    if (!is_new) return usage(fmt::format("{} and {} would both become {}", owner->second, source, output));
    requests.push_back({source, options.recipe, output});
  }
  return requests;
}

/// Parses "K/N" with K within 1 .. N. Error (kUsage): the text has another form.
tl::expected<cache::Share, ToolError> parse_share(const std::string& text) {
  const auto share = parse_pair<std::size_t>(text, '/');
  if (share && share->first >= 1 && share->first <= share->second) return cache::Share{share->first, share->second};
  return usage(fmt::format("--batch: '{}' is not K/N with K from 1 to N, as in 3/40", text));
}

/// The requests of a command line with several sources or a manifest: all of them, or the chosen share. Errors: those
/// of read_manifest(), and kUsage for options that do not go with many sources.
tl::expected<Requests, ToolError> batch_requests(const CookOptions& options) {
  if (auto checked = check_options(options); !checked) return tl::unexpected(checked.error());
  const auto share = parse_share(options.share);
  if (!share) return tl::unexpected(share.error());
  auto all =
      options.manifest.empty() ? named_requests(options) : cache::read_manifest(options.manifest, options.output);
  if (!all) return all;
  return cache::share_of(*all, *share);
}

std::string line_of(const Outcomes& file, std::size_t width) {
  const bool done = is_cooked(file);
  const auto figure = [&](const char* key) { return done ? fmt::format("{}", file[key].get<std::uint64_t>()) : "-"; };
  const char* from_cache = !done ? "-" : file["from_cache"].get<bool>() ? "yes" : "no";
  return fmt::format("{:{}}  {:14}  {:>9}  {:>10}  {:>8.0f}  {}\n", file["source"].get<std::string>(), width,
                     file["status"].get<std::string>(), figure("triangles"), figure("bytes"), file["ms"].get<double>(),
                     from_cache);
}

std::string batch_json(const Outcomes& outcomes) {
  const BatchCounts counts = count(outcomes);
  return json_text({{"asked", counts.asked},
                    {"cooked", counts.cooked},
                    {"from_cache", counts.from_cache},
                    {"failed", counts.failed},
                    {"files", outcomes}});
}

std::string batch_text(const Outcomes& outcomes) {
  std::size_t width = 4;
  for (const auto& file : outcomes) width = std::max(width, file["source"].get_ref<const std::string&>().size());
  std::string text = fmt::format("{:{}}  {:14}  {:>9}  {:>10}  {:>8}  {}\n", "file", width, "status", "triangles",
                                 "bytes", "ms", "from cache");
  for (const auto& file : outcomes) text += line_of(file, width);
  return text + sentence(count(outcomes)) + "\n";
}

/// The outcome of a process that gave no answer.
ordered_json crashed(const cache::CookRequest& request, const Messages& messages) {
  const std::string text = request.source + ": the cook crashed; cook it alone, and report it with the file";
  messages.error(text);
  return {{"source", request.source},
          {"output", request.output},
          {"status", status_word(Exit::kInternal)},
          {"exit_code", int(Exit::kInternal)},
          {"ms", 0.0},
          {"error", text}};
}

/// Removes kInputIdentities from the outcomes. True where one of these inputs is the report's file.
bool take_inputs(Outcomes& outcomes, const std::string& report) {
  const std::string place = file_identity(report);
  bool is_input = false;
  for (auto& outcome : outcomes) {
    if (!outcome.contains(kInputIdentities)) continue;
    for (const auto& input : outcome[kInputIdentities]) is_input = is_input || (!place.empty() && input == place);
    outcome.erase(kInputIdentities);
  }
  return is_input;
}

std::string report_text(const CookOptions& options, const Outcomes& outcomes) {
  const bool is_page = fs::path(options.report).extension() == ".html";
  return is_page ? batch_page(outcomes, options.jobs) : batch_json(outcomes);
}

}  // namespace

tl::expected<Exit, ToolError> run_cook_batch(const CookOptions& options, const Messages& messages) {
  const auto requests = batch_requests(options);
  if (!requests) return tl::unexpected(requests.error());
  if (auto checked = check_outputs_of(options, *requests); !checked) return tl::unexpected(checked.error());
  if (!options.limits.requires_sandbox) tell_of_missing_sandbox(messages);
  const auto cooks = unsigned(std::clamp<std::size_t>(requests->size(), 1, options.jobs));
  const unsigned threads = options.threads.value_or(std::max(1u, platform::all_threads() / cooks));
  const auto answers = cook_each(options, *requests, threads);
  auto outcomes = Outcomes::array();
  int worst = 0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    outcomes.push_back(answers[i] ? *answers[i] : crashed((*requests)[i], messages));
    worst = std::max(worst, outcomes.back()["exit_code"].get<int>());
  }
  if (take_inputs(outcomes, options.report)) {
    return file_failure(ToolError::Kind::kUsage, options.report, "is also an input; choose another output");
  }
  if (!options.report.empty()) {
    const std::string text = report_text(options, outcomes);
    const auto written = write_output(options.report, std::as_bytes(std::span(text)));
    if (!written) return tl::unexpected(written.error());
  }
  const bool as_json = options.format == OutputFormat::kJson;
  if (as_json || !options.quiet) print_result(as_json ? batch_json(outcomes) : batch_text(outcomes));
  return Exit(worst);
}

}  // namespace coif::cli
