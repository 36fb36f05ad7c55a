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

/// Finds which of some files were written, appeared or were removed, by comparing their times. For one thread.
class FileWatch {
 public:
  using Time = std::filesystem::file_time_type;

  /// Watches these files from now on, and no others. A file that was watched keeps its known state; a new one counts as
  /// changed where it was written after `since`, the time at which somebody began to read it.
  void watch(std::span<const std::filesystem::path> files, Time since);

  /// The files that have changed since the last call.
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

/// A recipe's file and a user's changes on the page.
struct LiveRecipe {
  cook::Recipe recipe;  ///< The file's, with the changes.
  nlohmann::json file;  ///< The file alone; an empty object without one.
};

/// Parses the page's message: recipe keys and their values, null for the default instead of the file's value. Errors
/// (kBadInput): not a JSON object, or it names a file, which only a recipe on the disk may. live_recipe() checks keys
/// and ranges.
[[nodiscard]] tl::expected<nlohmann::json, ToolError> read_changes(std::string_view text);

/// Reads the file (none for an empty path), merges the changes into it (RFC 7396) and checks the result like a recipe's
/// file. Errors: those of read_recipe() for the file; of parse_recipe() for the changes.
[[nodiscard]] tl::expected<LiveRecipe, ToolError> live_recipe(const std::filesystem::path& file,
                                                              const nlohmann::json& changes);

/// A cook for `coif view`.
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
  /// The imported model, in a form that LiveCook does not look into; empty if the order had it.
  platform::Bytes model;
};

/// The cooking functions of `coif view`. Only the thread of LiveCook::run() calls them.
struct LiveCooking {
  bool draft = true;
  std::vector<std::filesystem::path> roots;  ///< ImportSettings::roots.
  std::function<importer::ImportSettings(const cook::Recipe& recipe, const std::vector<std::filesystem::path>& roots)>
      import_settings;
  /// Reads the source and cooks it in a process of its own, so that no source can end the server or fill its memory.
  /// Throws Stopped where `stop` is requested.
  std::function<tl::expected<LiveCooked, ToolError>(const LiveOrder& order, const std::stop_token& stop)> cook;
  // Receives the result of a cook, unless it was obsolete. Always set.
  std::function<void(const LiveResult& result)> cooked;
  std::function<void(const std::string& problem)> failed;
};

/// The inputs of cooks: a source, its recipe's file, and the page's changes of that. Any thread may call, unless stated
/// otherwise.
class LiveCook {
 public:
  /// `recipe`: none for the recipe beside the source, if it exists (SOURCE's name with .recipe.json). `state` must
  /// outlive this object and receives the result of each cook.
  LiveCook(LiveCooking cooking, std::filesystem::path source, std::optional<std::filesystem::path> recipe,
           LiveState& state);

  /// Another source takes the place of this one, with the defaults for a recipe, or the one that was named. `name` is
  /// for people.
  void take_source(std::filesystem::path source, std::string name);

  /// Replaces the changes by these. Errors: those of read_changes() and live_recipe(); then nothing is changed.
  tl::expected<void, ToolError> change(std::string_view changes);

  /// Checks whether files that were read have been written since, and marks them to be read again. On one thread.
  [[nodiscard]] bool files_changed();

  /// The work of LatestWork. The result of a stopped cook is discarded.
  void run(std::uint64_t number, const std::stop_token& stop);

 private:
  struct Order {
    std::filesystem::path source;
    std::optional<std::filesystem::path> recipe;
    std::string name;
    bool is_taken = false;  ///< No recipe lies beside it.
    nlohmann::json changes = nlohmann::json::object();

    /// Empty: none.
    [[nodiscard]] std::filesystem::path recipe_file() const;
    /// The folder of its relative paths.
    [[nodiscard]] std::filesystem::path recipe_directory() const;
    /// The recipe is read once it appears.
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
  mutable std::mutex lock_;  ///< Guards the next two.
  Order order_;
  FileWatch watch_;
  std::atomic<bool> is_stale_ = false;  ///< The imported model is out of date.
  std::optional<Imported> imported_;    ///< Only the thread of run() uses it.
};

}  // namespace coif::view
