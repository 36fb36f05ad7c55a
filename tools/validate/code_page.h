#pragma once

#include <string>

namespace coif {

/// All codes as a page in Markdown, which reads well on a terminal too: ISSUES.md.
[[nodiscard]] std::string code_page();

/// {"codes": [{code, group, severity, title, meaning, cure}]}
[[nodiscard]] std::string code_json();

}  // namespace coif
