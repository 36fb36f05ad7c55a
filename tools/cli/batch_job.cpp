#include "cli/batch.h"

#include "base/files.h"
#include "cli/command.h"
#include "cli/input_files.h"
#include "cook/recipe/recipe_preset.h"
#include "platform/child_process.h"
#include "render/picture.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

namespace coif::cli {
namespace {

namespace fs = std::filesystem;
using Document = nlohmann::json;
using nlohmann::ordered_json;

std::vector<std::string> texts_of(const std::vector<fs::path>& paths) {
  std::vector<std::string> texts;
  for (const fs::path& path : paths) texts.push_back(path.string());
  return texts;
}

template <class Value>
Document or_null(const std::optional<Value>& value) {
  return value ? Document(*value) : Document(nullptr);
}

template <class Value>
std::optional<Value> optional_from(const Document& document) {
  return document.is_null() ? std::nullopt : std::optional(document.get<Value>());
}

Document limits_document(const SourceLimits& limits) {
  return {{"source_mb", limits.max_source_mb},
          {"memory_mb", limits.max_memory_mb},
          {"seconds", or_null(limits.max_seconds)},
          {"pass_seconds", or_null(limits.max_pass_seconds)},
          {"requires_sandbox", limits.requires_sandbox}};
}

SourceLimits limits_from(const Document& document) {
  SourceLimits limits;
  document.at("source_mb").get_to(limits.max_source_mb);
  document.at("memory_mb").get_to(limits.max_memory_mb);
  limits.max_seconds = optional_from<std::uint32_t>(document.at("seconds"));
  limits.max_pass_seconds = optional_from<std::uint32_t>(document.at("pass_seconds"));
  document.at("requires_sandbox").get_to(limits.requires_sandbox);
  limits.tells_of_sandbox = false;  // the asking process did
  return limits;
}

/// The options of the command line that apply to every source.
Document options_document(const CookOptions& options) {
  return {{"preset", options.preset},
          {"body", options.body},
          {"cache", options.cache},
          {"roots", texts_of(options.roots)},
          {"limits", limits_document(options.limits)},
          {"quiet", options.quiet},
          {"verbose", options.verbose},
          {"durable", options.durable},
          {"draft", options.draft},
          {"warnings_as_errors", options.warnings_as_errors},
          {"ignored", options.ignored}};
}

CookOptions options_from(const Document& document) {
  CookOptions options;
  for (const cook::RecipePreset& preset : cook::recipe_presets()) {
    if (document.at("preset").get<std::string>() == preset.name) options.preset = preset.name;
  }
  document.at("body").get_to(options.body);
  document.at("cache").get_to(options.cache);
  for (const Document& root : document.at("roots")) options.roots.emplace_back(root.get<std::string>());
  options.limits = limits_from(document.at("limits"));
  document.at("quiet").get_to(options.quiet);
  document.at("verbose").get_to(options.verbose);
  document.at("durable").get_to(options.durable);
  document.at("draft").get_to(options.draft);
  document.at("warnings_as_errors").get_to(options.warnings_as_errors);
  document.at("ignored").get_to(options.ignored);
  options.shows_progress = false;
  return options;
}

// Runs in the child.

tl::expected<CookSummary, FailedCook> cook_one(const CookOptions& options, const cache::CookRequest& request,
                                               const Messages& messages) {
  auto choice = held_recipe(request.source, request.recipe, options.limits.requires_sandbox, options.roots, messages,
                            {options.preset, ""});
  if (!choice) return tl::unexpected(failed_by_recipe(choice.error()));
  choose_body(options.body, *choice);
  if (auto known = acknowledge(options, *choice); !known) return tl::unexpected(failed_by_recipe(known.error()));
  std::error_code told_by_the_cook;
  fs::create_directories(fs::path(request.output).parent_path(), told_by_the_cook);
  return run_cook_job(options, *choice, messages);
}

/// The lines of the result, as JSON, and kInputIdentities.
ordered_json outcome_of(const CookOptions& options, const cache::CookRequest& request, const Messages& messages) {
  const auto begin = std::chrono::steady_clock::now();
  const auto summary = cook_one(options, request, messages);
  const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - begin;
  ordered_json outcome{{"source", request.source},
                       {"output", request.output},
                       {"status", status_word(Exit::kOk)},
                       {"exit_code", int(Exit::kOk)},
                       {"ms", elapsed.count()}};
  if (summary) {
    outcome.update(cook_json(*summary));
    for (const auto* const files : {&summary->files, &summary->named}) {
      for (const fs::path& file : *files) outcome[kInputIdentities].push_back(file_identity(file));
    }
    return outcome;
  }
  messages.error(summary.error().message);
  outcome.update(failed_cook_json(options, summary.error()));
  return outcome;
}

platform::Bytes answer_request(const platform::JobCall& call) {
  const Document document = Document::from_msgpack(call.request());
  CookOptions options = options_from(document.at("options"));
  const cache::CookRequest request{document.at("source").get<std::string>(),
                                   optional_from<std::string>(document.at("recipe")),
                                   document.at("output").get<std::string>()};
  options.sources = {request.source};
  options.output = request.output;
  options.threads = document.at("threads").get<unsigned>();
  const Messages messages("cook");
  const std::string text = json_text(outcome_of(options, request, options.quiet ? messages.without_notes() : messages));
  return {text.begin(), text.end()};
}

const platform::Job kCookOne("cook one of many", answer_request);

platform::Bytes draw_thumbnail(const platform::JobCall& call) {
  constexpr std::uint32_t kPixels = 144;
  const auto file = AssetFile::open(fs::path(std::string(call.request().begin(), call.request().end())));
  if (!file) return {};
  render::PictureSettings settings;
  settings.width = settings.height = kPixels;
  settings.warm_up = false;
  const auto picture = render::render_picture(file->asset(), settings);
  return picture ? render::encode_png(*picture) : platform::Bytes{};
}

const platform::Job kDrawThumbnail("draw thumbnail", draw_thumbnail);

}  // namespace

std::vector<std::optional<ordered_json>> cook_each(const CookOptions& options,
                                                   const std::vector<cache::CookRequest>& requests, unsigned threads) {
  const Document common = options_document(options);
  std::vector<platform::Bytes> calls;
  for (const cache::CookRequest& request : requests) {
    calls.push_back(Document::to_msgpack({{"options", common},
                                          {"source", request.source},
                                          {"recipe", or_null(request.recipe)},
                                          {"output", request.output},
                                          {"threads", threads}}));
  }
  std::vector<std::optional<ordered_json>> outcomes;
  for (const auto& answer : platform::run_in_processes(kCookOne, calls, options.jobs))
    outcomes.push_back(answer ? std::optional(ordered_json::parse(*answer)) : std::nullopt);
  return outcomes;
}

std::vector<platform::Bytes> thumbnails(const std::vector<std::string>& assets, unsigned jobs) {
  std::vector<platform::Bytes> calls, pictures;
  for (const std::string& asset : assets) calls.emplace_back(asset.begin(), asset.end());
  for (auto& answer : platform::run_in_processes(kDrawThumbnail, calls, jobs))
    pictures.push_back(answer ? std::move(*answer) : platform::Bytes{});
  return pictures;
}

}  // namespace coif::cli
