#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace coif {

/// What is wrong and where, for people: the library's own prefix names its exception's class, which tells them nothing.
[[nodiscard]] inline std::string json_fault(const nlohmann::json::exception& error) {
  const std::string what = error.what();
  const std::size_t prefix = what.find("] ");
  return prefix == std::string::npos ? what : what.substr(prefix + 2);
}

}  // namespace coif
