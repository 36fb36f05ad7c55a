#include "cache/cook_cache.h"
#include "cook/image_files.h"
#include "platform/files.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <functional>
#include <set>
#include <vector>

namespace coif::cache::cook_cache_test {

namespace fs = std::filesystem;

constexpr cook::Rgba kRed{200, 30, 20, 255};
constexpr cook::Rgba kGreen{30, 180, 40, 255};
const std::string kKey = content_digits({});

/// A folder with a source beside which images come and go, and a cache.
class CookCacheTest : public testing::Test {
 protected:
  CookCacheTest() {
    write(folder_.source(), "model");
    result_.asset = {std::byte{1}, std::byte{2}};
    result_.report.triangles = 5;
  }

  static void write(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }

  fs::path cache_folder() const { return folder_.path().parent_path() / "cache"; }
  CookPlace place() const { return {folder_.source(), folder_.path()}; }
  CookCache cache() const { return CookCache(cache_folder()); }
  /// As if the inputs were there long before.
  void store() const {
    const auto stored = cache().store(kKey, place(), result_, platform::file_clock_now() + std::chrono::hours(1));
    EXPECT_TRUE(stored) << (stored ? "" : stored.error().message);
  }
  bool hits() const { return cache().find(kKey, place()).has_value(); }
  void ask(cook::TextureQuestion::Kind kind, std::vector<std::string> words) {
    cook::TextureQuestion question{kind, std::move(words), {}};
    question.answer = cook::answer_to(question, cook::TextureFolder(folder_.source()));
    result_.inputs.questions.push_back(question);
  }
  std::vector<fs::path> files() const {
    std::vector<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator(cache_folder())) {
      if (entry.is_regular_file()) found.push_back(entry.path());
    }
    return found;
  }

  cook::ImageFolder folder_;
  cook::CookResult result_;
};

TEST_F(CookCacheTest, FindsWhatWasStoredUnderItsKeyAlone) {
  EXPECT_FALSE(hits());
  store();
  const auto found = cache().find(kKey, place());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->asset, result_.asset);
  EXPECT_EQ(found->report.triangles, 5u);
  EXPECT_FALSE(cache().find(content_digits(result_.asset), place()));
}

TEST_F(CookCacheTest, AFileThatChangesMissesUntilItIsBack) {
  result_.inputs.source_files = {folder_.write_flat("hair.png", kRed)};
  store();
  EXPECT_TRUE(hits());
  folder_.write_flat("hair.png", kGreen);
  EXPECT_FALSE(hits());
  fs::remove(folder_.path() / "hair.png");
  EXPECT_FALSE(hits());
  folder_.write_flat("hair.png", kRed);
  EXPECT_TRUE(hits());
}

TEST_F(CookCacheTest, AFileThatAppearsWhereNoneWasMisses) {
  result_.inputs.source_files = {folder_.path() / "wig.mtl"};
  store();
  EXPECT_TRUE(hits());
  write(folder_.path() / "wig.mtl", "newmtl hair\n");
  EXPECT_FALSE(hits());
}

TEST_F(CookCacheTest, ARecipesFilesAreThoseOfTheRecipeInUse) {
  const cook::ImageFolder other;
  result_.inputs.recipe_files = {folder_.write_flat("mask.png", kRed)};
  other.write_flat("mask.png", kGreen);
  store();
  EXPECT_FALSE(cache().find(kKey, {folder_.source(), other.path()}));
  other.write_flat("mask.png", kRed);
  EXPECT_TRUE(cache().find(kKey, {folder_.source(), other.path()}));
}

TEST_F(CookCacheTest, ATextureThatAppearsMissesWhereItWouldBeTaken) {
  ask(cook::TextureQuestion::Kind::kFind, {"C:\\art\\hair.png"});
  ask(cook::TextureQuestion::Kind::kColors, {"wig"});
  store();
  folder_.write_flat("sofa.png", kRed);
  EXPECT_TRUE(hits()) << "nobody asked for a sofa";
  folder_.write_flat("textures/HAIR.tga", kRed);
  EXPECT_FALSE(hits());
}

TEST_F(CookCacheTest, AnyImageMissesWhereAllWereListed) {
  ask(cook::TextureQuestion::Kind::kImages, {});
  store();
  EXPECT_TRUE(hits());
  folder_.write_flat("sofa.png", kRed);
  EXPECT_FALSE(hits());
}

TEST_F(CookCacheTest, KeepsOneEntryForEachStateOfTheInputs) {
  const fs::path image = folder_.write_flat("hair.png", kRed);
  result_.inputs.source_files = {image};
  store();
  store();
  EXPECT_EQ(files().size(), 1u);
  folder_.write_flat("hair.png", kGreen);
  result_.report.triangles = 6;
  store();
  EXPECT_EQ(cache().find(kKey, place())->report.triangles, 6u);
  folder_.write_flat("hair.png", kRed);
  EXPECT_EQ(cache().find(kKey, place())->report.triangles, 5u);
}

TEST_F(CookCacheTest, DoesNotGrowWithoutEnd) {
  const fs::path image = folder_.path() / "hair.png";
  result_.inputs.source_files = {image};
  for (int i = 0; i < 40; ++i) {
    write(image, std::to_string(i));
    store();
  }
  EXPECT_LE(files().size(), 16u);
  EXPECT_TRUE(hits()) << "the newest stays";
}

TEST_F(CookCacheTest, ADamagedEntryIsAMissAndIsReplaced) {
  store();
  for (const char* damage : {"", "coifent1", "rubbish of some length that is no entry"}) {
    write(files().at(0), damage);
    EXPECT_FALSE(hits()) << damage;
  }
  store();
  EXPECT_EQ(files().size(), 1u);
  EXPECT_TRUE(hits());
}

TEST_F(CookCacheTest, APipeInPlaceOfAnEntryIsAMissAndIsReplaced) {
  store();
  const fs::path entry = files().at(0);
  fs::remove(entry);
  ASSERT_EQ(mkfifo(entry.c_str(), 0600), 0);
  EXPECT_FALSE(hits()) << "and nobody waits for a writer";
  store();
  EXPECT_TRUE(hits());
}

TEST_F(CookCacheTest, DoesNotKeepWhatChangedDuringTheCook) {
  const auto stored = cache().store(kKey, place(), result_, std::chrono::nanoseconds(0));
  ASSERT_FALSE(stored);
  EXPECT_NE(stored.error().message.find("changed while it was cooked"), std::string::npos);
  EXPECT_FALSE(hits());
}

TEST_F(CookCacheTest, ACacheThatCannotBeWrittenIsAnErrorThatNamesIt) {
  write(cache_folder(), "a file where the folder would be");
  const auto stored = cache().store(kKey, place(), result_, platform::file_clock_now() + std::chrono::hours(1));
  ASSERT_FALSE(stored);
  EXPECT_EQ(stored.error().kind, ToolError::Kind::kFileAccess);
  EXPECT_NE(stored.error().message.find(cache_folder().string()), std::string::npos);
}

TEST_F(CookCacheTest, MessagesNameTheFilesOfTheCheckoutInUse) {
  const cook::ImageFolder other;
  result_.report.warnings = {{"C147", folder_.path().string() + "/hair.png: cannot read"}};
  store();
  const auto found = cache().find(kKey, {other.source(), other.path()});
  ASSERT_TRUE(found);
  ASSERT_EQ(found->report.warnings.size(), 1u);
  EXPECT_EQ(found->report.warnings[0].message, other.path().string() + "/hair.png: cannot read");
  EXPECT_EQ(found->report.warnings[0].code, "C147");
}

std::vector<std::byte> bytes_of(const std::string& text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

TEST(CookKey, ChangesWithEachPartOfTheIdentity) {
  const std::vector<std::byte> bytes = bytes_of("model"), others = bytes_of("Model");
  const CookIdentity identity{"coif 1", "assimp 5", {"/a/wig.obj", {}}, bytes, "{}"};
  const std::function<void(CookIdentity&)> changes[] = {
      [](CookIdentity&) {},
      [](CookIdentity& i) { i.tool = "coif 2"; },
      [](CookIdentity& i) { i.importer = "assimp 6"; },
      [](CookIdentity& i) { i.place.source = "/a/wig.dae"; },
      [](CookIdentity& i) { i.place.roots = {"/store"}; },
      [](CookIdentity& i) {
        i.place.roots = {"/store", "/annex"};
      },
      [&](CookIdentity& i) { i.source_bytes = others; },
      [&](CookIdentity& i) { i.source_bytes = std::span(bytes).first(4); },
      [](CookIdentity& i) { i.recipe = "{ }"; },
      [](CookIdentity& i) { i.draft = true; },
  };
  std::set<std::string> keys;
  for (const auto& change : changes) {
    CookIdentity changed = identity;
    change(changed);
    EXPECT_TRUE(keys.insert(cook_key(changed)).second);
  }
}

TEST(CookKey, DoesNotTellFoldersApart) {
  EXPECT_EQ(cook_key({"coif", "assimp", {"/here/wig.obj", {}, {"/here/store"}}, {}, "{}"}),
            cook_key({"coif", "assimp", {"/there/wig.obj", {}, {"/there/store"}}, {}, "{}"}));
}

TEST(CookKey, KnowsWhereOnePartEndsAndTheNextBegins) {
  EXPECT_NE(cook_key({"ab", "c", {"wig.obj", {}}, {}, ""}), cook_key({"a", "bc", {"wig.obj", {}}, {}, ""}));
}

TEST(CookKey, IsAFileNameOf32Digits) {
  const std::string key = cook_key({"coif", "assimp", {"wig.obj", {}}, {}, "{}"});
  EXPECT_EQ(key.size(), 32u);
  EXPECT_EQ(key.find_first_not_of("0123456789abcdef"), std::string::npos);
}

}  // namespace coif::cache::cook_cache_test
