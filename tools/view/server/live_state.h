#pragma once

#include "base/json.h"

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace coif::view {

/// An asset as the page gets it. Never changes once it is published.
struct LiveAsset {
  std::vector<std::byte> bytes;
  std::uint64_t revision = 0;  ///< Ascending from 1.
};

/// What a cook that went well has to say beside its asset.
struct LiveResult {
  std::string name;  ///< Of the source, for people.
  std::vector<std::byte> asset;
  nlohmann::json recipe_file = nlohmann::json::object();  ///< What lies on the disk.
  nlohmann::json changes = nlohmann::json::object();      ///< What was cooked on top of it.
  Diagnostics warnings;
  double seconds = 0;
};

/// What became of the cooks. The cooking side writes, connections read and wait; all calls from any thread.
class LiveState {
 public:
  /// `quality`: "draft" or "full", for people.
  explicit LiveState(std::string quality);

  void begin();
  void publish(std::uint64_t request, LiveResult result);
  /// The last good asset stays.
  void fail(std::uint64_t request, std::string problem);
  /// Whoever waits is let go, now and from now on.
  void close();

  /// Null before the first.
  [[nodiscard]] std::shared_ptr<const LiveAsset> asset() const;

  struct News {
    std::uint64_t number = 0;  ///< Of the state; to wait for the next one.
    std::string json;          ///< In one line; empty where nothing came in time.
    bool is_closed = false;
  };
  /// The state as soon as it differs from the one of this number; 0: at once. {"revision", "request", "cooking",
  /// "problem", "name", "quality", "seconds", "warnings", "recipe_file", "changes"}: the first is the asset's, the
  /// second that of the last cook that ended; a problem is a sentence, or "".
  [[nodiscard]] News wait(std::uint64_t seen, std::chrono::milliseconds longest);

 private:
  [[nodiscard]] std::string json() const;
  void tell();

  mutable std::mutex lock_;
  std::condition_variable changed_;
  std::uint64_t number_ = 1;
  bool is_closed_ = false;
  bool is_cooking_ = false;
  std::uint64_t request_ = 0;
  std::string quality_, problem_;
  LiveResult result_;  ///< Without its bytes.
  std::shared_ptr<const LiveAsset> asset_;
};

}  // namespace coif::view
