#pragma once

#include "base/json.h"
#include "base/tool_error.h"
#include "cook/cook.h"
#include "cook/recipe/recipe.h"
#include "import/import.h"
#include "platform/job.h"
#include "platform/stop.h"
#include "view/server/live_state.h"

#include <tl/expected.hpp>

#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace coif::view {

/// Tells which of some files were written, appeared or went, by asking for their times. For one thread.
class FileWatch {
 public:
  using Time = std::filesystem::file_time_type;

  /// From now on these and no others. A file that was watched keeps what is known of it; a new one counts as changed
  /// where it was written after `since`, when somebody began to read it.
  void watch(std::span<const std::filesystem::path> files, Time since);

  /// Those that differ from what they were at the last call.
  [[nodiscard]] std::vector<std::filesystem::path> changed();

 private:
  struct Stamp {
    Time written;
    std::uintmax_t bytes = 0;
    bool operator==(const Stamp&) const = default;
  };
  /// None for a file that is not there.
  static std::optional<Stamp> stamp_of(const std::filesystem::path& file);

  struct Watched {
    std::optional<Stamp> stamp;
    bool is_new = false;  ///< Changed before it was watched.
  };
  std::map<std::filesystem::path, Watched> files_;
};

/// A recipe's file and what somebody changed of it on the page.
struct LiveRecipe {
  cook::Recipe recipe;  ///< The file's, with the changes.
  nlohmann::json file;  ///< The file alone; an empty object without one.
};

/// What the page sent: recipe keys and their values, null for "not as the file says". Errors (kBadInput): no JSON
/// object, or it names a file, which a recipe on the disk alone may. That the keys are some, and their values in range,
/// live_recipe() finds.
[[nodiscard]] tl::expected<nlohmann::json, ToolError> read_changes(std::string_view text);

/// Reads the file, none where its path is empty, merges the changes into it (RFC 7396) and judges the result as a
/// recipe's file is. Errors: those of read_recipe() for the file; of parse_recipe() for the changes.
[[nodiscard]] tl::expected<LiveRecipe, ToolError> live_recipe(const std::filesystem::path& file,
                                                              const nlohmann::json& changes);

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
