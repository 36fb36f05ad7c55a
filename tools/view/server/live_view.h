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
  std::optional<std::filesystem::path> recipe;  ///< None: the recipe beside the source, if any.
  LiveCooking cooking;
  LiveServerSettings server;
};

/// A page that shows a source and follows changes of source, recipe and sliders. Works on its own threads until it is
/// destroyed, and leaves no file and no process behind, however this process ends.
class LiveView {
 public:
  /// When this returns the first cook has begun, but not ended. Errors: kFileAccess (no place for temporary files), and
  /// those of LiveServer::start().
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
