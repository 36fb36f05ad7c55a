#include "cache/manifest.h"

#include <gtest/gtest.h>

#include <unistd.h>
#include <fstream>
#include <set>
#include <vector>

namespace coif::cache::manifest_test {

namespace fs = std::filesystem;

class Manifest : public testing::Test {
 protected:
  Manifest() { fs::create_directories(folder_); }
  ~Manifest() override { fs::remove_all(folder_); }

  tl::expected<std::vector<CookRequest>, ToolError> read(const std::string& text) const {
    std::ofstream(folder_ / "m.json") << text;
    return read_manifest(folder_ / "m.json", "out");
  }

  /// What is wrong with a manifest, which must be the input's fault and named so.
  std::string fault(const std::string& text) const {
    const auto requests = read(text);
    if (requests) return "nothing";
    EXPECT_EQ(requests.error().kind, ToolError::Kind::kBadInput);
    EXPECT_TRUE(requests.error().message.starts_with((folder_ / "m.json").string() + ": "));
    return requests.error().message;
  }

  std::string in(const std::string& path) const { return (folder_ / path).string(); }

 private:
  fs::path folder_ = fs::temp_directory_path() / ("coif_manifest_" + std::to_string(::getpid()));
};

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_F(Manifest, SourcesStartAtItsFolderAndOutputsAtTheirs) {
  const auto requests =
      read(R"({"assets": ["heads/bob.fbx", {"source": "a.glb", "recipe": "r.json", "output": "x/y.coif"}]})");
  ASSERT_TRUE(requests) << requests.error().message;
  ASSERT_EQ(requests->size(), 2u);
  EXPECT_EQ((*requests)[0].source, in("heads/bob.fbx"));
  EXPECT_EQ((*requests)[0].output, "out/heads/bob.coif");
  EXPECT_FALSE((*requests)[0].recipe);
  EXPECT_EQ((*requests)[1].source, in("a.glb"));
  EXPECT_EQ((*requests)[1].recipe, in("r.json"));
  EXPECT_EQ((*requests)[1].output, "out/x/y.coif");
}

TEST_F(Manifest, MayListNothing) {
  const auto requests = read(R"({"assets": []})");
  ASSERT_TRUE(requests);
  EXPECT_TRUE(requests->empty());
}

TEST_F(Manifest, KeepsOutputsInTheirFolder) {
  EXPECT_TRUE(contains(fault(R"({"assets": ["a.glb", "../b.glb"]})"), "assets[1]: ../b.glb lies outside"));
  EXPECT_TRUE(contains(fault(R"({"assets": ["/srv/b.glb"]})"), "give it an \"output\""));
  EXPECT_TRUE(
      contains(fault(R"({"assets": [{"source": "b.glb", "output": "/tmp/b.coif"}]})"), "leaves the output folder"));
  EXPECT_TRUE(
      contains(fault(R"({"assets": [{"source": "b.glb", "output": "x/../../b"}]})"), "leaves the output folder"));
  for (const char* folder : {".", "./", "x/", "x/."}) {
    const std::string text = R"({"assets": [{"source": "b.glb", "output": ")" + std::string(folder) + "\"}]}";
    EXPECT_TRUE(contains(fault(text), "is a folder; name a file")) << folder;
  }
  const auto elsewhere = read(R"({"assets": [{"source": "/srv/b.glb", "output": "b.coif"}]})");
  ASSERT_TRUE(elsewhere);
  EXPECT_EQ(elsewhere->front().source, "/srv/b.glb");
}

TEST_F(Manifest, RefusesTwoAssetsInOneFile) {
  EXPECT_TRUE(contains(fault(R"({"assets": ["a.glb", "b.glb", "a.fbx"]})"),
                       "assets[0] and assets[2] would both become out/a.coif"));
  EXPECT_TRUE(contains(fault(R"({"assets": ["a.glb", {"source": "b.glb", "output": "./a.coif"}]})"), "both become"));
}

TEST_F(Manifest, TellsWhatIsNotOfItsForm) {
  EXPECT_TRUE(contains(fault("{\"assets\": ["), "not JSON: "));
  EXPECT_TRUE(contains(fault("[]"), "looks like {\"assets\": "));
  EXPECT_TRUE(contains(fault(R"({"asset": []})"), "looks like {\"assets\": "));
  EXPECT_TRUE(contains(fault(R"({"assets": {}})"), "looks like {\"assets\": "));
  EXPECT_TRUE(contains(fault(R"({"assets": [], "jobs": 4})"), "looks like {\"assets\": "));
  EXPECT_TRUE(contains(fault(R"({"assets": [3]})"), "assets[0]: no \"source\""));
  EXPECT_TRUE(contains(fault(R"({"assets": [""]})"), "assets[0]: no \"source\""));
  EXPECT_TRUE(contains(fault(R"({"assets": [{"output": "a.coif"}]})"), "assets[0]: no \"source\""));
  EXPECT_TRUE(contains(fault(R"({"assets": [{"source": "a.glb", "recepi": "r"}]})"), "\"recepi\" is none of"));
  EXPECT_TRUE(contains(fault(R"({"assets": [{"source": "a.glb", "output": 3}]})"), "\"output\" must be a path, not 3"));
}

TEST_F(Manifest, KeepsMessagesShortAndItsStackSmall) {
  const std::string deep = std::string(1'000'000, '[') + std::string(1'000'000, ']');
  EXPECT_TRUE(contains(fault(R"({"assets": [{"source": )" + deep + "}]}"), "levels deep"));
  const std::string wide = "[" + std::string(9999, '1') + "]";
  EXPECT_LT(fault(R"({"assets": [{"source": )" + wide + "}]}").size(), 400u);
  EXPECT_LT(fault(R"({"assets": [{"source": "a", ")" + std::string(9999, 'k') + "\": 1}]}").size(), 400u);
}

TEST_F(Manifest, ThatIsAbsentIsAMatterOfFiles) {
  const auto requests = read_manifest(in("never.json"), "out");
  ASSERT_FALSE(requests);
  EXPECT_EQ(requests.error().kind, ToolError::Kind::kFileAccess);
}

TEST(Shares, HoldEveryRequestOnceAndDifferByOneAtMost) {
  std::vector<CookRequest> all(23);
  for (std::size_t i = 0; i < all.size(); ++i) all[i].source = std::to_string(i);
  for (const std::size_t count : {1u, 2u, 7u, 23u, 40u}) {
    std::set<std::string> seen;
    std::size_t total = 0;
    for (std::size_t k = 1; k <= count; ++k) {
      const auto mine = share_of(all, {k, count});
      EXPECT_LE(mine.size(), all.size() / count + 1);
      EXPECT_GE(mine.size(), all.size() / count);
      total += mine.size();
      for (const CookRequest& request : mine) seen.insert(request.source);
    }
    EXPECT_EQ(total, all.size());
    EXPECT_EQ(seen.size(), all.size());
  }
}

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

}  // namespace coif::cache::manifest_test
