#include "cli/moved_page.h"

#include "base/files.h"
#include "view/view_motion.h"

#include <string_view>

namespace coif::cli {

tl::expected<std::string, ToolError> moved_page(const std::filesystem::path& place,
                                                const std::optional<HeadMotion>& motion, const Messages& messages) {
  const auto bytes = FileBytes::read(place);
  if (!bytes) return tl::unexpected(bytes.error());
  const std::string_view page(reinterpret_cast<const char*>(bytes->span().data()), bytes->span().size());
  if (!motion) return std::string(page);

  HeadClip clip{motion::all_motions()[std::size_t(motion->motion)].name, nullptr, {}};
  if (motion->clip) {
    auto opened = open_clip(*motion->clip, messages);
    if (!opened) return tl::unexpected(opened.error());
    clip = std::move(*opened);
  }
  auto moved = view::with_motion(page, clip.name, clip.keys);
  if (!moved) return tl::unexpected(ToolError{moved.error().kind, place.string() + ": " + moved.error().message});
  return moved;
}

}  // namespace coif::cli
