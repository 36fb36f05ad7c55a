#pragma once
// Other published ways to draw hair that lets light through, and exact order: to compare those of coif/transparency.h
// with, not for games. They lie in a library of their own, coif::research, which needs coif::gl.

#include <coif/export.h>
#include <coif/transparency.h>

namespace coif {

/// One pass, nothing blended: alpha to coverage in proportion (thesis, 4.1.2). Of a soft texel's n samples it draws the
/// number that is nearest to alpha: n + 1 levels, off by 1 / (2 n) at most. (For four samples the thesis counts four
/// levels, 0, 33.3, 66.6 and 100 %; the rasterizer has five.) The driver chooses the samples, mostly the same ones for
/// the same share, so layers hide each other as with kBayerMode. The target's alpha as with kCoverageMode. For
/// multisampled targets; with one sample it is a cut at half. Queries GL_SAMPLES of the bound framebuffer.
extern COIF_API const TransparencyMode kProportionalMode;

/// kProportionalMode with the thesis's random pattern, the jitter of its Figure 16: the number of samples is rounded up
/// or down at random for each pixel and triangle. So its mean is alpha, and a slow change of alpha shows no steps. With
/// one sample, texels are drawn or not at random. With OpenGL ES 3.2 the samples that are drawn are random too, so that
/// layers do not hide each other and the target's alpha is right; earlier versions cannot choose samples. The pattern
/// is fixed to the screen.
extern COIF_API const TransparencyMode kJitteredMode;

/// One pass, nothing blended: screen-door as published (thesis, 4.1.1). Soft texels show in every other pixel, as on a
/// checkerboard, whatever their alpha. All surfaces use the same pixels, so at most two are seen: the nearest soft one
/// and the solid one behind (its Figure 7).
extern COIF_API const TransparencyMode kCheckerboardMode;

/// One pass, nothing blended: screen-door with Bayer's ordered pattern (Bayer 1973). In each 4 x 4 pixels a soft
/// surface shows in a share of them that is nearest to its alpha, in the same ones on all surfaces: 17 levels, off by 1
/// / 32 at most. A soft layer behind another is seen only where its alpha is larger.
extern COIF_API const TransparencyMode kBayerMode;

/// The reference: kBlendMode's texels with soft ones sorted by depth in each pixel, whatever order the asset has; at
/// equal depths the patch stored later is in front. Solid texels start at the opaque threshold, as in all modes; to
/// draw exactly the texture's alpha, use a material whose thresholds are 1 and 0. For targets with one sample: with
/// several, each texel counts for its whole pixel. Not for games: waits for the GPU in each draw.
///
/// With OpenGL ES 3.1 it lists each pixel's texels in a buffer of RendererDesc::list_bytes and sorts them. With OpenGL
/// ES 3.0, or where the buffer is too small, it peels layer after layer, with three draw calls of the crowd for each.
/// Besides, lists need 4 and peeling 24 bytes for each pixel of the viewport. The first draw makes all of it, with a
/// call of glGetError, and a larger viewport makes it again; draw() returns kDriver where there is no memory. Peeling
/// rounds each layer to the target's format, applies no polygon offset to soft texels, and uses a query of whether any
/// samples passed, so no such query of the host may be active.
extern COIF_API const TransparencyMode kExactMode;

}  // namespace coif
