#pragma once

#include <coif/export.h>

namespace coif {

/// A way to draw hair that lets light through. A program holds those that it names, and builds the shaders of those
/// that it draws with. Their image errors and costs: `coif report FILE order` and `cost`. Ways to compare these with,
/// exact order among them, are in coif/research.h.
struct TransparencyMode;

/// The four passes of the thesis (5.3.1): solid texels; back faces of the rest, blended; its front faces; depth. Within
/// a pass triangles are sorted only by the cooked order.
extern COIF_API const TransparencyMode kBlendMode;

/// One pass, nothing blended: cut at the opaque threshold.
extern COIF_API const TransparencyMode kOpaqueMode;

/// One pass, nothing blended: alpha to coverage, sharpened, which the thesis does not have. The cut is the line where
/// alpha is half, or the opaque threshold if that is less. In a pixel on this line the samples inside are drawn, so
/// edges are as smooth as the target has samples. For multisampled targets; with one sample the cut lies half a pixel
/// further out. The target's alpha stays 1 where it was 1; over a smaller alpha it is only right in pixels that the
/// hair covers completely.
extern COIF_API const TransparencyMode kCoverageMode;

/// One pass, nothing blended: screen-door with Bayer's ordered pattern (Bayer 1973), mixed anew in each square of 4 x 4
/// pixels and by each triangle, which is coif's, so that layers do not hide each other. The pattern stays with the
/// screen.
extern COIF_API const TransparencyMode kScreenDoorMode;

/// One pass, nothing blended: hashed alpha (Wyman and McGuire 2017). Soft texels are drawn at random points, which are
/// fixed to the hair at rest, so the noise moves with the strands.
extern COIF_API const TransparencyMode kHashedMode;

/// The name on the command line: "blend", "opaque" and so on.
[[nodiscard]] COIF_API const char* name_of(const TransparencyMode& transparency);

}  // namespace coif
