#pragma once
// The air around each head, for hair on a character: see CharacterCode.

#include "lanes/lane_layout.h"
#include "lanes/step_parts.h"

#include <coif/hair.h>

#include <cstdint>

namespace coif {

class MemoryCarver;
struct CharacterState;
struct CrowdState;
struct RowCharacter;

void carve_air(MemoryCarver& carver, const HairDesc& desc, std::uint32_t blocks, CharacterState& character);

/// Moves the air of gusts on.
void pass_time(CrowdState& crowd, float dt);

/// Implements CharacterCode::blow.
void blow(CrowdState& crowd, std::uint32_t block, const StepParts& parts, std::uint32_t part, MoveLanes& move);

/// Gives a row of the block's heads its part of the air.
void set_up_air(const CharacterState& character, std::uint32_t block, RowCharacter& row);

}  // namespace coif
