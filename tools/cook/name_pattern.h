#pragma once

#include <span>
#include <string>
#include <string_view>

namespace coif {

/// True where `name` matches `pattern`: * stands for any run of characters, ? for one, letters match in either case.
[[nodiscard]] bool matches(std::string_view name, std::string_view pattern);
[[nodiscard]] bool matches_any(std::string_view name, std::span<const std::string> patterns);

}  // namespace coif
