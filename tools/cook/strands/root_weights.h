#pragma once

namespace coif::cook {

/// How much each sign counts when roots are sought: the one table of these weights. Fitted by tests/corpus/fit_roots.py
/// on made-up styles whose roots are known, and on labelled files of artists; what is not said there was set by hand.
struct RootWeights {
  // Which end of a patch is the root: the weights of RootEvidence.
  float distance = 0.78f;      ///< An end that is half a head's radius nearer to the head.
  float bones = 1.5f;          ///< An end whose bones are one step nearer to the head bone.
  float height = 0.25f;        ///< An end that is one radius higher: hair hangs.
  float shell_height = 0.80f;  ///< The same on a shell around the head, which has its roots on top.
  float taper = 0.23f;         ///< An end that is wider, where the other is a point.
  float tied = 0.88f;          ///< An end without free hair beside it, where the other has a tail beside it.
  float fade = 1.19f;          ///< An end that is opaque, where the other is transparent.

  // What other patches say of it.
  float neighbour = 1.25f;  ///< All that touch it and run parallel.
  float mirror = 0.87f;     ///< All at its mirror image.
  float island = 1.21f;     ///< All that show the same part of the texture.
  float common = 0.35f;     ///< All others in the texture.
  float habit = 0.16f;      ///< Share of the two above where nothing is painted differently at root and tip.

  // Along which axis the strands run.
  float longer = 0.96f;         ///< A texture axis along which the patch is longer.
  float lines = 2.01f;          ///< One along which images have lines.
  float ends = 1.05f;           ///< The signs above, up to three.
  float common_axis = 0.19f;    ///< The one of most patches.
  float unwrapped = 0.28f;      ///< Somebody unwrapped a shell along any of them, rather than down from its top.
  float mirrored_axis = 1.55f;  ///< One that runs alike on both sides of a shell.
};

}  // namespace coif::cook
