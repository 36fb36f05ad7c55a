#include "cli/exit_code.h"

namespace coif {

const char* const kExitCodeHelp =
    "Exit codes: 0 ok, 1 usage, 2 file access, 3 bad input or asset, 4 over budget,\n"
    "            5 unsupported, 70 internal error";

Exit exit_code(ToolError::Kind kind) {
  switch (kind) {
    case ToolError::Kind::kUsage: return Exit::kUsage;
    case ToolError::Kind::kFileAccess: return Exit::kFileAccess;
    case ToolError::Kind::kBadInput: return Exit::kBadInput;
    case ToolError::Kind::kOverBudget: return Exit::kOverBudget;
    case ToolError::Kind::kUnsupported: return Exit::kUnsupported;
    case ToolError::Kind::kInternal: return Exit::kInternal;
  }
  return Exit::kInternal;
}

}  // namespace coif
