#pragma once

#include <cstdint>
#include <vector>

namespace coif::sample {

/// The bytes of sample_assets/long/long.glb: the same on every run.
[[nodiscard]] std::vector<std::uint8_t> make_long();

}  // namespace coif::sample
