#include "process/process_pool.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <signal.h>

#include <cerrno>
#include <set>
#include <stdexcept>

namespace coif {
namespace {

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

}  // namespace
}  // namespace coif
