#include <coif/lod.h>

#include <cmath>

namespace coif {
namespace {

/// The last level fits everything, so a NaN gives the last one.
std::uint32_t level_for(std::span<const LodRecord> lods, float share) {
  const auto last = static_cast<std::uint32_t>(lods.size()) - 1;
  std::uint32_t level = 0;
  while (level < last && !(share >= lods[level].screen_size)) ++level;
  return level;
}

float clamped(float hysteresis) {
  constexpr float kMost = 0.9f;  // With 1 a coarser level would never be reached.
  if (!(hysteresis > 0.0f)) return 0.0f;
  return hysteresis < kMost ? hysteresis : kMost;
}

}  // namespace

float screen_share(float height, float distance, float fov) {
  return height * std::cos(0.5f * fov) / (2.0f * distance * std::sin(0.5f * fov));
}

std::uint32_t choose_lod(std::span<const LodRecord> lods, float share, std::uint32_t current, float hysteresis) {
  if (lods.empty()) return 0;
  const float slack = clamped(hysteresis);
  const std::uint32_t finest = level_for(lods, share / (1.0f - slack));
  const std::uint32_t coarsest = level_for(lods, share / (1.0f + slack));
  if (current < finest) return finest;
  return current > coarsest ? coarsest : current;
}

}  // namespace coif
