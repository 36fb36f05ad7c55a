#pragma once
// The code that exists once per instruction set, behind plain functions. Each pointer is null where a build lacks the set.

#include "row.h"
#include "step_parts.h"

#include <coif/instruction_set.h>

namespace coif {

/// Steps all lanes of a row.
using RowFunction = void(const RowStep& row);
RowFunction* coif_row_code(InstructionSet set);
RowFunction* thesis_row_code(InstructionSet set);

/// Follows the heads of one block through a step. In this order: look_ahead, begin, move for each part, finish.
struct HeadCode {
  void (*look_ahead)(const HeadLanes& heads, const StepParts& parts, HeadStepLanes& step) = nullptr;
  void (*begin)(HeadLanes& heads, const StepParts& parts, HeadStepLanes& step) = nullptr;
  /// `move` holds the last part's on entry. Returns by `carried` how the hair has to be turned before the part, where
  /// parts.inertia is below 1.
  void (*move)(const HeadLanes& heads, const HeadStepLanes& step, const StepParts& parts, std::uint32_t part,
               MoveLanes& move, Lanes4& carried) = nullptr;
  void (*finish)(HeadLanes& heads, const HeadStepLanes& step) = nullptr;
};
HeadCode head_code(InstructionSet set);

}  // namespace coif
