#include "bench/job_crew.h"

#include <pthread.h>
#include <sched.h>
#include <time.h>

#include <algorithm>

namespace coif {
namespace {

/// Jobs that a thread takes at once: the counter travels from core to core less often.
constexpr std::uint32_t kHandful = 2;

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

/// Keeps the calling thread on one of `cores`; counts round. Left to itself a busy machine puts two threads that never wait
/// on one core, where each stands in the other's way.
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

/// Of one thread, in a cache line of its own.
struct alignas(64) JobCrew::Times {
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
  for (std::uint32_t i = 0; i < threads; ++i) times_.push_back(std::make_unique<Times>());
  pthread_getaffinity_np(pthread_self(), sizeof(cores_), &cores_);
  for (std::uint32_t i = 1; i < threads; ++i) {
    workers_.emplace_back([this, i] {
      stay_on_core(cores_, i);
      serve(*times_[i]);
    });
  }
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
  take_jobs();
  end_round();
}

void JobCrew::run_alone(std::uint32_t jobs, const Work& work) {
  start_round(jobs, work, false);
  take_jobs();
  end_round();
}

void JobCrew::start_round(std::uint32_t jobs, const Work& work, bool is_shared) {
  work_ = &work;
  jobs_ = jobs;
  is_shared_ = is_shared;
  next_.store(0, std::memory_order_relaxed);
  at_work_.store(std::uint32_t(workers_.size()), std::memory_order_relaxed);
  round_.fetch_add(1, std::memory_order_release);
}

void JobCrew::end_round() {
  while (at_work_.load(std::memory_order_acquire) != 0) wait_a_moment();
  times_[0]->end_round();
}

double JobCrew::longest_absence() const {
  std::int64_t longest = 0;
  for (const auto& times : times_) longest = std::max(longest, times->absence);
  return 1e-9 * double(longest);
}

void JobCrew::serve(Times& times) {
  for (std::uint32_t served = 0;; ++served) {
    while (round_.load(std::memory_order_acquire) == served) wait_a_moment();
    if (is_over_) return;
    if (is_shared_) take_jobs();
    while (next_.load(std::memory_order_relaxed) < jobs_) wait_a_moment();
    times.end_round();
    at_work_.fetch_sub(1, std::memory_order_release);
  }
}

void JobCrew::take_jobs() {
  for (;;) {
    const std::uint32_t first = next_.fetch_add(kHandful, std::memory_order_relaxed);
    if (first >= jobs_) return;
    for (std::uint32_t job = first; job < std::min(first + kHandful, jobs_); ++job) (*work_)(job);
  }
}

}  // namespace coif
