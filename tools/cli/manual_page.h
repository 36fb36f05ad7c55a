#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace coif {

/// The program's manual page, in roff for man(1): its own help, command by command, and what help has no room for.
[[nodiscard]] std::string manual_page(const CLI::App& program);

}  // namespace coif
