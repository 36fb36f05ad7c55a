#include "base/files.h"
#include "base/json.h"
#include "base/text.h"
#include "base/words.h"
#include "cli/command.h"
#include "cli/input_files.h"
#include "cli/messages.h"
#include "cli/options.h"
#include "validate/find_issues.h"
#include "write/strip_asset.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <memory>
#include <sstream>

namespace coif::cli {
namespace {

struct StripOptions {
  std::string input;
  std::string output;
  std::string without;
  OutputFormat format = OutputFormat::kText;
};

using Ids = std::vector<std::uint32_t>;

std::string in_case(std::string text, int (*letter)(int)) {
  for (char& c : text) c = char(letter(static_cast<unsigned char>(c)));
  return text;
}

/// The chunks of the format, and unknown ones that this asset has.
Ids nameable_chunks(const Asset& asset) {
  Ids ids;
  for (const ChunkLayout& layout : kChunkLayouts) ids.push_back(layout.id);
  for (const ChunkEntry& entry : asset.chunks()) {
    if (std::ranges::find(ids, entry.id) == ids.end()) ids.push_back(entry.id);
  }
  return ids;
}

tl::unexpected<ToolError> unknown_word(const std::string& word, const Ids& chunks) {
  std::vector<std::string> words, groups;
  for (const ChunkGroup& group : chunk_groups()) groups.emplace_back(group.name);
  words = groups;
  for (const std::uint32_t id : chunks) words.push_back(in_case(chunk_name(id), std::tolower));
  const std::string nearest = nearest_word(in_case(word, std::tolower), words);
  const bool is_group = std::ranges::find(groups, nearest) != groups.end();
  const std::string cure =
      nearest.empty() ? fmt::format("use {}, or a chunk's name as 'coif info' prints it", fmt::join(groups, ", "))
                      : fmt::format("did you mean '{}'?", is_group ? nearest : in_case(nearest, std::toupper));
  return usage(fmt::format("--without: '{}' is no part of an asset; {}", word, cure));
}

tl::expected<Ids, ToolError> chunks_of(const std::string& word, const Ids& chunks) {
  for (const ChunkGroup& group : chunk_groups()) {
    if (in_case(word, std::tolower) == group.name) return chunks_of_group(group.name);
  }
  for (const std::uint32_t id : chunks) {
    if (in_case(word, std::toupper) != in_case(chunk_name(id), std::toupper)) continue;
    if (!is_needed_chunk(id)) return Ids{id};
    return usage(
        fmt::format("--without: no asset is without {}: SKEL and BONE are the skeleton that all else refers to; "
                    "leave it off the list",
                    chunk_name(id)));
  }
  return unknown_word(word, chunks);
}

/// The chunks of a list such as "textures,NAME", ignoring case: groups, chunks of the format, and other chunks of the
/// asset. Errors (kUsage) name a word that is none of these, with the nearest one, and chunks that every asset needs.
tl::expected<Ids, ToolError> choose_chunks(const std::string& list, const Asset& asset) {
  const Ids nameable = nameable_chunks(asset);
  Ids chosen;
  std::istringstream words(list);
  for (std::string word; std::getline(words, word, ',');) {
    const auto chunks = chunks_of(word, nameable);
    if (!chunks) return chunks;
    for (const std::uint32_t id : *chunks) {
      if (std::ranges::find(chosen, id) == chosen.end()) chosen.push_back(id);
    }
  }
  return chosen;
}

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

/// A file that the runtime would refuse must never be written.
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
    for (const std::uint32_t id : chunks_of_group(group.name)) names.push_back(chunk_name(id));
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

}  // namespace coif::cli
