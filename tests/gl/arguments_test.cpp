#include "gl/gl_test.h"
#include "models/skinned_asset.h"

#include <coif/hair.h>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace coif::arguments_test {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// A host that does not find one function.
struct PartialHost {
  GlLoader real;
  std::string missing;

  static void* find(const char* name, void* user) {
    const auto& host = *static_cast<const PartialHost*>(user);
    return name == host.missing ? nullptr : host.real.get_proc(name, host.real.user);
  }
  GlLoader loader() { return {find, this}; }
};

TEST(HairRendererWithoutContext, CreateRefusesNullLoader) {
  HairRenderer renderer;
  EXPECT_EQ(renderer.create({}), Status::kBadArgument);
  EXPECT_FALSE(renderer.is_created());
}

TEST(HairRendererWithoutContext, CreateRefusesHostWithoutFunctionsAndNamesOne) {
  HairRenderer renderer;
  EXPECT_EQ(renderer.create({[](const char*, void*) -> void* { return nullptr; }, nullptr}), Status::kDriver);
  EXPECT_NE(std::strstr(renderer.failure(), "gl"), nullptr);
  EXPECT_FALSE(renderer.is_created());
}

TEST(HairRendererWithoutContext, DrawAndUploadNeedCreate) {
  HairRenderer renderer;
  HairModel model;
  const DrawnAsset asset(card_contents(std::array{DrawnCard{}}));
  EXPECT_EQ(model.upload(renderer, *asset), Status::kNotCreated);
  EXPECT_EQ(renderer.draw(model, {}, {}), Status::kNotCreated);
  model.destroy();
  renderer.destroy();
}

class Arguments : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (!context_) return;
    ASSERT_EQ(model_.upload(renderer_, *DrawnAsset(card_contents(std::array{DrawnCard{}}))), Status::kOk);
  }
  void TearDown() override {
    model_.destroy();
    GlTest::TearDown();
  }

  HairModel model_;
};

TEST_F(Arguments, EveryMissingFunctionIsNamed) {
  for (const char* name :
       {"glActiveTexture", "glDrawElementsInstanced", "glVertexAttribIPointer", "glUniformBlockBinding"}) {
    PartialHost host{context_->loader(), name};
    HairRenderer renderer;
    EXPECT_EQ(renderer.create(host.loader()), Status::kDriver);
    EXPECT_NE(std::strstr(renderer.failure(), name), nullptr) << renderer.failure();
    EXPECT_FALSE(renderer.is_created());
  }
}

TEST_F(Arguments, DrawRefusesBadValuesAndDrawsNothing) {
  MaterialRecord bad_material = plain_material();
  bad_material.primary_exponent = 0;
  const std::array<Mat34, 2> two_bones{};
  const std::vector<Light> crowd(kMaxLights + 1, Light{Light::Kind::kDirectional, {0, 0, 1}});
  const std::array dark{Light{}};  // no direction
  const std::array lost{Light{Light::Kind::kPoint, {0, kNan, 0}}};
  struct Bad {
    const char* what;
    Status expected;
    std::function<void(HeadDraw&)> spoil;
  };
  const std::vector<Bad> all = {
      {"palette too large", Status::kSizeMismatch, [&](HeadDraw& d) { d.palette = two_bones; }},
      {"palette empty", Status::kSizeMismatch, [](HeadDraw& d) { d.palette = {}; }},
      {"too many lights", Status::kBadArgument, [&](HeadDraw& d) { d.lights = crowd; }},
      {"light without direction", Status::kBadArgument, [&](HeadDraw& d) { d.lights = dark; }},
      {"light without place", Status::kBadArgument, [&](HeadDraw& d) { d.lights = lost; }},
      {"head nowhere", Status::kBadPose, [](HeadDraw& d) { d.head.position[2] = kNan; }},
      {"rotation not unit", Status::kBadPose, [](HeadDraw& d) { d.head.rotation.w = 1.1f; }},
      {"rotation NaN", Status::kBadPose, [](HeadDraw& d) { d.head.rotation.x = kNan; }},
      {"scale too small", Status::kBadScale, [](HeadDraw& d) { d.head.scale = 0.049f; }},
      {"scale too large", Status::kBadScale, [](HeadDraw& d) { d.head.scale = 20.1f; }},
      {"scale below nothing", Status::kBadScale, [](HeadDraw& d) { d.head.scale = -1; }},
      {"scale NaN", Status::kBadScale, [](HeadDraw& d) { d.head.scale = kNan; }},
      {"matrix", Status::kBadArgument, [](HeadDraw& d) { d.clip_from_world[7] = INFINITY; }},
      {"eye", Status::kBadArgument, [](HeadDraw& d) { d.eye.y = kNan; }},
      {"material", Status::kBadArgument, [&](HeadDraw& d) { d.material = &bad_material; }},
      {"level of detail", Status::kBadArgument, [](HeadDraw& d) { d.lod = 1; }},
      {"component", Status::kBadArgument, [](HeadDraw& d) { d.component = static_cast<Component>(7); }},
  };
  for (const Bad& bad : all) {
    HeadDraw desc = at_rest();
    bad.spoil(desc);
    EXPECT_EQ(draw_head(renderer_, model_, desc), bad.expected) << bad.what;
    EXPECT_EQ(middle_pixel(), (Pixel{0, 0, 0, 0})) << bad.what;
  }
}

TEST_F(Arguments, DrawRefusesModelOfAnotherRenderer) {
  HairRenderer other;
  ASSERT_EQ(other.create(context_->loader()), Status::kOk);
  EXPECT_EQ(draw_head(other, model_, at_rest()), Status::kNotCreated);
  other.destroy();
}

TEST_F(Arguments, UploadRefusesAssetWithoutMeshAndKeepsTheModel) {
  AssetContents skeleton_only = card_contents({});
  skeleton_only.textures.clear();
  skeleton_only.texels.clear();
  EXPECT_EQ(model_.upload(renderer_, *DrawnAsset(skeleton_only)), Status::kAssetLacksData);
  EXPECT_EQ(model_.upload(renderer_, Asset{}), Status::kAssetLacksData);
  EXPECT_EQ(draw_head(renderer_, model_, at_rest()), Status::kOk);
  EXPECT_TRUE(near(middle_pixel(), {255, 255, 255, 255}));
}

TEST_F(Arguments, UploadReplacesTheModel) {
  DrawnCard red;
  red.rgba = {255, 0, 0, 255};
  ASSERT_EQ(model_.upload(renderer_, *DrawnAsset(card_contents(std::array{red}, 3))), Status::kOk);
  EXPECT_EQ(model_.bone_count(), 3u);
  ASSERT_EQ(draw_head(renderer_, model_, at_rest(3)), Status::kOk);
  EXPECT_TRUE(near(middle_pixel(), {255, 0, 0, 255}));
}

TEST_F(Arguments, DestroyTwiceIsHarmless) {
  model_.destroy();
  model_.destroy();
  EXPECT_FALSE(model_.is_uploaded());
  EXPECT_EQ(draw_head(renderer_, model_, at_rest()), Status::kNotCreated);
  renderer_.destroy();
  renderer_.destroy();
  EXPECT_FALSE(renderer_.is_created());
}

// An asset is used where the system mapped its file: a write into it would end this program.

/// A file that is gone when the test ends, mapped read-only.
class MappedFile {
 public:
  explicit MappedFile(std::span<const std::byte> content) : size_(content.size()) {
    std::string path = testing::TempDir() + "coif_mapped_XXXXXX";
    const int file = mkstemp(path.data());
    std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(content.data()), std::streamsize(size_));
    bytes_ = mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, file, 0);
    close(file);
    unlink(path.c_str());
  }
  ~MappedFile() {
    if (is_mapped()) munmap(bytes_, size_);
  }
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  [[nodiscard]] bool is_mapped() const { return bytes_ != MAP_FAILED; }
  [[nodiscard]] std::span<const std::byte> bytes() const { return {static_cast<const std::byte*>(bytes_), size_}; }

 private:
  std::size_t size_;
  void* bytes_ = MAP_FAILED;
};

/// A crowd of one, in memory of its own.
class OneHead {
 public:
  explicit OneHead(const Asset& asset) : memory_(Hair::memory_need(asset, {}).bytes / sizeof(Line) + 1) {
    const auto bytes = std::as_writable_bytes(std::span(memory_)).first(Hair::memory_need(asset, {}).bytes);
    EXPECT_EQ(hair.create(asset, {}, bytes), Status::kOk);
  }
  void nod() {
    for (int frame = 1; frame <= 30; ++frame) {
      const float half = 0.1f * std::sin(0.4f * float(frame));
      ASSERT_EQ(hair.set_head(0, {{0, 0, 0}, {half, 0, 0, std::sqrt(1 - half * half)}}), Status::kOk);
      ASSERT_EQ(hair.step({}), Status::kOk);
    }
  }

  Hair hair;

 private:
  struct alignas(64) Line {
    std::byte bytes[64];
  };
  std::vector<Line> memory_;
};

using MappedAsset = GlTest;

TEST_F(MappedAsset, OpensStepsAndDrawsWithoutAWriteIntoIt) {
  const std::vector<std::byte> file = made_up_wig({.strips = 24, .texture_size = 64});
  const MappedFile mapped(file);
  ASSERT_TRUE(mapped.is_mapped());
  Asset asset;
  ASSERT_TRUE(asset.open(mapped.bytes()));
  OneHead head(asset);
  head.nod();

  HairModel model;
  ASSERT_EQ(model.upload(renderer_, asset), Status::kOk);
  HeadDraw desc = at_rest();
  desc.palette = head.hair.palette(0);
  desc.clip_from_world[0] = desc.clip_from_world[5] = 4;  // a head fills the view
  ASSERT_EQ(draw_head(renderer_, model, desc), Status::kOk);
  int covered = 0;
  for (int i = 0; i < kSize * kSize; ++i) covered += pixel(i % kSize, i / kSize)[3] > 0 ? 1 : 0;
  EXPECT_GT(covered, kSize * kSize / 20);
  EXPECT_TRUE(std::ranges::equal(mapped.bytes(), file));
  model.destroy();
}

}  // namespace coif::arguments_test
