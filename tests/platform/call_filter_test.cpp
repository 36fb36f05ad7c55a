// What a process behind the filter of system calls can still ask for, tried by a child of this one.

#include "platform/child_process.h"
#include "platform/job.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <string>
#include <string_view>
#include <thread>

namespace coif::platform::call_filter_test {

bool forks() {
  const pid_t child = fork();
  if (child == 0) _exit(0);
  if (child > 0) waitpid(child, nullptr, 0);
  return child > 0;
}

/// The kernel would send it for input that comes.
bool has_parent_signalled() {
  int ends[2];
  return pipe(ends) == 0 && fcntl(ends[0], F_SETOWN, getppid()) == 0;
}

bool makes_pair() {
  int ends[2];
  return socketpair(AF_UNIX, SOCK_STREAM, 0, ends) == 0;
}

bool limits_parent() {
  const rlimit limit{1, 1};
  return prlimit(getppid(), RLIMIT_CORE, &limit, nullptr) == 0;
}

bool reads_own_limits() {
  rlimit limit{};
  return getrlimit(RLIMIT_AS, &limit) == 0 && prlimit(0, RLIMIT_AS, nullptr, &limit) == 0;
}

bool runs_thread() {
  bool ran = false;
  std::thread([&ran] { ran = true; }).join();
  return ran;
}

struct Attempt {
  std::string_view name;
  bool (*works)();
};

constexpr Attempt kAttempts[] = {
    {"nothing", [] { return true; }},
    {"UDP, which Landlock leaves alone", [] { return socket(AF_INET, SOCK_DGRAM, 0) >= 0; }},
    {"a local socket", [] { return socket(AF_UNIX, SOCK_STREAM, 0) >= 0; }},
    {"a pair of sockets", makes_pair},
    {"fork", forks},
    {"vfork", [] { return vfork() >= 0; }},
    {"another program", [] { return execl("/bin/true", "true", nullptr) == 0 || errno != EPERM; }},
    {"a signal to the parent", [] { return kill(getppid(), 0) == 0; }},
    {"a signal to its group", [] { return kill(0, 0) == 0; }},
    {"a signal to everybody", [] { return kill(-1, 0) == 0; }},
    {"tracing", [] { return ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) == 0; }},
    {"limits of the parent", limits_parent},
    {"a signal by a descriptor", has_parent_signalled},
    {"a thread", runs_thread},
    {"a file", [] { return open("/dev/null", O_RDONLY) >= 0; }},
    {"a signal to itself", [] { return kill(getpid(), 0) == 0 && raise(0) == 0; }},
    {"its own limits", reads_own_limits},
};

std::string text_of(std::span<const std::uint8_t> bytes) { return {bytes.begin(), bytes.end()}; }

const Job kTry("test.behind the filter", [](const JobCall& call) -> Bytes {
  if (!filter_calls()) return {};
  const std::string name = text_of(call.request());
  return {std::uint8_t(std::ranges::find(kAttempts, name, &Attempt::name)->works() ? 'y' : 'n')};
});

/// Whether an attempt works behind the filter: 'y' or 'n'; nothing where there can be no filter.
std::string behind(std::string_view attempt) {
  EXPECT_NE(std::ranges::find(kAttempts, attempt, &Attempt::name), std::end(kAttempts)) << attempt;
  const auto result = run_in_child(kTry, Bytes(attempt.begin(), attempt.end()), {.limits = {1 << 30, 20, 64}});
  EXPECT_EQ(result.end, ChildResult::End::kFinished);
  return text_of(result.output);
}

bool has_filter() { return behind("nothing") == "y"; }

TEST(CallFilter, RefusesSocketsProcessesAndPrograms) {
  if (!has_filter()) GTEST_SKIP() << "this kernel or processor has no filter of system calls";
  for (const char* attempt :
       {"UDP, which Landlock leaves alone", "a local socket", "a pair of sockets", "fork", "vfork", "another program"})
    EXPECT_EQ(behind(attempt), "n") << attempt;
}

TEST(CallFilter, RefusesWhatReachesOtherProcesses) {
  if (!has_filter()) GTEST_SKIP() << "this kernel or processor has no filter of system calls";
  for (const char* attempt : {"a signal to the parent", "a signal to its group", "a signal to everybody", "tracing",
                              "limits of the parent", "a signal by a descriptor"})
    EXPECT_EQ(behind(attempt), "n") << attempt;
}

TEST(CallFilter, LeavesThreadsFilesAndItself) {
  if (!has_filter()) GTEST_SKIP() << "this kernel or processor has no filter of system calls";
  for (const char* attempt : {"a thread", "a file", "a signal to itself", "its own limits"})
    EXPECT_EQ(behind(attempt), "y") << attempt;
  EXPECT_TRUE(forks()) << "and this process is as it was";
}

const Job kAbort("test.abort behind the filter", [](const JobCall&) -> Bytes {
  filter_calls();
  std::abort();
});

TEST(CallFilter, AbortStaysACrash) {
  if (!has_filter()) GTEST_SKIP() << "this kernel or processor has no filter of system calls";
  const auto result = run_in_child(kAbort, {}, {.limits = {1 << 30, 20, 64}});
  EXPECT_EQ(result.end, ChildResult::End::kCrashed);
  EXPECT_EQ(result.code, SIGABRT);
}

const Job kLockUp("test.lock up", [](const JobCall&) -> Bytes {
  const bool is_locked = lock_up({}, {});
  return {std::uint8_t(is_locked), std::uint8_t(open("/etc/passwd", O_RDONLY) >= 0), std::uint8_t(forks())};
});

TEST(CallFilter, LockedUpIsBoth) {
  if (!missing_sandbox().empty()) GTEST_SKIP() << missing_sandbox();
  EXPECT_EQ(run_in_child(kLockUp, {}, {.limits = {1 << 30, 20, 64}}).output, (Bytes{1, 0, 0}));
}

}  // namespace coif::platform::call_filter_test
