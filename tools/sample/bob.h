#pragma once

#include "sample/bob_style.h"

#include <cstdint>
#include <vector>

namespace coif::sample {

/// The bytes of sample_assets/bob/bob.glb, with the density's defaults: the same on every run.
[[nodiscard]] std::vector<std::uint8_t> make_bob(const BobDensity& density = {});

}  // namespace coif::sample
