#include "cook/order/threshold_alpha.h"

#include "base/parallel_for.h"
#include "cook/texture/alpha.h"

#include <utility>
#include <vector>

namespace coif::cook {

void ThresholdAlpha::prepare(std::span<const float> thresholds) {
  std::vector<std::pair<const float, visibility::AlphaTexture>*> missing;
  for (const float threshold : thresholds) {
    const auto [place, is_new] = made_.try_emplace(threshold, plain_);
    if (is_new) missing.push_back(&*place);
  }
  parallel_for(missing.size(), threads_, [&](std::size_t i) {
    auto& [threshold, alpha] = *missing[i];
    const std::vector<Image> mips = mips_for_threshold(used_, contents_, threshold);
    for (std::size_t level = 0; level < mips.size(); ++level) alpha.set_texels(level, mips[level].texels);
  });
}

const visibility::AlphaTexture& ThresholdAlpha::at(float threshold) {
  prepare({&threshold, 1});
  return made_.at(threshold);
}

}  // namespace coif::cook
