#pragma once

#include "base/json.h"
#include "base/tool_error.h"
#include "cook/cook.h"
#include "import/import.h"
#include "view/server/file_watch.h"
#include "view/server/live_recipe.h"
#include "view/server/live_state.h"

#include <tl/expected.hpp>

#include <atomic>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace coif {

/// How `coif view` cooks. The functions are called on the thread of LiveCook::run() alone.
struct LiveCooking {
  bool draft = true;
  unsigned threads = 1;
  std::vector<std::filesystem::path> roots;  ///< ImportSettings::roots.
  std::function<ImportSettings(const Recipe& recipe, const std::vector<std::filesystem::path>& roots)> import_settings;
  /// cook().
  std::function<tl::expected<CookResult, ToolError>(const std::string& source, const SourceModel& model,
                                                    const Recipe& recipe, const CookSettings& settings)>
      cook;
  /// Calls `work`, which imports and cooks, within limits. Empty: without.
  std::function<tl::expected<LiveResult, ToolError>(const std::string& source,
                                                    const std::function<tl::expected<LiveResult, ToolError>()>& work)>
      within_limits{};
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

  /// Work of LatestWork. An outcome that is obsolete is told to nobody.
  void run(std::uint64_t number, const std::atomic<bool>& obsolete);
  /// To its `interrupt`: what computes or waits for a child process stops soon.
  static void interrupt();

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
    ImportSettings settings;
    std::string values;  ///< source_values()
    SourceModel model;
    std::uint64_t hash = 0;
  };

  [[nodiscard]] Order order() const;
  tl::expected<LiveResult, ToolError> cook(const Order& order, const std::atomic<bool>& obsolete);
  tl::expected<const Imported*, ToolError> import(const Order& order, const Recipe& recipe,
                                                  const std::atomic<bool>& obsolete);
  void watch(const Order& order, const CookInputs& inputs, FileWatch::Time since);

  LiveCooking cooking_;
  LiveState& state_;
  mutable std::mutex lock_;  ///< Of the two that follow.
  Order order_;
  FileWatch watch_;
  std::atomic<bool> is_stale_ = false;  ///< What was imported is out of date.
  std::optional<Imported> imported_;    ///< Of the thread that runs.
};

}  // namespace coif
