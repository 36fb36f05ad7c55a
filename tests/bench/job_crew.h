#pragma once

#include <sched.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

namespace coif {

/// The least that a game's own scheduler does: threads that stay alive from frame to frame and take jobs from counters.
/// Each begins with its own share, so that what a job touches is still in the cache of the core that ran it in the last
/// frame, and goes on with what others have left. They never sleep, since waking a thread takes as long as a frame of
/// this folder's crowds.
class JobCrew {
 public:
  /// Calls work(job). May be called from all threads of the crew at once.
  using Work = std::function<void(std::uint32_t job)>;

  /// So many threads, >= 1, the one that calls among them, each on a core of its own where there are as many.
  explicit JobCrew(std::uint32_t threads);
  ~JobCrew();
  JobCrew(const JobCrew&) = delete;
  JobCrew& operator=(const JobCrew&) = delete;

  /// Runs jobs 0..jobs-1, each once, and returns when all are done.
  void run(std::uint32_t jobs, const Work& work);
  /// The same on the thread that calls, while the others wait on their cores, where no other program runs meanwhile.
  void run_alone(std::uint32_t jobs, const Work& work);

  /// The longest that a thread of the crew was kept from its core between the ends of the last two run(), seconds: what
  /// it took by the clock without what it was given of a processor. On a machine that does other things too it tells
  /// frames in which all threads ran from those in which one waited for another program.
  [[nodiscard]] double longest_absence() const;

 private:
  struct Member;

  void start_round(std::uint32_t jobs, const Work& work, bool is_shared);
  void end_round();
  void serve(std::uint32_t index);
  void take_jobs(std::uint32_t index);

  std::vector<std::unique_ptr<Member>> members_;  ///< The caller first.
  std::vector<std::thread> workers_;
  cpu_set_t cores_{};  ///< That the caller may run on.
  const Work* work_ = nullptr;
  bool is_shared_ = true;
  bool is_over_ = false;
  alignas(64) std::atomic<std::uint32_t> round_{0};        ///< A new number sends the workers off.
  alignas(64) std::atomic<std::uint32_t> alone_until_{0};  ///< The last round of run_alone() that has ended.
  alignas(64) std::atomic<std::uint32_t> at_work_{0};
};

}  // namespace coif
