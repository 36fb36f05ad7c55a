#pragma once

namespace coif {

/// A way to draw hair that lets light through. A program holds those that it names, and builds the shaders of those that
/// it draws with. Their image errors and costs: `coif report FILE order` and `cost`.
struct TransparencyMode;

/// The four passes of the thesis (5.3.1): solid texels; back faces of the rest, blended; its front faces; depth.
/// Within a pass the cooked order is all the sorting there is.
extern const TransparencyMode kBlendMode;

/// One pass, nothing blended: cut at the opaque threshold.
extern const TransparencyMode kOpaqueMode;

/// As the command line calls it: "blend", "opaque" and so on.
[[nodiscard]] const char* name_of(const TransparencyMode& transparency);

}  // namespace coif
