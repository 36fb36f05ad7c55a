#include "view/server/live_cook.h"

#include "base/files.h"
#include "cards/hair_source.h"
#include "payload_hash.h"
#include "platform/stop.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace coif::view {
namespace {

namespace fs = std::filesystem;

bool is_same(const importer::ImportSettings& a, const importer::ImportSettings& b) {
  return a.metres_per_unit == b.metres_per_unit && a.up_axis == b.up_axis;
}

/// A file that the page brought lies where nobody put it.
std::string with_name(std::string message, const fs::path& source, const std::string& name) {
  if (message.starts_with(source.string())) message.replace(0, source.string().size(), name);
  return message;
}

}  // namespace

fs::path LiveCook::Order::recipe_place() const {
  if (cook::is_recipe_file(source)) return source;
  if (recipe) return *recipe;
  fs::path beside = source;
  return is_taken ? fs::path() : beside.replace_extension(".recipe.json");
}

fs::path LiveCook::Order::recipe_file() const {
  std::error_code ignored;
  fs::path place = recipe_place();
  return recipe || fs::exists(place, ignored) ? place : fs::path();
}

fs::path LiveCook::Order::recipe_directory() const {
  const fs::path file = recipe_file();
  return (file.empty() ? source : file).parent_path();
}

LiveCook::LiveCook(LiveCooking cooking, fs::path source, std::optional<fs::path> recipe, LiveState& state)
    : cooking_(std::move(cooking)), state_(state), order_{std::move(source), std::move(recipe), {}, false} {
  order_.name = order_.source.filename().string();
  watch(order_, {}, FileWatch::Time::max());
}

LiveCook::Order LiveCook::order() const {
  const std::lock_guard guard(lock_);
  return order_;
}

void LiveCook::take_source(fs::path source, std::string name) {
  {
    const std::lock_guard guard(lock_);
    order_ = {std::move(source), order_.recipe, std::move(name), true};
    is_stale_ = true;
  }
  watch(order(), {}, FileWatch::Time::max());
}

tl::expected<void, ToolError> LiveCook::change(std::string_view text) {
  auto changes = read_changes(text);
  if (!changes) return tl::unexpected(changes.error());
  if (const auto merged = live_recipe(order().recipe_file(), *changes); !merged) return tl::unexpected(merged.error());
  const std::lock_guard guard(lock_);
  order_.changes = std::move(*changes);
  return {};
}

bool LiveCook::files_changed() {
  const std::lock_guard guard(lock_);
  const std::vector<fs::path> changed = watch_.changed();
  const fs::path recipe = order_.recipe_place();
  if (std::ranges::any_of(changed, [&](const fs::path& file) { return file != recipe || file == order_.source; }))
    is_stale_ = true;
  return !changed.empty();
}

void LiveCook::watch(const Order& order, const cook::CookInputs& inputs, FileWatch::Time since) {
  std::vector<fs::path> files{order.source};
  if (const fs::path recipe = order.recipe_place(); !recipe.empty()) files.push_back(recipe);
  files.insert(files.end(), inputs.source_files.begin(), inputs.source_files.end());
  files.insert(files.end(), inputs.recipe_files.begin(), inputs.recipe_files.end());
  const std::lock_guard guard(lock_);
  watch_.watch(files, since);
}

void LiveCook::run(std::uint64_t number, const std::stop_token& stop) try {
  const Order current = order();
  state_.begin();
  auto made = cook(current, stop);
  if (stop.stop_requested()) return;
  if (made) {
    cooking_.cooked(*made);
    state_.publish(number, std::move(*made));
  } else {
    std::string problem = made.error().message;
    if (current.is_taken) problem = with_name(std::move(problem), current.source, current.name);
    cooking_.failed(problem);
    state_.fail(number, std::move(problem));
  }
} catch (const platform::Stopped&) {
}

tl::expected<LiveResult, ToolError> LiveCook::cook(const Order& order, const std::stop_token& stop) try {
  const auto begin = std::chrono::steady_clock::now();
  const auto since = FileWatch::Time::clock::now();
  auto recipe = live_recipe(order.recipe_file(), order.changes);
  if (!recipe) return tl::unexpected(recipe.error());
  LiveOrder live{order.source, recipe->recipe, order.recipe_directory(),
                 cooking_.import_settings(recipe->recipe, cooking_.roots)};
  live.draft = cooking_.draft;
  std::string values = cards::source_values(recipe->recipe);
  if (is_imported(live, values)) {
    live.model = imported_->model;
    live.source_hash = imported_->hash;
  } else {
    imported_.reset();
    const auto bytes = FileBytes::read(order.source);
    if (!bytes) return tl::unexpected(bytes.error());
    live.source_hash = xxh64(bytes->span());
  }
  auto cooked = cooking_.cook(live, stop);
  if (!cooked) return tl::unexpected(cooked.error());
  if (!imported_)
    imported_ = Imported{order.source, live.import, std::move(values), std::move(cooked->model), live.source_hash};
  watch(order, cooked->result.inputs, since);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  return LiveResult{order.name,    std::move(cooked->result.asset),           std::move(recipe->file),
                    order.changes, std::move(cooked->result.report.warnings), seconds.count()};
} catch (const std::bad_alloc&) {
  return file_failure(ToolError::Kind::kBadInput, order.source, "not enough memory for this");
}

/// Whether the model of the last cook can be reused for this one.
bool LiveCook::is_imported(const LiveOrder& live, const std::string& values) {
  const bool is_stale = is_stale_.exchange(false);
  return !is_stale && imported_ && imported_->source == live.source && is_same(imported_->settings, live.import) &&
         imported_->values == values;
}

}  // namespace coif::view
