#include "bench/job_crew.h"

#include "bench/timed_crowd.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

namespace coif::job_crew_test {

TEST(JobCrew, RunsEveryJobOnceInEveryRound) {
  for (const std::uint32_t threads : {1u, 2u, 3u}) {
    JobCrew crew(threads);
    for (const std::uint32_t jobs : {0u, 1u, 7u, 100u}) {
      std::vector<std::atomic<int>> runs(jobs);
      crew.run(jobs, [&runs](std::uint32_t job) { ++runs[job]; });
      crew.run_alone(jobs, [&runs](std::uint32_t job) { ++runs[job]; });
      EXPECT_TRUE(std::ranges::all_of(runs, [](const auto& count) { return count == 2; })) << threads << ", " << jobs;
    }
  }
}

TEST(JobCrew, KnowsThatAThreadWasAway) {
  using namespace std::chrono_literals;
  JobCrew crew(2);
  crew.run(2, [](std::uint32_t) {});
  crew.run(2, [](std::uint32_t) { std::this_thread::sleep_for(20ms); });
  EXPECT_GE(crew.longest_absence(), 0.015);
}

TEST(JobCrew, LeavesTheOthersOutOfWhatRunsAlone) {
  JobCrew crew(3);
  std::atomic<int> others{0};
  crew.run_alone(100, [&others, caller = std::this_thread::get_id()](std::uint32_t) {
    others += std::this_thread::get_id() != caller ? 1 : 0;
  });
  EXPECT_EQ(others, 0);
}

TEST(TimedCrowd, BearsACrew) {
  JobCrew crew(2);
  TimedCrowd crowd({CrowdShape{50, kCrowd.chains, kCrowd.bones}});
  for (int frame = 0; frame < 60; ++frame) {
    crowd.plan(kFrameSeconds);
    crowd.set_heads();
    crowd.step_with(crew, 1 / 60.0f, frame % 2 == 0);
  }
  EXPECT_TRUE(crowd.is_sane());
}

TEST(TimedCrowd, SleepsWhileItsHeadsStandStill) {
  TimedCrowd crowd({CrowdShape{40, kCrowd.chains, kCrowd.bones}});
  for (int frame = 0; frame < 600; ++frame) crowd.plan(0), crowd.set_heads(), crowd.step(1 / 60.0f);
  EXPECT_EQ(crowd.sleeping_heads(), 40u);
  crowd.plan(kFrameSeconds);
  crowd.set_heads();
  EXPECT_EQ(crowd.sleeping_heads(), 0u);
}

}  // namespace coif::job_crew_test
