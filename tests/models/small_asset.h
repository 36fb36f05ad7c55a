#pragma once

#include "write/asset_writer.h"

#include <coif/asset.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

namespace coif {

/// A heap block of exactly the size asked for, aligned to 64 bytes: AddressSanitizer sees one byte too far.
class AlignedBytes {
 public:
  explicit AlignedBytes(std::span<const std::byte> bytes) : size_(bytes.size()) {
    void* memory = nullptr;
    if (posix_memalign(&memory, 64, size_ == 0 ? 1 : size_) == 0) data_ = static_cast<std::byte*>(memory);
    if (data_ != nullptr && size_ > 0) std::memcpy(data_, bytes.data(), size_);
  }
  ~AlignedBytes() { std::free(data_); }
  AlignedBytes(const AlignedBytes&) = delete;
  AlignedBytes& operator=(const AlignedBytes&) = delete;

  [[nodiscard]] std::span<std::byte> bytes() { return {data_, size_}; }

 private:
  std::byte* data_ = nullptr;
  std::size_t size_;
};

/// An asset of about 3 KiB that uses every chunk: a head, one scalp bone, a chain of two bones and one of one bone
/// that branches off the head, four shapes of collider, three more on two bones of the body, two limits, patches of one
/// triangle each, all textures, a tuning.
[[nodiscard]] AssetContents small_asset();

/// A head and `count` - 1 scalp bones on it, all where the head is.
[[nodiscard]] std::vector<BoneRecord> rigid_bones(std::uint32_t count);

inline LoadStatus open_written(const AssetContents& contents) {
  AlignedBytes file(write_asset(contents));
  Asset asset;
  const LoadStatus status = asset.open(file.bytes());
  EXPECT_EQ(asset.is_open(), bool(status)) << "a refused asset must leave the view empty";
  return status;
}

/// What open() says of small_asset() after a change; kOk where the change is allowed.
template <typename Change>
LoadCode refusal(Change change) {
  AssetContents contents = small_asset();
  change(contents);
  return open_written(contents).code;
}

/// Reads whatever a runtime may read of an open asset, through every reference in it; a value outside its promise shows
/// as a sum that is not finite, or under AddressSanitizer.
[[nodiscard]] double touch_asset(const Asset& asset);

/// The same without all that is drawn, or depends on it: bones, dynamics and colliders stay.
[[nodiscard]] inline AssetContents without_mesh(AssetContents contents) {
  contents.vertices.clear();
  contents.skin.clear();
  contents.indices.clear();
  contents.patches.clear();
  contents.orders.clear();
  contents.order_views.clear();
  contents.lods.clear();
  contents.lod_bones.clear();
  return contents;
}

}  // namespace coif
