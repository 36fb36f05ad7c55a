#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace coif {

/// Looks through a COLLADA document for an accessor that reads beyond the end of its array, which assimp 5.2 does: what it
/// finds there differs from run to run. Nothing where all fit; else a sentence without the file's name. What is no XML is left
/// for assimp to refuse. Source: Khronos, "COLLADA 1.4.1 Specification", chapter 5, <accessor>.
[[nodiscard]] std::optional<std::string> overrun_array(std::string_view document);

}  // namespace coif
