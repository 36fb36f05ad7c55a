#include "report/page/child_program.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>

namespace coif::child_program_test {

using End = ProgramResult::End;
using std::chrono::milliseconds;

ProgramResult run_shell(const std::string& script, const ProgramLimits& limits = {}) {
  return run_program({"sh", "-c", script}, "", limits);
}

TEST(ChildProgram, GivesInputAndReturnsBothOutputsAndTheStatus) {
  std::string input(1 << 20, 'x');  // more than pipes hold
  input += "\nend";
  const ProgramResult copied = run_program({"cat"}, input);
  EXPECT_EQ(copied.end, End::kFinished);
  EXPECT_EQ(copied.code, 0);
  EXPECT_EQ(copied.output, input);
  const ProgramResult failed = run_shell("echo out; echo err >&2; exit 7");
  EXPECT_EQ(failed.end, End::kFinished);
  EXPECT_EQ(failed.code, 7);
  EXPECT_EQ(failed.output, "out\n");
  EXPECT_EQ(failed.messages, "err\n");
}

TEST(ChildProgram, LargeMessagesDoNotStopTheOutput) {
  const ProgramResult result = run_shell("head -c 300000 /dev/zero >&2; head -c 300000 /dev/zero");
  EXPECT_EQ(result.end, End::kFinished);
  EXPECT_EQ(result.output.size(), 300000u);
  EXPECT_EQ(result.messages.size(), 300000u);
}

TEST(ChildProgram, ArgumentsAreWordsAndNotShellText) {
  const ProgramResult result = run_program({"printf", "%s|", "a b", "$(ls)", "`ls`; ls", "'"}, "");
  EXPECT_EQ(result.output, "a b|$(ls)|`ls`; ls|'|");
}

TEST(ChildProgram, SaysThatAProgramIsMissing) {
  const ProgramResult result = run_program({"no-such-program-here"}, "");
  EXPECT_EQ(result.end, End::kNotStarted);
  EXPECT_EQ(result.code, ENOENT);
}

TEST(ChildProgram, KillsWhatHangsWithAllItStarted) {
  // The second one sleeps with closed outputs: the end of the streams is not the end of the program.
  for (const char* script : {"sleep 600 & sleep 600", "exec >&- 2>&-; sleep 600"}) {
    EXPECT_EQ(run_shell(script, {milliseconds(200)}).end, End::kTooSlow) << script;
  }
}

TEST(ChildProgram, StopsAnEndlessOutput) {
  ProgramLimits limits;
  limits.output_bytes = 1 << 20;
  EXPECT_EQ(run_program({"yes"}, "", limits).end, End::kTooMuchOutput);
}

TEST(ChildProgram, ReportsTheSignalThatEndedIt) {
  const ProgramResult result = run_shell("kill -SEGV $$");
  EXPECT_EQ(result.end, End::kKilled);
  EXPECT_EQ(result.code, SIGSEGV);
}

TEST(ChildProgram, CanWriteNoFile) {
  const auto file = std::filesystem::temp_directory_path() / "coif_child_program_test_output";
  std::filesystem::remove(file);
  const ProgramResult result = run_program({"sh", "-c", "echo text > \"$0\"", file.string()}, "");
  EXPECT_FALSE(result.end == End::kFinished && result.code == 0);
  EXPECT_TRUE(!std::filesystem::exists(file) || std::filesystem::file_size(file) == 0);
  std::filesystem::remove(file);
}

TEST(ChildProgram, SeesNoVariableOfThisProcessButThePath) {
  setenv("COIF_CHILD_PROGRAM_TEST", "secret", 1);
  const ProgramResult result = run_program({"env"}, "");
  EXPECT_EQ(result.output.find("secret"), std::string::npos);
  EXPECT_NE(result.output.find("PATH="), std::string::npos);
}

}  // namespace coif::child_program_test
