#include "cards/compare_hair.h"

#include <algorithm>
#include <cmath>

namespace coif::cards {

HairLikeness compare_hair(const HairPicture& wanted, const HairPicture& seen) {
  double both = 0, either = 0, squares = 0;
  std::size_t covered = 0;
  for (std::size_t i = 0; i < wanted.coverage.size(); ++i) {
    both += double(std::min(wanted.coverage[i], seen.coverage[i]));
    either += double(std::max(wanted.coverage[i], seen.coverage[i]));
    if (!(wanted.coverage[i] > 0 || seen.coverage[i] > 0)) continue;
    const double difference = double(wanted.shade[i]) - double(seen.shade[i]);
    squares += difference * difference;
    ++covered;
  }
  if (covered == 0) return {};
  return {both / either, std::sqrt(squares / double(covered))};
}

double psnr_db(double error) { return error > 1e-5 ? -20 * std::log10(error) : 100; }

}  // namespace coif::cards
