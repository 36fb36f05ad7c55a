#include "platform/child_process.h"

#include "platform/work_limit.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#include <cerrno>
#include <chrono>
#include <new>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>

namespace coif::child_process_test {

using Bytes = std::vector<std::uint8_t>;
using End = ChildResult::End;

constexpr ChildLimits kGenerous{std::uint64_t{1} << 30, 60, std::uint64_t{1} << 30};

void expect_no_child_left() {
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

TEST(ChildProcess, ReturnsMoreThanAPipeHolds) {
  const ChildResult result = run_in_child(kGenerous, [] { return Bytes(5 << 20, 7); });
  EXPECT_EQ(result.end, End::kFinished);
  EXPECT_EQ(result.output, Bytes(5 << 20, 7));
  expect_no_child_left();
}

TEST(ChildProcess, SignalIsACrashWithItsNumber) {
  const ChildResult result = run_in_child(kGenerous, []() -> Bytes {
    raise(SIGSEGV);
    return {};
  });
  EXPECT_EQ(result.end, End::kCrashed);
  EXPECT_TRUE(result.by_signal);
  EXPECT_EQ(result.code, SIGSEGV);
  expect_no_child_left();
}

TEST(ChildProcess, ExitInTheMiddleIsACrash) {
  const ChildResult result = run_in_child(kGenerous, []() -> Bytes { _exit(3); });
  EXPECT_EQ(result.end, End::kCrashed);
  EXPECT_EQ(result.code, 3);
}

TEST(ChildProcess, ExceptionsDoNotCrossTheFork) {
  EXPECT_EQ(run_in_child(kGenerous, []() -> Bytes { throw std::runtime_error("x"); }).end, End::kCrashed);
  EXPECT_EQ(run_in_child(kGenerous, []() -> Bytes { throw std::bad_alloc(); }).end, End::kOutOfMemory);
  expect_no_child_left();
}

TEST(ChildProcess, SleeperIsEndedByTheClock) {
  const auto start = std::chrono::steady_clock::now();
  const ChildResult result = run_in_child({1 << 30, 1, 1 << 20}, []() -> Bytes {
    std::this_thread::sleep_for(std::chrono::minutes(10));
    return {};
  });
  EXPECT_EQ(result.end, End::kTooSlow);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60));
  expect_no_child_left();
}

TEST(ChildProcess, NobodyWaitsLongerThanThisProcessMayWork) {
  const auto start = std::chrono::steady_clock::now();
  WorkLimit::set(std::chrono::milliseconds(50));
  EXPECT_THROW((void)run_in_child(kGenerous,
                                  []() -> Bytes {
                                    std::this_thread::sleep_for(std::chrono::minutes(10));
                                    return {};
                                  }),
               TookTooLong);
  WorkLimit::lift();
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
  expect_no_child_left();
}

TEST(ChildProcess, SleeperThatHasClosedItsPipeIsEndedToo) {
  const ChildResult result = run_in_child({1 << 30, 1, 1 << 20}, []() -> Bytes {
    for (int descriptor = 0; descriptor < 16; ++descriptor) close(descriptor);
    std::this_thread::sleep_for(std::chrono::minutes(10));
    return {};
  });
  EXPECT_EQ(result.end, End::kTooSlow);
  expect_no_child_left();
}

TEST(ChildProcess, OutputAboveTheLimitIsRefused) {
  const ChildResult result = run_in_child({1 << 30, 60, 1000}, [] { return Bytes(1001); });
  EXPECT_EQ(result.end, End::kTooMuchOutput);
  EXPECT_TRUE(result.output.empty());
  expect_no_child_left();
}

TEST(ChildProcess, ChildCannotWriteFiles) {
  const std::string path = testing::TempDir() + "coif-child-process-test";
  unlink(path.c_str());
  const ChildResult result = run_in_child(kGenerous, [&]() -> Bytes {
    signal(SIGXFSZ, SIG_IGN);
    const int file = open(path.c_str(), O_CREAT | O_WRONLY, 0600);
    return {static_cast<std::uint8_t>(file >= 0 && write(file, "x", 1) == 1 ? 1 : 0)};
  });
  unlink(path.c_str());
  ASSERT_EQ(result.end, End::kFinished);
  EXPECT_EQ(result.output, Bytes{0});
}

TEST(ChildProcess, ChildHoldsNoDescriptorOfTheParent) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const ChildResult result = run_in_child(kGenerous, [] {
    Bytes open_descriptors;
    for (std::uint8_t d = 0; d < 30; ++d) {
      if (fcntl(d, F_GETFD) >= 0) open_descriptors.push_back(d);
    }
    return open_descriptors;
  });
  close(ends[0]);
  close(ends[1]);
  EXPECT_EQ(result.output, (Bytes{0, 1, 2, 3}));  // three to /dev/null, and the pipe
}

TEST(ProcessPool, AnswersComeInOrderForAnyNumberOfJobs) {
  for (const unsigned jobs : {0u, 1u, 3u, 64u}) {
    const auto answers = run_in_processes(7, jobs, [](std::size_t i) { return std::string(i * 100'000, 'a'); });
    ASSERT_EQ(answers.size(), 7u);
    for (std::size_t i = 0; i < answers.size(); ++i) {
      ASSERT_TRUE(answers[i]) << i;
      EXPECT_EQ(answers[i]->size(), i * 100'000) << jobs;
    }
  }
}

TEST(ProcessPool, EachCallHasAProcessOfItsOwn) {
  const auto answers = run_in_processes(4, 2, [](std::size_t) { return std::to_string(::getpid()); });
  std::set<std::string> processes{std::to_string(::getpid())};
  for (const auto& answer : answers) EXPECT_TRUE(answer && processes.insert(*answer).second);
}

TEST(ProcessPool, OneThatDiesStopsNoOther) {
  const auto answers = run_in_processes(4, 2, [](std::size_t i) -> std::string {
    if (i == 1) ::kill(::getpid(), SIGKILL);
    if (i == 2) throw std::runtime_error("no");
    return "done";
  });
  EXPECT_EQ(answers[0], "done");
  EXPECT_FALSE(answers[1]);
  EXPECT_FALSE(answers[2]);
  EXPECT_EQ(answers[3], "done");
}

TEST(ProcessPool, LeavesNoChildBehind) {
  EXPECT_TRUE(run_in_processes(0, 2, [](std::size_t) { return std::string(); }).empty());
  (void)run_in_processes(3, 2, [](std::size_t) { return std::string(); });
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

}  // namespace coif::child_process_test
