#include "base/json.h"
#include "base/text.h"
#include "cache/cook_cache.h"
#include "cli/command.h"
#include "cli/options.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <memory>

namespace coif::cli {
namespace {

struct CacheOptions {
  std::string folder;
  std::optional<std::uint64_t> max_bytes;
  bool stats = false;
  OutputFormat format = OutputFormat::kText;
};

struct Unit {
  std::string_view name;
  double bytes;
};

constexpr Unit kUnits[] = {{"", 1},      {"K", 1e3},      {"M", 1e6},         {"G", 1e9},           {"T", 1e12},
                           {"Ki", 1024}, {"Mi", 1048576}, {"Gi", 1073741824}, {"Ti", 1099511627776}};

/// Parses "10G", "1.5Gi", "0". None for other text.
std::optional<std::uint64_t> parse_size(std::string_view text) {
  const std::size_t end = text.find_last_of("0123456789") + 1;
  const auto number = parse_number<double>(text.substr(0, end));
  const auto unit = std::ranges::find(kUnits, text.substr(end), &Unit::name);
  if (!number || unit == std::end(kUnits) || !(*number >= 0) || !(*number * unit->bytes < 1e18)) return std::nullopt;
  return std::uint64_t(std::llround(*number * unit->bytes));
}

std::string readable(std::uint64_t bytes) {
  const Unit* unit = kUnits;
  for (const Unit& larger : std::span(kUnits).first(5)) {
    if (double(bytes) >= larger.bytes) unit = &larger;
  }
  return unit == kUnits ? fmt::format("{} bytes", bytes)
                        : fmt::format("{:.1f} {}B", double(bytes) / unit->bytes, unit->name);
}

std::string age(std::filesystem::file_time_type time) {
  const double seconds = std::chrono::duration<double>(std::filesystem::file_time_type::clock::now() - time).count();
  if (seconds < 3600) return counted(std::size_t(std::max(0.0, seconds / 60)), "minute", "minutes");
  if (seconds < 2 * 86400) return counted(std::size_t(seconds / 3600), "hour", "hours");
  return counted(std::size_t(seconds / 86400), "day", "days");
}

double seconds_ago(std::filesystem::file_time_type time) {
  return std::chrono::duration<double>(std::filesystem::file_time_type::clock::now() - time).count();
}

std::string result_text(const CacheOptions& options, const cache::CacheTrimmed& trimmed,
                        const cache::CacheUsage& usage) {
  std::string text;
  if (options.max_bytes) {
    text += fmt::format("{}: removed {}, {}, and {} of killed cooks\n", options.folder,
                        counted(trimmed.entries, "entry", "entries"), readable(trimmed.bytes),
                        counted(trimmed.leftovers, "file", "files"));
  }
  text += fmt::format("{}: {} of {}, {}\n", options.folder, counted(usage.entries, "entry", "entries"),
                      counted(usage.keys, "source", "sources"), readable(usage.bytes));
  if (usage.oldest_use)
    text += fmt::format("  last used {} to {} ago\n", age(*usage.newest_use), age(*usage.oldest_use));
  if (usage.leftovers > 0) {
    text += fmt::format("  {} of killed cooks, {}: removed with --max-size\n",
                        counted(usage.leftovers, "file", "files"), readable(usage.leftover_bytes));
  }
  return text;
}

std::string result_json(const cache::CacheTrimmed& trimmed, const cache::CacheUsage& usage) {
  nlohmann::ordered_json json{{"sources", usage.keys},
                              {"entries", usage.entries},
                              {"bytes", usage.bytes},
                              {"leftovers", usage.leftovers},
                              {"leftover_bytes", usage.leftover_bytes},
                              {"removed_entries", trimmed.entries},
                              {"removed_bytes", trimmed.bytes},
                              {"removed_leftovers", trimmed.leftovers}};
  if (usage.oldest_use) json["oldest_use_s"] = seconds_ago(*usage.oldest_use);
  if (usage.newest_use) json["newest_use_s"] = seconds_ago(*usage.newest_use);
  return json_text(json);
}

tl::expected<Exit, ToolError> run_cache(const CacheOptions& options) {
  if (!options.stats && !options.max_bytes) return usage("needs --stats, --max-size or both; see 'coif cache --help'");
  cache::CacheTrimmed trimmed;
  if (options.max_bytes) {
    const auto done = cache::trim_cache(options.folder, *options.max_bytes);
    if (!done) return tl::unexpected(done.error());
    trimmed = *done;
  }
  const auto usage = cache::cache_usage(options.folder);
  if (!usage) return tl::unexpected(usage.error());
  const bool as_json = options.format == OutputFormat::kJson;
  print_result(as_json ? result_json(trimmed, *usage) : result_text(options, trimmed, *usage));
  return Exit::kOk;
}

}  // namespace

Command add_cache(CLI::App& program) {
  CLI::App* app = program.add_subcommand("cache", "Count and bound what --cache keeps");
  const auto options = std::make_shared<CacheOptions>();
  app->add_option("--dir", options->folder, "The folder that 'coif cook --cache' names")->required()->type_name("DIR");
  const auto parse = [options](const std::string& text) {
    options->max_bytes = parse_size(text);
    if (!options->max_bytes) {
      throw CLI::ValidationError("--max-size",
                                 fmt::format("'{}' is no size, such as 10G, 512M or 1.5Gi (K is 1000, Ki 1024)", text));
    }
  };
  app->add_option_function<std::string>(
         "--max-size", parse,
         "Remove what was not used for longest until no more than this is left, and what killed "
         "cooks left; cooks may run meanwhile")
      ->type_name("10G");
  app->add_flag("--stats", options->stats, "Print how much there is, and when it was last used");
  add_format(*app, options->format);
  return {app, [options](const Messages&) { return run_cache(*options); }};
}

}  // namespace coif::cli
