#pragma once

#include <coif/export.h>

namespace coif {

/// What keeps linked chains together (Asset::links(), HairDesc::links; runtime/docs/MODEL.md, "Links"). A program that
/// does not name it holds nothing of it.
struct LinkCode;
extern COIF_API const LinkCode kLinks;           ///< For kCoifSolver, kCascadeSolver and kPassiveSolver.
extern COIF_API const LinkCode kCharacterLinks;  ///< For kCharacterSolver and kCharacterCascadeSolver.

}  // namespace coif
