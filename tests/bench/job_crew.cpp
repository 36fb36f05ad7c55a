#include "bench/job_crew.h"

#include <pthread.h>
#include <sched.h>
#include <time.h>

#include <algorithm>

namespace coif {
namespace {

std::int64_t nanoseconds(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

/// While a thread waits for a word of another, without asking for it more often than it can arrive.
void wait_a_moment() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

/// Keeps the calling thread on one of `cores`; counts round. Left to itself a busy machine puts two threads that never
/// wait on one core, where each stands in the other's way.
void stay_on_core(const cpu_set_t& cores, std::uint32_t which) {
  std::uint32_t left = which % std::uint32_t(CPU_COUNT(&cores));
  for (std::size_t core = 0; core < CPU_SETSIZE; ++core) {
    if (!CPU_ISSET(core, &cores) || left-- > 0) continue;
    cpu_set_t only;
    CPU_ZERO(&only);
    CPU_SET(core, &only);
    pthread_setaffinity_np(pthread_self(), sizeof(only), &only);
    return;
  }
}

}  // namespace

/// A thread of the crew, in cache lines of its own.
struct alignas(64) JobCrew::Member {
  std::atomic<std::uint32_t> next{0};  ///< The first job of its share that nobody has taken.
  std::uint32_t end = 0;
  std::int64_t clock = 0, own = 0;  ///< At the end of the last round, nanoseconds.
  std::int64_t absence = 0;

  void end_round() {
    const std::int64_t clock_now = nanoseconds(CLOCK_MONOTONIC), own_now = nanoseconds(CLOCK_THREAD_CPUTIME_ID);
    absence = (clock_now - clock) - (own_now - own);
    clock = clock_now;
    own = own_now;
  }
};

JobCrew::JobCrew(std::uint32_t threads) {
  pthread_getaffinity_np(pthread_self(), sizeof(cores_), &cores_);
  for (std::uint32_t i = 0; i < threads; ++i) members_.push_back(std::make_unique<Member>());
  for (std::uint32_t i = 1; i < threads; ++i) workers_.emplace_back([this, i] { serve(i); });
  stay_on_core(cores_, 0);
}

JobCrew::~JobCrew() {
  is_over_ = true;
  round_.fetch_add(1, std::memory_order_release);
  for (std::thread& worker : workers_) worker.join();
  pthread_setaffinity_np(pthread_self(), sizeof(cores_), &cores_);
}

void JobCrew::run(std::uint32_t jobs, const Work& work) {
  start_round(jobs, work, true);
  take_jobs(0);
  end_round();
}

void JobCrew::run_alone(std::uint32_t jobs, const Work& work) {
  start_round(jobs, work, false);
  for (std::uint32_t job = 0; job < jobs; ++job) work(job);
  alone_until_.store(round_.load(std::memory_order_relaxed), std::memory_order_relaxed);
  end_round();
}

double JobCrew::longest_absence() const {
  std::int64_t longest = 0;
  for (const auto& member : members_) longest = std::max(longest, member->absence);
  return 1e-9 * double(longest);
}

void JobCrew::start_round(std::uint32_t jobs, const Work& work, bool is_shared) {
  work_ = &work;
  is_shared_ = is_shared;
  const auto count = std::uint32_t(members_.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    members_[i]->next.store(jobs * i / count, std::memory_order_relaxed);
    members_[i]->end = jobs * (i + 1) / count;
  }
  at_work_.store(std::uint32_t(workers_.size()), std::memory_order_relaxed);
  round_.fetch_add(1, std::memory_order_release);
}

void JobCrew::end_round() {
  while (at_work_.load(std::memory_order_acquire) != 0) wait_a_moment();
  members_[0]->end_round();
}

void JobCrew::serve(std::uint32_t index) {
  stay_on_core(cores_, index);
  for (std::uint32_t round = 1;; ++round) {
    while (round_.load(std::memory_order_acquire) != round) wait_a_moment();
    if (is_over_) return;
    if (is_shared_) take_jobs(index);
    while (!is_shared_ && alone_until_.load(std::memory_order_relaxed) != round) wait_a_moment();
    members_[index]->end_round();
    at_work_.fetch_sub(1, std::memory_order_release);
  }
}

void JobCrew::take_jobs(std::uint32_t index) {
  const auto count = std::uint32_t(members_.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    Member& share = *members_[(index + i) % count];
    for (;;) {
      const std::uint32_t job = share.next.fetch_add(1, std::memory_order_relaxed);
      if (job >= share.end) break;
      (*work_)(job);
    }
  }
}

}  // namespace coif
