#pragma once
// The parts of issue_codes(), by what they are said of.

#include "validate/issue_codes.h"

namespace coif {

[[nodiscard]] std::span<const IssueCode> refusal_codes();  ///< Files and assets that cannot be opened.
[[nodiscard]] std::span<const IssueCode> asset_codes();    ///< Assets that open and yet do badly.
[[nodiscard]] std::span<const IssueCode> origin_codes();   ///< Sources, and whether assets still match theirs.

}  // namespace coif
