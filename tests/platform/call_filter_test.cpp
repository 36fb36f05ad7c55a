// What a process behind the filter of system calls can still ask for, tried by a child of this one.

#include "platform/child_process.h"
#include "platform/sandbox.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <cerrno>
#include <csignal>
#include <functional>
#include <string>
#include <thread>

namespace coif::call_filter_test {

/// Behind the filter: 'y' or 'n'; nothing where there can be no filter.
std::string behind(const std::function<bool()>& attempt) {
  const auto result = run_in_child({std::uint64_t{1} << 30, 20, 64}, [&]() -> std::vector<std::uint8_t> {
    if (!filter_calls()) return {};
    return {std::uint8_t(attempt() ? 'y' : 'n')};
  });
  EXPECT_EQ(result.end, ChildResult::End::kFinished);
  return {result.output.begin(), result.output.end()};
}

bool has_filter() {
  const std::string inside = behind([] { return true; });
  return inside == "y";
}

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

TEST(CallFilter, RefusesSocketsProcessesAndPrograms) {
  if (!has_filter()) GTEST_SKIP() << "this kernel or processor has no filter of system calls";
  EXPECT_EQ(behind([] { return socket(AF_INET, SOCK_DGRAM, 0) >= 0; }), "n") << "UDP, which Landlock leaves alone";
  EXPECT_EQ(behind([] { return socket(AF_UNIX, SOCK_STREAM, 0) >= 0; }), "n");
  EXPECT_EQ(behind([] {
              int ends[2];
              return socketpair(AF_UNIX, SOCK_STREAM, 0, ends) == 0;
            }),
            "n");
  EXPECT_EQ(behind(forks), "n");
  EXPECT_EQ(behind([] { return vfork() >= 0; }), "n");
  EXPECT_EQ(behind([] { return execl("/bin/true", "true", nullptr) == 0 || errno != EPERM; }), "n");
}

TEST(CallFilter, RefusesWhatReachesOtherProcesses) {
  if (!has_filter()) GTEST_SKIP() << "this kernel or processor has no filter of system calls";
  EXPECT_EQ(behind([] { return kill(getppid(), 0) == 0; }), "n");
  EXPECT_EQ(behind([] { return kill(0, 0) == 0; }), "n") << "its group";
  EXPECT_EQ(behind([] { return kill(-1, 0) == 0; }), "n") << "everybody";
  EXPECT_EQ(behind([] { return ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) == 0; }), "n");
  EXPECT_EQ(behind([] {
              const rlimit limit{1, 1};
              return prlimit(getppid(), RLIMIT_CORE, &limit, nullptr) == 0;
            }),
            "n");
  EXPECT_EQ(behind(has_parent_signalled), "n");
}

TEST(CallFilter, LeavesThreadsFilesAndItself) {
  if (!has_filter()) GTEST_SKIP() << "this kernel or processor has no filter of system calls";
  EXPECT_EQ(behind([] {
              bool ran = false;
              std::thread([&ran] { ran = true; }).join();
              return ran;
            }),
            "y");
  EXPECT_EQ(behind([] { return open("/dev/null", O_RDONLY) >= 0; }), "y");
  EXPECT_EQ(behind([] { return kill(getpid(), 0) == 0 && raise(0) == 0; }), "y");
  EXPECT_EQ(behind([] {
              rlimit limit{};
              return getrlimit(RLIMIT_AS, &limit) == 0 && prlimit(0, RLIMIT_AS, nullptr, &limit) == 0;
            }),
            "y");
  EXPECT_TRUE(forks()) << "and this process is as it was";
}

TEST(CallFilter, AbortStaysACrash) {
  if (!has_filter()) GTEST_SKIP() << "this kernel or processor has no filter of system calls";
  const auto result = run_in_child({std::uint64_t{1} << 30, 20, 64}, []() -> std::vector<std::uint8_t> {
    filter_calls();
    std::abort();
  });
  EXPECT_EQ(result.end, ChildResult::End::kCrashed);
  EXPECT_EQ(result.code, SIGABRT);
}

TEST(CallFilter, LockedUpIsBoth) {
  if (!missing_sandbox().empty()) GTEST_SKIP() << missing_sandbox();
  const auto result = run_in_child({std::uint64_t{1} << 30, 20, 64}, []() -> std::vector<std::uint8_t> {
    const bool is_locked = lock_up({}, {});
    return {std::uint8_t(is_locked), std::uint8_t(open("/etc/passwd", O_RDONLY) >= 0), std::uint8_t(forks())};
  });
  EXPECT_EQ(result.output, (std::vector<std::uint8_t>{1, 0, 0}));
}

/// A descriptor more than a program has at its start, and the pipe, is enough; one less is told as what it is.
TEST(ChildProcess, NeedsFewDescriptorsAndSaysWhenThereAreNone) {
  const auto with = [](rlim_t most) {
    return run_in_child({std::uint64_t{1} << 30, 20, 1 << 20}, [most]() -> std::vector<std::uint8_t> {
      const rlimit limit{most, most};
      setrlimit(RLIMIT_NOFILE, &limit);
      const auto inner = run_in_child({std::uint64_t{1} << 30, 20, 64}, [] { return std::vector<std::uint8_t>{7}; });
      return {std::uint8_t(inner.end), std::uint8_t(inner.code),
              inner.output.empty() ? std::uint8_t(0) : inner.output[0]};
    });
  };
  EXPECT_EQ(with(8).output, (std::vector<std::uint8_t>{std::uint8_t(ChildResult::End::kFinished), 0, 7}));
  EXPECT_EQ(with(6).output, (std::vector<std::uint8_t>{std::uint8_t(ChildResult::End::kNotStarted), EMFILE, 0}));
}

}  // namespace coif::call_filter_test
