#pragma once

namespace coif {

/// Adds what happens once for each asset: Asset::open() of the cooked samples in `folder`, with and without the
/// payload's hash, and Hair::create(). `folder` null or without cooked samples: only what needs no file.
void add_load_benchmarks(const char* folder);

}  // namespace coif
