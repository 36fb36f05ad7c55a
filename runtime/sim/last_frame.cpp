#include <coif/last_frame.h>

#include <algorithm>

namespace coif {

Status keep_palettes(const Hair& hair, std::span<Mat34> kept) {
  const std::uint32_t heads = hair.instance_count(), bones = hair.bone_count();
  if (heads == 0) return Status::kNotCreated;
  if (kept.size() != std::size_t{heads} * bones) return Status::kSizeMismatch;
  for (std::uint32_t head = 0; head < heads; ++head) {
    const std::span<const Mat34> palette = hair.palette(head);
    std::copy(palette.begin(), palette.end(), kept.begin() + std::ptrdiff_t(std::size_t{head} * bones));
  }
  return Status::kOk;
}

}  // namespace coif
