// An asset is used where the system mapped its file: a write into it would end this program.

#include "gl/gl_test.h"
#include "gl/made_up_wig.h"

#include <coif/hair.h>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <span>
#include <string>
#include <vector>

namespace coif {
namespace {

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

}  // namespace
}  // namespace coif
