#include "cli/body.h"
#include "cli/view_output.h"
#include "cook/select/hair_evidence.h"
#include "render/presentation.h"
#include "view/body/compact_body.h"
#include "view/view_page.h"

#include <algorithm>
#include <utility>

namespace coif::cli {
namespace {

/// The name of the bone that the hair hangs on.
std::string head_bone_of(const Asset* asset, const importer::SourceModel& body) {
  if (asset != nullptr) {
    const char* const name = asset->bone_name(0);
    return name != nullptr ? name : "";
  }
  const auto head = std::ranges::find_if(body.nodes, cook::is_called_head, &importer::SourceNode::name);
  return head != body.nodes.end() ? head->name : "";
}

}  // namespace

tl::expected<std::string, ToolError> bodied_page(const std::filesystem::path& place, std::string page,
                                                 const PageBodyOptions& options, const Asset* asset,
                                                 const Messages& messages, std::vector<std::filesystem::path>& files) {
  if (options.file.empty()) return page;
  const Asset unknown;
  auto body = read_body({options.file, options.mesh, std::nullopt, options.roots, options.limits},
                        asset != nullptr ? *asset : unknown, messages);
  if (!body) return tl::unexpected(body.error());
  files.insert(files.end(), body->files.begin(), body->files.end());
  if (body->model.meshes.empty()) {
    messages.warning(options.file + ": has nothing but the hair; shown as without --body");
    return page;
  }
  const render::BodyTextures textures = render::read_body_textures(body->model, body->findings);
  messages.tell(body->findings.warnings, options.file);
  const view::CompactBody compact = view::compact_body(body->model, textures, head_bone_of(asset, body->model));
  if (compact.body.meshes.empty()) {
    messages.warning(options.file + ": is made of too many pieces for a page; shown as without --body");
    return page;
  }
  auto bodied = view::with_body(page, view::body_json(compact));
  if (!bodied) return tl::unexpected(ToolError{bodied.error().kind, place.string() + ": " + bodied.error().message});
  return bodied;
}

}  // namespace coif::cli
