#pragma once

#include <coif/transparency.h>

#include <span>

namespace coif {

/// Every way to draw transparent hair, for tools that offer or compare them; name_of() tells what each is called.
[[nodiscard]] std::span<const TransparencyMode* const> transparency_modes();

}  // namespace coif
