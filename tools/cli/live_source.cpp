#include "cli/view_output.h"

#include "base/files.h"
#include "base/json.h"
#include "cli/cook_process.h"
#include "cli/input_files.h"
#include "platform/program.h"
#include "view/server/live_view.h"
#include "view/server/request_guard.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <system_error>
#include <utility>

namespace coif::cli {
namespace {

namespace fs = std::filesystem;

/// "bob" of "bob.recipe.json" and of "bob.json".
std::string stem_of_recipe(const fs::path& recipe) {
  const std::string stem = recipe.stem().string();
  return stem.ends_with(".recipe") ? stem.substr(0, stem.size() - 7) : stem;
}

/// Whether hair grows by the recipe, so that it needs no model.
bool grows_hair(const fs::path& recipe) {
  if (!cook::is_recipe_file(recipe)) return false;
  const auto text = cook::read_recipe_text(recipe);
  if (!text) return false;
  const auto json = parse_shallow_json(*text);
  return json && json->contains("grow");
}

/// The only model beside a recipe that has the recipe's stem; the recipe itself where hair grows by it and there is no
/// such model.
tl::expected<fs::path, ToolError> source_beside(const fs::path& recipe) {
  std::error_code error;
  if (!fs::exists(recipe, error))
    return file_failure(ToolError::Kind::kFileAccess, recipe, "cannot open: No such file or directory");
  std::vector<std::string> found;
  const fs::path folder = recipe.has_parent_path() ? recipe.parent_path() : fs::path(".");
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const fs::path& path = entry->path();
    if (path.stem() == stem_of_recipe(recipe) && importer::find_suffix(path)) found.push_back(path.filename().string());
  }
  if (found.size() == 1) return recipe.parent_path() / found.front();
  if (found.empty() && grows_hair(recipe)) return recipe;
  const std::string what = found.empty() ? fmt::format("no model called '{}' lies beside it", stem_of_recipe(recipe))
                                         : fmt::format("several models lie beside it: {}", fmt::join(found, ", "));
  return file_failure(ToolError::Kind::kBadInput, recipe, "{}; say which: coif view MODEL --recipe {}", what,
                      recipe.string());
}

tl::expected<void, ToolError> find_source(LiveOptions& options) {
  if (fs::path(options.file).extension() != ".json") return {};
  if (options.recipe) return usage(fmt::format("{} is a recipe, and --recipe names another", options.file));
  auto source = source_beside(options.file);
  if (!source) return tl::unexpected(source.error());
  if (*source != fs::path(options.file)) options.recipe = std::exchange(options.file, source->string());
  return {};
}

view::LiveCooking cooking_of(const LiveOptions& options, const Messages& messages) {
  view::LiveCooking cooking;
  cooking.draft = options.draft;
  cooking.roots = options.roots;
  cooking.import_settings = [messages, limits = options.limits](const cook::Recipe& recipe,
                                                                const std::vector<fs::path>& roots) {
    return limits.of_import(import_settings(recipe, roots), messages);
  };
  cooking.cook = [limits = options.limits](const view::LiveOrder& live,
                                           const std::stop_token& stop) -> tl::expected<view::LiveCooked, ToolError> {
    CookOrder order;
    order.source = live.source.string();
    order.recipe = live.recipe;
    order.recipe_directory = live.recipe_directory;
    order.import = live.import;
    order.source_hash = live.source_hash;
    order.threads = platform::all_threads();
    order.draft = live.draft;
    order.model = live.model;
    order.keeps_model = live.model.empty();
    auto answer = cook_in_child(order, {order.source, limits, {platform::all_threads(), stop}});
    if (!answer) return tl::unexpected<ToolError>(answer.error());
    return view::LiveCooked{std::move(answer->result), std::move(answer->model)};
  };
  cooking.cooked = [messages](const view::LiveResult& result) {
    messages.tell(result.warnings, result.name);
    messages.note(
        fmt::format("{}: cooked in {:.2f} s, {} KB", result.name, result.seconds, (result.asset.size() + 1023) / 1024));
  };
  cooking.failed = [messages](const std::string& problem) { messages.error(problem); };
  return cooking;
}

std::string address_text(const LiveOptions& options, const std::string& address) {
  if (options.format == OutputFormat::kJson) return json_text({{"address", address}});
  return fmt::format(
      "{}\nOpen this address in a browser on this machine; Ctrl-C ends it. Cooked as a {}.\n", address,
      options.draft ? "draft, without a search for draw orders and at one level of detail: --quality full cooks all"
                    : "game gets it");
}

}  // namespace

tl::expected<Exit, ToolError> view_live(LiveOptions options, const Messages& messages) {
  if (auto found = find_source(options); !found) return tl::unexpected(found.error());
  if (auto readable = importer::check_readable(options.file, importer::ImportSettings{}.max_file_bytes); !readable)
    return tl::unexpected(readable.error());
  auto page = moved_page(options.page, options.motion, messages);
  if (!page) return tl::unexpected(page.error());
  std::vector<fs::path> files;
  page = bodied_page(options.page, std::move(*page), options.body, nullptr, messages, files);
  if (!page) return tl::unexpected(page.error());

  if (auto fits = view::live_page(*page, ""); !fits) {
    return tl::unexpected(ToolError{fits.error().kind, options.page.string() + ": " + fits.error().message});
  }

  view::LiveViewSettings settings{options.file, options.recipe, cooking_of(options, messages), {}};
  settings.server.port = options.port;
  settings.server.page = *page;
  platform::EndSignals ends;
  const auto view = view::LiveView::start(std::move(settings));
  if (!view) return tl::unexpected(view.error());
  print_result(address_text(options, (*view)->address()));
  std::fflush(stdout);
  ends.wait();
  return Exit::kOk;
}

}  // namespace coif::cli
