#pragma once

#include <coif/asset.h>

#include <cstddef>
#include <span>

namespace coif {

/// Writes the asset's indices once for each of its draw orders, in 16 bits where `out` has that many bytes for each, else
/// in 32.
void write_draw_orders(const Asset& asset, std::span<std::byte> out);

}  // namespace coif
