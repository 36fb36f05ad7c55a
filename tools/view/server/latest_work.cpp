#include "view/server/latest_work.h"

#include <utility>

namespace coif::view {

LatestWork::LatestWork(Work work) : work_(std::move(work)), thread_([this] { run(); }) {}

LatestWork::~LatestWork() {
  {
    const std::lock_guard guard(lock_);
    ends_ = true;
    make_obsolete();
  }
  asked_.notify_one();
  thread_.join();
}

std::uint64_t LatestWork::ask() {
  std::uint64_t number = 0;
  {
    const std::lock_guard guard(lock_);
    number = ++wanted_;
    make_obsolete();
  }
  asked_.notify_one();
  return number;
}

void LatestWork::make_obsolete() {
  if (is_working_) stop_.request_stop();
}

void LatestWork::run() {
  std::unique_lock guard(lock_);
  for (;;) {
    asked_.wait(guard, [&] { return ends_ || wanted_ != begun_; });
    if (ends_) return;
    const std::uint64_t number = begun_ = wanted_;
    is_working_ = true;
    stop_ = std::stop_source();
    const std::stop_token stop = stop_.get_token();
    guard.unlock();
    work_(number, stop);
    guard.lock();
    is_working_ = false;
  }
}

}  // namespace coif::view
