#include "cook/select/hair_candidates.h"
#include "cook/select/hair_evidence.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

namespace coif::cook {
namespace {

using importer::SourceMesh, importer::SourceModel;

constexpr double kProbablyNone = 0.35;  ///< Probability of the likeliest part below which there seems to be no hair.
constexpr std::size_t kHints = 5;       ///< Parts that an error names.

tl::unexpected<ToolError> bad_input(const SourceModel& source, const std::string& what) {
  return tl::unexpected(ToolError{ToolError::Kind::kBadInput, fmt::format("{}: {}", source.path, what)});
}

/// "mesh 'Head' (material 'Skin')"
std::vector<std::string> all_meshes(const SourceModel& source) {
  std::vector<std::string> meshes;
  for (const SourceMesh& mesh : source.meshes) {
    meshes.push_back(fmt::format("mesh '{}' (material '{}')", mesh.name, material_name(source, mesh)));
  }
  return meshes;
}

/// The likeliest parts, or all meshes where none may be hair.
std::string hints_of(const SourceModel& source, const HairCandidates& candidates) {
  if (!candidates.sees_head || candidates.list.empty())
    return fmt::format("there are: {}", fmt::join(all_meshes(source), ", "));
  std::vector<std::string> parts;
  for (const HairCandidate& part : candidates.list) {
    if (parts.size() == kHints) break;
    parts.push_back(fmt::format("{} ({})", name_of(source, part), certainty_text(part.probability)));
  }
  if (candidates.list.size() > kHints) parts.push_back(fmt::format("{} more", candidates.list.size() - kHints));
  return fmt::format("most likely first: {}; 'coif cook --list candidates' says why", fmt::join(parts, ", "));
}

}  // namespace

tl::unexpected<ToolError> no_hair_on(const SourceModel& source, const HairCandidates& candidates) {
  const std::string first = source.meshes.empty() ? "..." : source.meshes[0].name;
  const std::string line = candidates.sees_head && !candidates.list.empty()
                               ? recipe_line(source, candidates.list[0], candidates)
                               : fmt::format("\"hair\": {{\"meshes\": [\"{}\"]}}", first);
  const bool may_be_none =
      candidates.sees_head && (candidates.list.empty() || candidates.list[0].probability < kProbablyNone);
  return bad_input(source, fmt::format("nothing in this character is called hair, moved by hair bones or transparent "
                                       "on the head{}, as in {{{}}}; {}",
                                       may_be_none ? ", and probably there is none; else name it in a recipe"
                                                   : "; name what is hair in a recipe",
                                       line, hints_of(source, candidates)));
}

tl::unexpected<ToolError> no_hair_in_body(const SourceModel& source) {
  const std::string node = empty_hair_node(source);
  const bool hides_meshes = std::ranges::any_of(
      source.warnings, [](const Diagnostic& warning) { return warning.code == importer::source_code::kHidden; });
  const std::string lost = hides_meshes   ? "the file hides other meshes, which are not read: show the hair; "
                           : node.empty() ? ""
                                          : fmt::format("node '{}' has no mesh, so its hair was not exported; ", node);
  return bad_input(
      source,
      fmt::format("there is no hair, only what looks like a body: {}; {}export the hair, too: Blender "
                  "leaves curves and hair particles out "
                  "unless they are meshes (Object > Convert > Mesh, then export glTF with Data > Mesh > "
                  "Loose Edges), or export strands "
                  "by themselves and name this file by \"cards.body\"; if it is hair, say so in a recipe: "
                  "{{\"hair\": {{\"meshes\": [\"{}\"]}}}}",
                  fmt::join(all_meshes(source), ", "), lost, source.meshes.empty() ? "..." : source.meshes[0].name));
}

}  // namespace coif::cook
