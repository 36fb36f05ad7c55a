#include "base/files.h"
#include "base/json.h"
#include "cli/chunk_choice.h"
#include "cli/command.h"
#include "cli/input_files.h"
#include "cli/messages.h"
#include "cli/options.h"
#include "validate/find_issues.h"
#include "write/chunk_file.h"
#include "write/strip_asset.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

namespace coif {
namespace {

struct StripOptions {
  std::string input;
  std::string output;
  std::string without;
  OutputFormat format = OutputFormat::kText;
};

nlohmann::ordered_json losses(const std::vector<StrippedChunk>& chunks) {
  auto list = nlohmann::ordered_json::array();
  for (const StrippedChunk& chunk : chunks) list.push_back({{"id", chunk_name(chunk.id)}, {"bytes", chunk.bytes}});
  return list;
}

std::string strip_json(const StripOptions& options, std::size_t before, const StrippedAsset& stripped) {
  auto rewritten = nlohmann::ordered_json::array();
  for (const std::uint32_t id : stripped.rewritten) rewritten.push_back(chunk_name(id));
  return json_text({{"output", options.output},
                    {"bytes_before", before},
                    {"bytes", stripped.file.size()},
                    {"bytes_saved", before - stripped.file.size()},
                    {"removed", losses(stripped.removed)},
                    {"shortened", losses(stripped.shortened)},
                    {"rewritten", std::move(rewritten)}});
}

std::string strip_text(const StripOptions& options, std::size_t before, const StrippedAsset& stripped) {
  const std::size_t saved = before - stripped.file.size();
  std::string text = fmt::format("{}: {} bytes, {} saved ({:.1f} %)\n", options.output, stripped.file.size(), saved,
                                 100.0 * double(saved) / double(before));
  if (stripped.removed.empty()) text += "  nothing to remove: the asset has none of these chunks\n";
  for (const StrippedChunk& chunk : stripped.removed) {
    text += fmt::format("  removed   {} {:>12}\n", chunk_name(chunk.id), chunk.bytes);
  }
  for (const StrippedChunk& chunk : stripped.shortened) {
    text += fmt::format("  shortened {} {:>12}\n", chunk_name(chunk.id), chunk.bytes);
  }
  for (const std::uint32_t id : stripped.rewritten) text += fmt::format("  rewritten {}\n", chunk_name(id));
  return text;
}

/// What the runtime would refuse must never reach a disk.
tl::expected<void, ToolError> check_stripped(const StripOptions& options, const StrippedAsset& stripped) {
  const FileBytes bytes = FileBytes::copy(stripped.file);
  Asset asset;
  const LoadStatus status = open_whole(bytes.span(), asset);
  if (status) return {};
  return tl::unexpected(ToolError{ToolError::Kind::kInternal,
                                  fmt::format("{}: the stripped asset would be invalid and was not written: {}",
                                              options.input, describe_text(status))});
}

tl::expected<Exit, ToolError> run_strip(const StripOptions& options) {
  if (auto checked = check_output(options.output, {}); !checked) return tl::unexpected(checked.error());
  const auto file = AssetFile::open(options.input);
  if (!file) return tl::unexpected(file.error());
  const auto chunks = choose_chunks(options.without, file->asset());
  if (!chunks) return tl::unexpected(chunks.error());
  const StrippedAsset stripped = strip_asset(file->asset(), file->bytes(), *chunks);
  if (auto checked = check_stripped(options, stripped); !checked) return tl::unexpected(checked.error());
  if (auto written = write_output(options.output, stripped.file); !written) return tl::unexpected(written.error());
  const bool as_json = options.format == OutputFormat::kJson;
  const std::size_t before = file->bytes().size();
  print_result(as_json ? strip_json(options, before, stripped) : strip_text(options, before, stripped));
  return Exit::kOk;
}

std::string list_of_groups() {
  std::string text = "CHUNK is a chunk's name as 'coif info' prints it, or one of these, after which an asset is:\n";
  for (const ChunkGroup& group : chunk_groups()) {
    std::vector<std::string> names;
    for (const std::uint32_t id : group.chunks) names.push_back(chunk_name(id));
    text += fmt::format("  {:<12}{} ({})\n", group.name, group.meaning, fmt::join(names, " "));
  }
  return text + "What needs a chunk goes with it.";
}

}  // namespace

Command add_strip(CLI::App& program) {
  CLI::App* app = program.add_subcommand("strip", "Leave out of an asset what a scene does not need");
  const auto options = std::make_shared<StripOptions>();
  app->add_option("IN", options->input, "A cooked asset")->required();
  app->add_option("-o,--output", options->output, "The asset to write; may be IN")->required()->type_name("OUT.coif");
  app->add_option("--without", options->without, "What to leave out, separated by commas\n" + list_of_groups())
      ->required()
      ->type_name("CHUNK,...");
  add_format(*app, options->format);
  return {app, [options](const Messages&) { return run_strip(*options); }};
}

}  // namespace coif
