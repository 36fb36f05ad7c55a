#pragma once

// What names say of levels of detail.

#include <optional>
#include <string>
#include <string_view>

namespace coif {

/// "hair" and 1 of "Hair_LOD1", or of "Hair_L1".
struct LevelName {
  std::string thing;
  unsigned level = 0;
  bool is_sure = false;  ///< By the letters LOD. An L may be the left side, whose locks are numbered.
};

/// In small letters; none where the name says nothing of a level.
[[nodiscard]] std::optional<LevelName> level_in(std::string_view name);

/// "lock" of "Lock_R1" or "Lock_R": what is there on the right side, so that an L beside it is the left one.
[[nodiscard]] std::optional<std::string> thing_on_the_right(std::string_view name);

}  // namespace coif
