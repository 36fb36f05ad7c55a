#include "view/server/live_cook.h"

#include "base/files.h"
#include "base/parallel_for.h"
#include "cards/hair_source.h"
#include "payload_hash.h"
#include "platform/work_limit.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

namespace coif {
namespace {

namespace fs = std::filesystem;

bool is_same(const ImportSettings& a, const ImportSettings& b) {
  return a.metres_per_unit == b.metres_per_unit && a.up_axis == b.up_axis;
}

/// Ends what is out of date.
std::function<void(const char*)> stop_if(const std::atomic<bool>& obsolete) {
  return [&obsolete](const char*) {
    if (obsolete) throw TookTooLong();
  };
}

/// A file that the page brought lies where nobody put it.
std::string with_name(std::string message, const fs::path& source, const std::string& name) {
  if (message.starts_with(source.string())) message.replace(0, source.string().size(), name);
  return message;
}

}  // namespace

fs::path LiveCook::Order::recipe_place() const {
  if (is_recipe_file(source)) return source;
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

void LiveCook::watch(const Order& order, const CookInputs& inputs, FileWatch::Time since) {
  std::vector<fs::path> files{order.source};
  if (const fs::path recipe = order.recipe_place(); !recipe.empty()) files.push_back(recipe);
  files.insert(files.end(), inputs.source_files.begin(), inputs.source_files.end());
  files.insert(files.end(), inputs.recipe_files.begin(), inputs.recipe_files.end());
  const std::lock_guard guard(lock_);
  watch_.watch(files, since);
}

void LiveCook::interrupt() { WorkLimit::set(WorkLimit::Duration::zero()); }

void LiveCook::run(std::uint64_t number, const std::atomic<bool>& obsolete) {
  WorkLimit::lift();  // an interruption may have come when its work had just ended
  const Order current = order();
  state_.begin();
  const auto work = [&] { return cook(current, obsolete); };
  auto made = cooking_.within_limits ? cooking_.within_limits(current.source.string(), work) : work();
  if (obsolete) return;
  if (made) {
    cooking_.cooked(*made);
    state_.publish(number, std::move(*made));
  } else {
    std::string problem = made.error().message;
    if (current.is_taken) problem = with_name(std::move(problem), current.source, current.name);
    cooking_.failed(problem);
    state_.fail(number, std::move(problem));
  }
}

tl::expected<LiveResult, ToolError> LiveCook::cook(const Order& order, const std::atomic<bool>& obsolete) try {
  const auto begin = std::chrono::steady_clock::now();
  const auto since = FileWatch::Time::clock::now();
  const fs::path recipe_file = order.recipe_file();
  auto recipe = live_recipe(recipe_file, order.changes);
  if (!recipe) return tl::unexpected(recipe.error());
  const auto imported = import(order, recipe->recipe, obsolete);
  if (!imported) return tl::unexpected(imported.error());
  CookSettings settings;
  settings.threads = cooking_.threads;
  settings.recipe_directory = order.recipe_directory();
  settings.source_hash = (*imported)->hash;
  settings.draft = cooking_.draft;
  settings.progress = stop_if(obsolete);
  auto cooked = cooking_.cook(order.source.string(), (*imported)->model, recipe->recipe, settings);
  if (!cooked) return tl::unexpected(cooked.error());
  watch(order, cooked->inputs, since);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  return LiveResult{order.name,
                    std::move(cooked->asset),
                    std::move(recipe->file),
                    order.changes,
                    {cooked->report.warnings.begin(), cooked->report.warnings.end()},
                    seconds.count()};
} catch (const TookTooLong&) {
  if (!obsolete && cooking_.within_limits) throw;
  return failure(ToolError::Kind::kBadInput, "what was cooked is out of date");
} catch (const std::bad_alloc&) {
  if (cooking_.within_limits) throw;
  return file_failure(ToolError::Kind::kBadInput, order.source, "not enough memory for this");
}

tl::expected<const LiveCook::Imported*, ToolError> LiveCook::import(const Order& order, const Recipe& recipe,
                                                                    const std::atomic<bool>& obsolete) {
  ImportSettings settings = cooking_.import_settings(recipe, cooking_.roots);
  const bool is_stale = is_stale_.exchange(false);
  std::string values = source_values(recipe);
  if (!is_stale && imported_ && imported_->source == order.source && is_same(imported_->settings, settings) &&
      imported_->values == values)
    return &*imported_;
  imported_.reset();
  const auto bytes = FileBytes::read(order.source);
  if (!bytes) return tl::unexpected(bytes.error());
  auto model = read_hair_source(order.source, cooking_.draft ? draft_of(recipe) : recipe,
                                {settings, order.recipe_directory(), cooking_.threads, stop_if(obsolete)});
  if (!model) return tl::unexpected(model.error());
  imported_ = Imported{order.source, std::move(settings), std::move(values), std::move(*model), xxh64(bytes->span())};
  return &*imported_;
}

}  // namespace coif
