#pragma once

#include <coif/transparency.h>

#include <cstdint>
#include <span>

namespace coif {

/// Every way to draw transparent hair, for tools that offer or compare them; name_of() tells what each is called.
[[nodiscard]] std::span<const TransparencyMode* const> transparency_modes();

/// Samples per pixel of a target that the mode draws to at its best; 0: a target without multisampling.
[[nodiscard]] std::uint32_t samples_for(const TransparencyMode& mode);

}  // namespace coif
