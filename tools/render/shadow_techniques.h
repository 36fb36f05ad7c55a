#pragma once

#include <coif/shadow.h>

#include <span>

namespace coif {

/// Every way to draw shadows, for tools that offer or compare them; name_of() tells what each is called.
[[nodiscard]] std::span<const ShadowTechnique* const> shadow_techniques();

}  // namespace coif
