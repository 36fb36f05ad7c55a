#include "pipeline/depfile.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <vector>

namespace coif {
namespace {

namespace fs = std::filesystem;

class Depfile : public testing::Test {
 protected:
  Depfile() { fs::create_directories(folder_); }
  ~Depfile() override { fs::remove_all(folder_); }

  fs::path file(const std::string& name) const {
    std::ofstream(folder_ / name) << "x";
    return folder_ / name;
  }
  std::string prefix() const { return folder_.string() + "/"; }

 private:
  fs::path folder_ = fs::temp_directory_path() / ("coif_depfile_" + std::to_string(::getpid()));
};

std::string text_of(const fs::path& target, const std::vector<fs::path>& inputs) {
  const auto text = depfile_text(target, inputs);
  EXPECT_TRUE(text) << (text ? "" : text.error().message);
  return text.value_or("");
}

TEST_F(Depfile, NamesTheTargetAndEveryInputOnce) {
  const fs::path a = file("a.obj"), b = file("b.mtl");
  EXPECT_EQ(text_of("out.coif", {a, b, a}), "out.coif: \\\n  " + prefix() + "a.obj \\\n  " + prefix() + "b.mtl\n");
}

TEST_F(Depfile, LeavesOutWhatIsAbsent) { EXPECT_EQ(text_of("out.coif", {prefix() + "never.mtl"}), "out.coif:\n"); }

TEST_F(Depfile, EscapesWhatMakeWouldTakeForItsOwn) {
  EXPECT_EQ(text_of("my hair.coif", {}), "my\\ hair.coif:\n");
  EXPECT_EQ(text_of("no#1.coif", {}), "no\\#1.coif:\n");
  EXPECT_EQ(text_of("5$.coif", {}), "5$$.coif:\n");
  EXPECT_EQ(text_of("in", {file("a b#$.png")}), "in: \\\n  " + prefix() + "a\\ b\\#$$.png\n");
}

TEST_F(Depfile, KeepsBackslashesAndDoublesThemBeforeABlank) {
  EXPECT_EQ(text_of("a\\b.coif", {}), "a\\b.coif:\n");
  EXPECT_EQ(text_of("a\\ b.coif", {}), "a\\\\\\ b.coif:\n");
}

TEST_F(Depfile, RefusesLineBreaks) {
  const auto in_target = depfile_text("a\nb.coif", {});
  ASSERT_FALSE(in_target);
  EXPECT_EQ(in_target.error().kind, ToolError::Kind::kUsage);
  EXPECT_FALSE(depfile_text("a.coif", std::vector{file("b\nc.png")}));
}

}  // namespace
}  // namespace coif
