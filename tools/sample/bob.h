#pragma once

#include <cstdint>
#include <vector>

namespace coif::sample {

/// The bytes of sample_assets/bob/bob.glb: the same on every run.
[[nodiscard]] std::vector<std::uint8_t> make_bob();

}  // namespace coif::sample
