#include "view/server/live_view.h"

#include "base/files.h"

#include <fmt/format.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <system_error>
#include <utility>

namespace coif::view {
namespace {

constexpr std::chrono::milliseconds kBetweenLooks{300};

}  // namespace

LiveView::LiveView(LiveViewSettings& settings, platform::ScratchFolder scratch)
    : scratch_(std::move(scratch)),
      state_(settings.cooking.draft ? "draft" : "full"),
      cook_(std::move(settings.cooking), std::move(settings.source), std::move(settings.recipe), state_),
      work_([this](std::uint64_t number, const std::stop_token& stop) { cook_.run(number, stop); }) {}

tl::expected<std::unique_ptr<LiveView>, ToolError> LiveView::start(LiveViewSettings settings) {
  auto scratch = platform::ScratchFolder::create();
  if (!scratch) {
    return file_failure(ToolError::Kind::kFileAccess, scratch.error().place,
                        "cannot make a folder for temporary files: {}", scratch.error().why.message());
  }
  std::unique_ptr<LiveView> view(new LiveView(settings, std::move(*scratch)));
  LiveView& self = *view;
  LiveRequests requests;
  requests.change = [&self](std::string_view changes) -> tl::expected<std::uint64_t, ToolError> {
    if (auto changed = self.cook_.change(changes); !changed) return tl::unexpected(changed.error());
    return self.work_.ask();
  };
  requests.drop = [&self](const char* suffix, std::string name, std::string_view bytes) {
    return self.drop(suffix, std::move(name), bytes);
  };
  auto server = LiveServer::start(std::move(settings.server), self.state_, std::move(requests));
  if (!server) return tl::unexpected(server.error());
  self.server_ = std::move(*server);
  self.work_.ask();
  self.watcher_ = std::jthread([&self](const std::stop_token& stop) { self.watch(stop); });
  return view;
}

LiveView::~LiveView() {
  watcher_ = {};
  server_.reset();  // No more requests; LatestWork ends the running cook.
}

/// Only one of them exists at a time, under a name of ours.
tl::expected<std::uint64_t, ToolError> LiveView::drop(const char* suffix, std::string name, std::string_view bytes) {
  const std::lock_guard guard(dropping_);
  const std::filesystem::path place = scratch_.path() / fmt::format("model_{}{}", ++dropped_, suffix);
  if (auto written = write_output(place, std::as_bytes(std::span(bytes))); !written)
    return tl::unexpected(written.error());
  cook_.take_source(place, std::move(name));
  const std::uint64_t request = work_.ask();
  std::error_code ignored;
  if (!last_dropped_.empty()) std::filesystem::remove(last_dropped_, ignored);
  last_dropped_ = place;
  return request;
}

void LiveView::watch(const std::stop_token& stop) {
  std::mutex lock;
  std::condition_variable_any never;
  std::unique_lock guard(lock);
  while (!never.wait_for(guard, stop, kBetweenLooks, [] { return false; }) && !stop.stop_requested()) {
    if (cook_.files_changed()) work_.ask();
  }
}

}  // namespace coif::view
