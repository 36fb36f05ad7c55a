#pragma once

#include "cli/messages.h"
#include "motion/head_path.h"
#include "tool_error.h"

#include <tl/expected.hpp>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace coif {

/// An animated node of a model file, as people name it: CLIP or CLIP:NODE.
struct ClipChoice {
  std::filesystem::path file;
  std::string node;  ///< Empty: the file's only animated node.
};

/// None for a word that is no file's name. The first colon ends the file's name: nodes have colons in theirs too.
[[nodiscard]] std::optional<ClipChoice> find_clip(std::string_view word);

/// A clip as a movement of the head.
struct HeadClip {
  std::string name;                      ///< "walk.glb:head", printable.
  std::shared_ptr<const HeadPath> path;  ///< Not null.
};

/// Reads it; `messages` gets what was taken otherwise than the file says. Errors: as read_clip().
[[nodiscard]] tl::expected<HeadClip, ToolError> open_clip(const ClipChoice& choice, const Messages& messages);

}  // namespace coif
