#include "platform/child_process.h"

#include "platform/stop.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <new>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>

namespace coif::platform::child_process_test {

using End = ChildResult::End;
using namespace std::chrono_literals;

constexpr ChildLimits kGenerous{std::uint64_t{1} << 30, 60, std::uint64_t{1} << 30};
constexpr std::uint64_t kMuch = std::uint64_t{1} << 30;

std::string text_of(std::span<const std::uint8_t> bytes) { return {bytes.begin(), bytes.end()}; }
Bytes bytes_of(const std::string& text) { return {text.begin(), text.end()}; }

// What the children do.
const Job kEcho("test.echo", [](const JobCall& call) { return Bytes(call.request().begin(), call.request().end()); });
const Job kFill("test.fill", [](const JobCall& call) { return Bytes(std::stoul(text_of(call.request())), 7); });
const Job kSignal("test.signal", [](const JobCall&) -> Bytes {
  raise(SIGSEGV);
  return {};
});
const Job kExit("test.exit", [](const JobCall&) -> Bytes { _exit(3); });
const Job kLeave("test.leave", [](const JobCall&) -> Bytes { _exit(0); });
const Job kThrow("test.throw", [](const JobCall&) -> Bytes { throw std::runtime_error("x"); });
const Job kNoMemory("test.no memory", [](const JobCall&) -> Bytes { throw std::bad_alloc(); });
const Job kSleep("test.sleep", [](const JobCall&) -> Bytes {
  std::this_thread::sleep_for(10min);
  return {};
});
const Job kCloseAndSleep("test.close and sleep", [](const JobCall&) -> Bytes {
  for (int descriptor = 0; descriptor < 16; ++descriptor) close(descriptor);
  std::this_thread::sleep_for(10min);
  return {};
});
const Job kTake("test.take", [](const JobCall& call) -> Bytes {
  const auto memory = std::make_unique<char[]>(std::stoul(text_of(call.request())));
  return {std::uint8_t(memory[0])};
});
const Job kWrite("test.write", [](const JobCall& call) -> Bytes {
  signal(SIGXFSZ, SIG_IGN);
  const int file = open(text_of(call.request()).c_str(), O_CREAT | O_WRONLY, 0600);
  return {std::uint8_t(file >= 0 && write(file, "x", 1) == 1 ? 1 : 0)};
});
const Job kDescriptors("test.descriptors", [](const JobCall&) {
  Bytes open_descriptors;
  for (std::uint8_t d = 0; d < 30; ++d) {
    if (fcntl(d, F_GETFD) >= 0) open_descriptors.push_back(d);
  }
  return open_descriptors;
});
const Job kNotes("test.notes", [](const JobCall& call) -> Bytes {
  for (const char* note : {"one", "", "three"}) call.note(note);
  std::this_thread::sleep_for(std::chrono::milliseconds(std::stoul(text_of(call.request()))));
  return {1};
});
/// Writes that it ended in order to the file that it is asked to.
const Job kWaitForStop("test.wait for stop", [](const JobCall& call) -> Bytes {
  const std::stop_token stop = call.stop();
  call.note("waits");
  while (!stop.stop_requested()) std::this_thread::sleep_for(1ms);
  std::ofstream(text_of(call.request())) << "in order";
  throw Stopped();
});
const Job kFewDescriptors("test.few descriptors", [](const JobCall& call) -> Bytes {
  const rlimit limit{call.request()[0], call.request()[0]};
  setrlimit(RLIMIT_NOFILE, &limit);
  const ChildResult inner = run_in_child(kEcho, Bytes{7}, {.limits = kGenerous});
  return {std::uint8_t(inner.end), std::uint8_t(inner.code), inner.output.empty() ? std::uint8_t(0) : inner.output[0]};
});
/// Sends the number of a process that it started, and waits for ever.
const Job kParent("test.parent", [](const JobCall& call) -> Bytes {
  const ChildResult never =
      run_in_child(kNotes, bytes_of("600000"),
                   {ChildKind::kWorker, {}, {}, [&call](std::string_view note) {
                      if (note != "three") return;
                      std::ifstream children("/proc/self/task/" + std::to_string(getpid()) + "/children");
                      std::string number;
                      children >> number;
                      call.note(number);
                    }});
  return never.output;
});
const Job kNumber("test.number", [](const JobCall&) { return bytes_of(std::to_string(getpid())); });
const Job kSome("test.some", [](const JobCall& call) -> Bytes {
  if (call.request()[0] == 1) kill(getpid(), SIGKILL);
  if (call.request()[0] == 2) throw std::runtime_error("no");
  return bytes_of("done");
});

ChildResult read_by(const Job& job, const std::string& request = {}, const ChildLimits& limits = kGenerous) {
  return run_in_child(job, bytes_of(request), {.limits = limits});
}

void expect_no_child_left() {
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

bool is_gone(const std::string& process) {
  for (const auto end = std::chrono::steady_clock::now() + 10s; std::chrono::steady_clock::now() < end;) {
    if (access(("/proc/" + process).c_str(), F_OK) != 0) return true;
    std::this_thread::sleep_for(5ms);
  }
  return false;
}

TEST(ChildProcess, TakesAndReturnsMoreThanALineHolds) {
  Bytes bytes(5 << 20);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = std::uint8_t(i * 7 + i / 256);
  for (const ChildKind kind : {ChildKind::kReader, ChildKind::kWorker}) {
    const ChildResult result = run_in_child(kEcho, bytes, {kind, kGenerous});
    EXPECT_EQ(result.end, End::kFinished);
    EXPECT_EQ(result.output, bytes);
  }
  EXPECT_TRUE(run_in_child(kEcho, {}, {}).output.empty());
  expect_no_child_left();
}

TEST(ChildProcess, SignalIsACrashWithItsNumber) {
  const ChildResult result = read_by(kSignal);
  EXPECT_EQ(result.end, End::kCrashed);
  EXPECT_TRUE(result.by_signal);
  EXPECT_EQ(result.code, SIGSEGV);
  expect_no_child_left();
}

TEST(ChildProcess, ExitInTheMiddleIsACrash) {
  const ChildResult result = read_by(kExit);
  EXPECT_EQ(result.end, End::kCrashed);
  EXPECT_EQ(result.code, 3);
  EXPECT_EQ(read_by(kLeave).end, End::kCrashed) << "no answer, whatever the status";
}

TEST(ChildProcess, ExceptionsAreToldAsFailures) {
  EXPECT_EQ(read_by(kThrow).end, End::kCrashed);
  EXPECT_EQ(read_by(kNoMemory).end, End::kOutOfMemory);
  expect_no_child_left();
}

TEST(ChildProcess, MemoryIsLimitedBesideWhatAProgramBeginsWith) {
  if (!kMemoryIsLimited) GTEST_SKIP() << "not under AddressSanitizer";
  const ChildLimits small{std::uint64_t{64} << 20, 60, kMuch};
  for (const ChildKind kind : {ChildKind::kReader, ChildKind::kWorker}) {
    EXPECT_EQ(run_in_child(kTake, bytes_of(std::to_string(32 << 20)), {kind, small}).end, End::kFinished);
    EXPECT_EQ(run_in_child(kTake, bytes_of(std::to_string(128 << 20)), {kind, small}).end, End::kOutOfMemory);
  }
  rlimit own{};
  getrlimit(RLIMIT_AS, &own);
  EXPECT_EQ(own.rlim_cur, RLIM_INFINITY) << "this process's stays as it was";
}

TEST(ChildProcess, SleepersAreEndedByTheClock) {
  for (const ChildKind kind : {ChildKind::kReader, ChildKind::kWorker}) {
    const auto start = std::chrono::steady_clock::now();
    const ChildResult result = run_in_child(kSleep, {}, {kind, {kMuch, 1, 1 << 20}});
    EXPECT_EQ(result.end, End::kTooSlow);
    EXPECT_FALSE(result.is_part);
    EXPECT_LT(std::chrono::steady_clock::now() - start, 30s);
  }
  expect_no_child_left();
}

TEST(ChildProcess, PartsAreEndedByTheClockToo) {
  const ChildLimits parts{.seconds = 60, .part_seconds = 1};
  const ChildResult late = run_in_child(kNotes, bytes_of("600000"), {ChildKind::kWorker, parts});
  EXPECT_EQ(late.end, End::kTooSlow);
  EXPECT_TRUE(late.is_part);
  EXPECT_EQ(run_in_child(kNotes, bytes_of("1"), {ChildKind::kWorker, parts}).end, End::kFinished);
}

TEST(ChildProcess, SleepersThatHaveClosedTheirLineAreEndedToo) {
  const ChildResult result = read_by(kCloseAndSleep, {}, {kMuch, 1, 1 << 20});
  EXPECT_EQ(result.end, End::kTooSlow);
  expect_no_child_left();
}

TEST(ChildProcess, NotesComeInOrderWhileItWorks) {
  std::vector<std::string> notes;
  const auto take = [&](std::string_view note) { notes.emplace_back(note); };
  const ChildResult result = run_in_child(kNotes, bytes_of("0"), {ChildKind::kWorker, {}, {}, take});
  EXPECT_EQ(result.end, End::kFinished);
  EXPECT_EQ(result.output, Bytes{1});
  EXPECT_EQ(notes, (std::vector<std::string>{"one", "", "three"}));
}

TEST(ChildProcess, StopTokensEndTheWait) {
  std::stop_source stop;
  for (const ChildKind kind : {ChildKind::kReader, ChildKind::kWorker}) {
    stop = std::stop_source();
    const std::jthread later([&] {
      std::this_thread::sleep_for(100ms);
      stop.request_stop();
    });
    const auto start = std::chrono::steady_clock::now();
    EXPECT_THROW((void)run_in_child(kSleep, {}, {kind, kGenerous, stop.get_token()}), Stopped);
    EXPECT_LT(std::chrono::steady_clock::now() - start, 10s);
  }
  EXPECT_THROW((void)run_in_child(kEcho, {}, {.stop = stop.get_token()}), Stopped) << "asked before it began";
  expect_no_child_left();
}

TEST(ChildProcess, WorkersSeeThatTheyAreToStop) {
  const std::string path = testing::TempDir() + "coif-stop-test." + std::to_string(getpid());
  std::stop_source stop;
  const auto stop_it = [&](std::string_view) { stop.request_stop(); };
  EXPECT_THROW((void)run_in_child(kWaitForStop, bytes_of(path), {ChildKind::kWorker, {}, stop.get_token(), stop_it}),
               Stopped);
  std::string told;
  std::getline(std::ifstream(path), told);
  unlink(path.c_str());
  EXPECT_EQ(told, "in order");
}

TEST(ChildProcess, OutputAboveTheLimitIsRefused) {
  EXPECT_EQ(read_by(kFill, "1000", {kMuch, 60, 1000}).output.size(), 1000u);
  const ChildResult result = read_by(kFill, "1001", {kMuch, 60, 1000});
  EXPECT_EQ(result.end, End::kTooMuchOutput);
  EXPECT_TRUE(result.output.empty());
  expect_no_child_left();
}

TEST(ChildProcess, ReadersCannotWriteFilesAndWorkersCan) {
  const std::string path = testing::TempDir() + "coif-child-process-test." + std::to_string(getpid());
  for (const ChildKind kind : {ChildKind::kReader, ChildKind::kWorker}) {
    unlink(path.c_str());
    const ChildResult result = run_in_child(kWrite, bytes_of(path), {kind, kGenerous});
    ASSERT_EQ(result.end, End::kFinished);
    EXPECT_EQ(result.output, Bytes{kind == ChildKind::kWorker}) << path;
  }
  unlink(path.c_str());
}

TEST(ChildProcess, HoldsNoDescriptorOfTheParent) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  for (const ChildKind kind : {ChildKind::kReader, ChildKind::kWorker}) {
    const ChildResult result = run_in_child(kDescriptors, {}, {kind, kGenerous});
    EXPECT_EQ(result.output, (Bytes{0, 1, 2, 3}));  // the standard streams, and the line
  }
  close(ends[0]);
  close(ends[1]);
}

/// Both ends of the line, for a moment, beside what a program has at its start; one less is told as what it is.
TEST(ChildProcess, NeedsFewDescriptorsAndSaysWhenThereAreNone) {
  const auto with = [](std::uint8_t most) {
    return run_in_child(kFewDescriptors, Bytes{most}, {ChildKind::kWorker, kGenerous}).output;
  };
  EXPECT_EQ(with(6), (Bytes{std::uint8_t(End::kFinished), 0, 7}));
  EXPECT_EQ(with(5), (Bytes{std::uint8_t(End::kNotStarted), EMFILE, 0}));
}

TEST(ChildProcess, ChildrenOfAKilledParentGoWithIt) {
  std::string grandchild;
  std::stop_source stop;
  EXPECT_THROW((void)run_in_child(kParent, {},
                                  {ChildKind::kWorker,
                                   {},
                                   stop.get_token(),
                                   [&](std::string_view note) {
                                     grandchild = note;
                                     stop.request_stop();
                                   }}),
               Stopped);
  ASSERT_FALSE(grandchild.empty());
  EXPECT_TRUE(is_gone(grandchild)) << grandchild;
  expect_no_child_left();
}

TEST(ProcessPool, AnswersComeInOrderForAnyNumberOfJobs) {
  std::vector<Bytes> requests;
  for (int i = 0; i < 7; ++i) requests.push_back(bytes_of(std::to_string(i * 100'000)));
  for (const unsigned jobs : {0u, 1u, 3u, 64u}) {
    const auto answers = run_in_processes(kFill, requests, jobs);
    ASSERT_EQ(answers.size(), 7u);
    for (std::size_t i = 0; i < answers.size(); ++i) {
      ASSERT_TRUE(answers[i]) << i;
      EXPECT_EQ(answers[i]->size(), i * 100'000) << jobs;
    }
  }
}

TEST(ProcessPool, EachCallHasAProcessOfItsOwn) {
  std::set<std::string> processes{std::to_string(getpid())};
  for (const auto& answer : run_in_processes(kNumber, std::vector<Bytes>(4), 2))
    EXPECT_TRUE(answer && processes.insert(text_of(*answer)).second);
}

TEST(ProcessPool, OneThatDiesStopsNoOther) {
  const auto answers = run_in_processes(kSome, {{0}, {1}, {2}, {3}}, 2);
  EXPECT_EQ(answers[0], bytes_of("done"));
  EXPECT_FALSE(answers[1]);
  EXPECT_FALSE(answers[2]);
  EXPECT_EQ(answers[3], bytes_of("done"));
}

TEST(ProcessPool, LeavesNoChildBehind) {
  EXPECT_TRUE(run_in_processes(kEcho, {}, 2).empty());
  (void)run_in_processes(kEcho, std::vector<Bytes>(3), 2);
  expect_no_child_left();
}

}  // namespace coif::platform::child_process_test
