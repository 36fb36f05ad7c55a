#pragma once

#include <coif/export.h>

namespace coif {

/// Keeps linked chains together (Asset::links(), HairDesc::links; runtime/docs/MODEL.md, "Links"). A program that does
/// not name kLinks or kCharacterLinks does not link its code.
struct LinkCode;
extern COIF_API const LinkCode kLinks;           ///< For kCoifSolver, kCascadeSolver and kPassiveSolver.
extern COIF_API const LinkCode kCharacterLinks;  ///< For kCharacterSolver and kCharacterCascadeSolver.

}  // namespace coif
