#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

namespace coif::view {

/// Repeats a piece of work on request, on a thread of its own: one at a time, and always the latest request. A new
/// request makes the running work obsolete, and at most one request waits.
class LatestWork {
 public:
  /// `stop` is requested while the work runs, if there is a new request; the work should then return soon.
  using Work = std::function<void(std::uint64_t number, const std::stop_token& stop)>;

  explicit LatestWork(Work work);
  /// Stops the running work and waits for its end.
  ~LatestWork();
  LatestWork(const LatestWork&) = delete;
  LatestWork& operator=(const LatestWork&) = delete;

  /// Returns the number of the requested work, unless another request replaces it before it begins. Numbers ascend from
  /// 1.
  std::uint64_t ask();

 private:
  void run();
  void make_obsolete();

  Work work_;
  std::mutex lock_;
  std::condition_variable asked_;
  std::uint64_t wanted_ = 0;
  std::uint64_t begun_ = 0;
  bool is_working_ = false;
  bool ends_ = false;
  std::stop_source stop_;  ///< Ends the work in progress.
  std::thread thread_;     ///< Last, so that all else is there when it begins.
};

}  // namespace coif::view
