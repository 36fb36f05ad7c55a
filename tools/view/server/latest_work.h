#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

namespace coif::view {

/// Does a piece of work again whenever somebody asks, on a thread of its own: one at a time, and the last one that was
/// asked for. Whoever asks makes what is being done obsolete, and what waits is never more than one piece.
class LatestWork {
 public:
  /// `stop` is requested while the work is done, where somebody asked anew; the work should then return soon.
  using Work = std::function<void(std::uint64_t number, const std::stop_token& stop)>;

  explicit LatestWork(Work work);
  /// Makes obsolete what is being done, and waits for its end.
  ~LatestWork();
  LatestWork(const LatestWork&) = delete;
  LatestWork& operator=(const LatestWork&) = delete;

  /// Returns the number that the work will have, unless another is asked for before it begins. Numbers ascend from 1.
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
