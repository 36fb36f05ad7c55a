#pragma once

#include "base/json.h"
#include "base/tool_error.h"
#include "cook/cook.h"
#include "import/import.h"
#include "platform/job.h"
#include "platform/stop.h"
#include "view/server/file_watch.h"
#include "view/server/live_recipe.h"
#include "view/server/live_state.h"

#include <tl/expected.hpp>

#include <atomic>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace coif::view {

/// What `coif view` wants to have cooked.
struct LiveOrder {
  std::filesystem::path source;
  cook::Recipe recipe;
  std::filesystem::path recipe_directory;  ///< CookSettings::recipe_directory.
  importer::ImportSettings import;
  std::uint64_t source_hash = 0;  ///< CookSettings::source_hash.
  bool draft = true;              ///< CookSettings::draft.
  platform::Bytes model{};        ///< LiveCooked::model of the same source; empty: it is read.
};

struct LiveCooked {
  cook::CookResult result;
  platform::Bytes model;  ///< As it was read, in a form that LiveCook does not look into; empty where the order had it.
};

/// How `coif view` cooks. The functions are called on the thread of LiveCook::run() alone.
struct LiveCooking {
  bool draft = true;
  std::vector<std::filesystem::path> roots;  ///< ImportSettings::roots.
  std::function<importer::ImportSettings(const cook::Recipe& recipe, const std::vector<std::filesystem::path>& roots)>
      import_settings;
  /// Reads the source and cooks it in a process of its own, so that no source ends or fills the one that serves. Throws
  /// Stopped where `stop` is requested.
  std::function<tl::expected<LiveCooked, ToolError>(const LiveOrder& order, const std::stop_token& stop)> cook;
  // What became of a cook, unless it was obsolete. Always set.
  std::function<void(const LiveResult& result)> cooked;
  std::function<void(const std::string& problem)> failed;
};

/// What is cooked: a source, its recipe's file, and what the page changed of that. Calls from any thread but where it
/// says otherwise.
class LiveCook {
 public:
  /// `recipe`: none where it lies beside the source, if it is there (SOURCE's name with .recipe.json). `state` outlives
  /// this object and gets what becomes of each cook.
  LiveCook(LiveCooking cooking, std::filesystem::path source, std::optional<std::filesystem::path> recipe,
           LiveState& state);

  /// Another source takes the place of this one, with the defaults for a recipe, or the one that was named. `name` is
  /// for people.
  void take_source(std::filesystem::path source, std::string name);

  /// From now on these changes, and no others. Errors: those of read_changes() and live_recipe(), and nothing is
  /// changed.
  tl::expected<void, ToolError> change(std::string_view changes);

  /// Files that were read and were written since; what must be read anew is. On one thread.
  [[nodiscard]] bool files_changed();

  /// Work of LatestWork. What becomes of a cook that was asked to stop is told to nobody.
  void run(std::uint64_t number, const std::stop_token& stop);

 private:
  struct Order {
    std::filesystem::path source;
    std::optional<std::filesystem::path> recipe;
    std::string name;
    bool is_taken = false;  ///< Nothing lies beside it.
    nlohmann::json changes = nlohmann::json::object();

    /// Empty: none.
    [[nodiscard]] std::filesystem::path recipe_file() const;
    /// Where its paths start.
    [[nodiscard]] std::filesystem::path recipe_directory() const;
    /// Which is read once it appears.
    [[nodiscard]] std::filesystem::path recipe_place() const;
  };
  struct Imported {
    std::filesystem::path source;
    importer::ImportSettings settings;
    std::string values;     ///< source_values()
    platform::Bytes model;  ///< LiveCooked::model
    std::uint64_t hash = 0;
  };

  [[nodiscard]] Order order() const;
  tl::expected<LiveResult, ToolError> cook(const Order& order, const std::stop_token& stop);
  [[nodiscard]] bool is_imported(const LiveOrder& live, const std::string& values);
  void watch(const Order& order, const cook::CookInputs& inputs, FileWatch::Time since);

  LiveCooking cooking_;
  LiveState& state_;
  mutable std::mutex lock_;  ///< Of the two that follow.
  Order order_;
  FileWatch watch_;
  std::atomic<bool> is_stale_ = false;  ///< What was imported is out of date.
  std::optional<Imported> imported_;    ///< Of the thread that runs.
};

}  // namespace coif::view
