#include "cli/clip_choice.h"

#include "import/clip_file.h"
#include "import/printable_text.h"
#include "motion/clip_path.h"

#include <utility>
#include <vector>

namespace coif {

std::optional<ClipChoice> find_clip(std::string_view word) {
  if (word.find_first_of("./") == std::string_view::npos) return std::nullopt;
  const std::size_t colon = word.find(':');
  if (colon == std::string_view::npos) return ClipChoice{word, ""};
  return ClipChoice{word.substr(0, colon), std::string(word.substr(colon + 1))};
}

tl::expected<HeadClip, ToolError> open_clip(const ClipChoice& choice, const Messages& messages) {
  const auto clip = read_clip(choice.file, choice.node);
  if (!clip) return tl::unexpected(clip.error());
  for (const std::string& note : clip->notes) messages.note(note);
  std::vector<ClipKey> keys;
  keys.reserve(clip->keys.size());
  for (const NodeKey& key : clip->keys) keys.push_back({key.seconds, key.position, key.rotation});
  std::shared_ptr<const HeadPath> path = path_of(std::move(keys));
  if (path) return HeadClip{printable_text(choice.file.filename().string()) + ":" + clip->node, std::move(path)};
  return tl::unexpected(ToolError{ToolError::Kind::kInternal, choice.file.string() + ": read keys make no path"});
}

}  // namespace coif
