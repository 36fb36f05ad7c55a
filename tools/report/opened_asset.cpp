#include "report/opened_asset.h"

#include <cstdlib>
#include <cstring>

namespace coif {
namespace {

constexpr std::size_t kAlignment = 64;  ///< What Asset::open() may ask for.

}  // namespace

OpenedAsset::OpenedAsset(const AssetContents& contents) {
  const std::vector<std::byte> bytes = write_asset(contents);
  const std::size_t size = (bytes.size() + kAlignment - 1) / kAlignment * kAlignment;
  bytes_.reset(static_cast<std::byte*>(std::aligned_alloc(kAlignment, size)));
  std::memcpy(bytes_.get(), bytes.data(), bytes.size());
  (void)asset_.open({bytes_.get(), bytes.size()}, {.verify_hash = false});
}

void OpenedAsset::FreeMemory::operator()(std::byte* bytes) const { std::free(bytes); }

}  // namespace coif
