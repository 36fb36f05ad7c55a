#pragma once

#include "base/tool_error.h"
#include "platform/files.h"
#include "view/server/latest_work.h"
#include "view/server/live_cook.h"
#include "view/server/live_server.h"
#include "view/server/live_state.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

namespace coif::view {

struct LiveViewSettings {
  std::filesystem::path source;
  std::optional<std::filesystem::path> recipe;  ///< None: what lies beside the source, if anything does.
  LiveCooking cooking;
  LiveServerSettings server;
};

/// A page that shows a source, and goes on showing it while source, recipe and sliders change. Works on threads of its
/// own until it is destroyed, and leaves no file and no process behind, however this process ends.
class LiveView {
 public:
  /// The first cook has begun when this returns, not ended. Errors: kFileAccess
  /// (no place for temporary files), and those of LiveServer::start().
  static tl::expected<std::unique_ptr<LiveView>, ToolError> start(LiveViewSettings settings);
  ~LiveView();
  LiveView(const LiveView&) = delete;
  LiveView& operator=(const LiveView&) = delete;

  [[nodiscard]] std::string address() const { return server_->address(); }

 private:
  LiveView(LiveViewSettings& settings, platform::ScratchFolder scratch);
  tl::expected<std::uint64_t, ToolError> drop(const char* suffix, std::string name, std::string_view bytes);
  void watch(const std::stop_token& stop);

  platform::ScratchFolder scratch_;
  std::mutex dropping_;
  std::uint64_t dropped_ = 0;  ///< Models so far.
  std::filesystem::path last_dropped_;
  LiveState state_;
  LiveCook cook_;
  LatestWork work_;
  std::unique_ptr<LiveServer> server_;
  std::jthread watcher_;
};

}  // namespace coif::view
