#pragma once
// Other published ways to draw hair that lets light through, and exact order: to compare those of coif/transparency.h
// with, not for games. They lie in a library of their own, coif::research, which needs coif::gl.

#include <coif/export.h>
#include <coif/transparency.h>

namespace coif {

/// One pass, nothing blended: alpha to coverage in proportion (thesis, 4.1.2). Of a soft texel's n samples a share is
/// drawn that is the nearest to its alpha: n + 1 levels, off by 1 / (2 n) at most. (For four samples the thesis counts
/// four levels, 0, 33.3, 66.6 and 100 %; the rasterizer has five.) Which samples is the driver's choice, mostly the
/// same ones for the same share, so layers hide each other as with kBayerMode. The target's alpha as with
/// kCoverageMode. For multisampled targets; with one sample it is a cut at half. Asks for GL_SAMPLES of the bound
/// framebuffer.
extern COIF_API const TransparencyMode kProportionalMode;

/// kProportionalMode with the thesis's random pattern, whose jitter is in its Figure 16: the number of samples is
/// rounded up or down at random for each pixel and triangle, so that its mean is alpha and a slow change of alpha shows
/// no steps. With one sample texels are drawn or not at random. With OpenGL ES 3.2 it is also random which samples are
/// drawn, so that layers do not hide each other, and the target's alpha is right; before that nobody may choose them.
/// The pattern stays with the screen.
extern COIF_API const TransparencyMode kJitteredMode;

/// One pass, nothing blended: screen-door as published (thesis, 4.1.1). Soft texels show in every other pixel, as on a
/// checkerboard, whatever their alpha. The pixels are the same for all surfaces, so two are seen at most: the nearest
/// soft one and what is solid behind (its Figure 7).
extern COIF_API const TransparencyMode kCheckerboardMode;

/// One pass, nothing blended: screen-door with Bayer's ordered pattern (Bayer 1973). Of soft texels every 4 x 4 pixels
/// show as many as their alpha asks for, the same ones on all surfaces: 17 levels, off by 1 / 32 at most. A soft layer
/// behind another is seen only as far as its alpha is greater.
extern COIF_API const TransparencyMode kBayerMode;

/// The reference: kBlendMode's texels, soft ones in the order of their depth in each pixel, whatever order the asset
/// has; of equal depths the patch stored later is in front. Takes solid texels from the opaque threshold on like all
/// modes; for what the texture itself says draw with a material whose thresholds are 1 and 0. For targets of one
/// sample: of several, each texel counts for its whole pixel. Not for games: waits for the GPU in each draw.
///
/// With OpenGL ES 3.1 lists each pixel's texels in a buffer of RendererDesc::list_bytes and sorts them; with OpenGL
/// ES 3.0, or where the buffer is too small, peels layer after layer, each of which takes three draw calls of the
/// crowd. Beside that, lists need 4 and peeling 24 bytes for each pixel of the viewport. All of it is made, with a look
/// at glGetError, at the first draw, and again for a larger viewport; draw() returns kDriver where there is none.
/// Peeling rounds each layer to the target's format, takes no polygon offset for soft texels, and asks whether any
/// samples passed, so that no query of the host's for that may be under way.
extern COIF_API const TransparencyMode kExactMode;

}  // namespace coif
