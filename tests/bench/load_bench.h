#pragma once

#include <string>

namespace coif {

/// Adds what happens once for each asset: Asset::open() of the cooked samples in `folder`, with and without the
/// hashes, Asset::verify_draw_data(), and Hair::create(). Samples that are not there are left out.
void add_load_benchmarks(const std::string& folder);

}  // namespace coif
