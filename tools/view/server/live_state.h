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

/// The result of a successful cook besides its asset.
struct LiveResult {
  std::string name;  ///< The source's name for people.
  std::vector<std::byte> asset;
  nlohmann::json recipe_file = nlohmann::json::object();  ///< The recipe on the disk.
  nlohmann::json changes = nlohmann::json::object();      ///< The changes of it that were cooked.
  Diagnostics warnings;
  double seconds = 0;
};

/// The results of cooks. The cooking side writes, connections read and wait; any thread may call.
class LiveState {
 public:
  /// `quality`: "draft" or "full", for people.
  explicit LiveState(std::string quality);

  void begin();
  void publish(std::uint64_t request, LiveResult result);
  /// The last good asset stays.
  void fail(std::uint64_t request, std::string problem);
  /// Releases all waiting threads, now and from now on.
  void close();

  /// Null before the first.
  [[nodiscard]] std::shared_ptr<const LiveAsset> asset() const;

  struct News {
    std::uint64_t number = 0;  ///< Number of the state; pass it to wait for the next one.
    std::string json;          ///< In one line; empty where there was no news in time.
    bool is_closed = false;
  };
  /// Waits for a state with another number than `seen`; 0: returns at once. The JSON is {"revision", "request",
  /// "cooking", "problem", "name", "quality", "seconds", "warnings", "recipe_file", "changes"}. "revision" is the
  /// asset's, "request" that of the last cook that ended; "problem" is a sentence, or "".
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
