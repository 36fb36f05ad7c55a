#include "base/words.h"
#include "cook/select/crown_view.h"
#include "cook/select/hair_chooser.h"
#include "cook/select/select_hair.h"
#include "cook/select/under_hair.h"

#include "import/source_warnings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <functional>

namespace coif::cook {
namespace {
using importer::SourceMesh, importer::SourceModel;

constexpr double kBare = 0.05;  ///< Share of the crown: hair that covers more may be all.
/// What nobody called hair is never surer than this, so that the cook warns of it.
constexpr double kMostOfGuess = 0.79;
constexpr double kOpenFace = 0.06;  ///< Share of the circle around a head that its hair leaves open.
/// That all of a model without names is hair, which leaves a face open, or goes all round. By hand.
constexpr double kHairAlone = 0.95, kMaybeHead = 0.4;
constexpr double kMuchOfCrown = 0.3;  ///< Share of it from which on opaque hair goes before what is transparent.
constexpr double kLikely = 0.5;       ///< Probability of what is taken besides the likeliest part.
constexpr double kMostFace = 0.2;     ///< Share of the face that hair covers beside other hair.
constexpr double kOtherColor = 0.14;  ///< Distance of colours.

void choose_by_names_of_recipe(const SourceModel& source, const HairRecipe& recipe, HairChooser& chooser) {
  if (recipe.hair_meshes.empty() && recipe.hair_materials.empty() && recipe.hair_bones.empty()) return;
  std::vector<bool> bones;
  for (const importer::SourceNode& node : source.nodes) bones.push_back(matches_any(node.name, recipe.hair_bones));
  for (std::uint32_t m = 0; m < source.meshes.size(); ++m) {
    const SourceMesh& mesh = source.meshes[m];
    if (!recipe.hair_meshes.empty() && !matches_any(mesh.name, recipe.hair_meshes)) continue;
    if (!recipe.hair_materials.empty() && !matches_any(material_name(source, mesh), recipe.hair_materials)) continue;
    if (recipe.hair_bones.empty()) {
      chooser.take_mesh(m, "the recipe names it");
    } else {
      chooser.take_pieces(m, bones, importer::kNoIndex, "pieces that bones named in the recipe move",
                          [](const PieceEvidence& piece) { return piece.largest_triangle_share > 0.5; });
    }
  }
}

tl::expected<void, ToolError> choose_by_recipe(const SourceModel& source, const HairRecipe& recipe,
                                               HairChooser& chooser) {
  choose_by_names_of_recipe(source, recipe, chooser);
  if (recipe.hair_parts.empty()) return {};
  const HairCandidates& candidates = chooser.candidates();
  const auto parts = parts_at(source, candidates, recipe.hair_parts);
  if (!parts) return tl::unexpected(parts.error());
  for (const std::size_t part : *parts)
    chooser.take_triangles(candidates.list[part].mesh, candidates.list[part].taken, "the recipe has a point on it");
  return {};
}

void choose_by_name(const SourceModel& source, const std::vector<bool>& bones, std::uint32_t head,
                    HairChooser& chooser) {
  for (std::uint32_t m = 0; m < source.meshes.size(); ++m) {
    const std::string why = names_of(source, source.meshes[m]).why_hair;
    if (why.empty()) continue;
    chooser.take_pieces(m, bones, head, why, [](const PieceEvidence& piece) { return piece.eye_bone_share < 0.5; });
  }
}

void choose_by_bones(const SourceModel& source, const std::vector<bool>& bones, std::uint32_t head,
                     HairChooser& chooser) {
  for (std::uint32_t m = 0; m < source.meshes.size(); ++m) {
    chooser.take_pieces(m, bones, head, "pieces that hair bones move",
                        [](const PieceEvidence& piece) { return piece.is_moved_as_hair(); });
  }
}

void choose_by_transparency(const SourceModel& source, const std::vector<bool>& bones, std::uint32_t head,
                            HairChooser& chooser) {
  if (head == importer::kNoIndex) return;
  const double neck = source.nodes[head].model_from_node.translation().y();
  for (std::uint32_t m = 0; m < source.meshes.size(); ++m) {
    if (!is_transparent(source, source.meshes[m]) || names_of(source, source.meshes[m]).say_otherwise) continue;
    const bool rigid = source.meshes[m].influence_begin.empty();
    chooser.take_pieces(m, bones, head, "transparent pieces on the head", [&](const PieceEvidence& piece) {
      const bool on_head = rigid ? piece.height > neck : piece.head_share >= kOnHead;
      return on_head && piece.eye_bone_share < kMovedByEyes;
    });
  }
}

void take_caps(const SourceModel& source, HairChooser& chooser) {
  const std::vector<bool> caps = find_scalp_caps(source, chooser.so_far());
  for (std::uint32_t m = 0; m < caps.size(); ++m) {
    if (!caps[m] || either_is_called(source, source.meshes[m], is_called_adornment)) continue;
    chooser.take_mesh(m, "it lies under the hair, on the scalp");
  }
}

void take_cores(const SourceModel& source, std::uint32_t head, HairChooser& chooser) {
  HairChoice cores = find_hair_cores(source, chooser.so_far(), head);
  for (std::uint32_t m = 0; m < cores.taken.size(); ++m) {
    if (either_is_called(source, source.meshes[m], is_called_adornment)) continue;
    chooser.take_triangles(m, cores.taken[m], "what hair is wrapped around, in the mesh of a head");
  }
}

/// What said first what hair is.
enum class FoundBy { kName, kBones, kAlpha };

/// How much of the crown, or of the face, what was chosen covers.
double chosen_share(const HairCandidates& candidates, const HairChoice& choice, Feature feature) {
  double share = 0;
  for (const HairCandidate& part : candidates.list) share += part.at(feature) * part.share_of(choice);
  return share;
}

bool is_cover(const HairCandidate& part) {
  return part.probability >= kLikely && part.at(Feature::kCrown) > kBare && part.at(Feature::kFace) <= kMostFace;
}

/// Takes what covers the crown, too, where what was found leaves it bare.
bool take_crown(const SourceModel& source, HairChooser& chooser) {
  std::vector<const HairCandidate*> cover;
  for (const HairCandidate& part : chooser.candidates().list)
    if (is_cover(part)) cover.push_back(&part);
  if (cover.empty()) return false;
  chooser.guess(name_of(source, *cover[0]),
                "what is called hair leaves the crown of the head bare; " + reason_for(source, *cover[0]),
                std::min(cover[0]->probability, kMostOfGuess));
  for (const HairCandidate* part : cover)
    chooser.take_triangles(part->mesh, part->taken, "it covers the crown of the head");
  return true;
}

/// Whether everything chosen is called a beard or a brow, which need no crown.
bool is_face_hair(const SourceModel& source, const HairChoice& choice) {
  for (std::size_t m = 0; m < source.meshes.size(); ++m) {
    const SourceMesh& mesh = source.meshes[m];
    const bool is_called =
        either_is_called(source, mesh, is_called_beard) || either_is_called(source, mesh, is_called_brow);
    if (!choice.taken[m].empty() && !is_called) return false;
  }
  return true;
}

/// Takes the parts for which `fits` that were not chosen yet, as a guess.
void take_too(const SourceModel& source, const char* what, const std::string& why,
              const std::function<bool(const HairCandidate&)>& fits, HairChooser& chooser) {
  const HairCandidate* first = nullptr;
  for (const HairCandidate& part : chooser.candidates().list) {
    if (part.share_of(chooser.so_far()) >= 0.5 || !fits(part)) continue;
    if (first == nullptr) first = &part;
    chooser.take_triangles(part.mesh, part.taken, why);
  }
  if (first == nullptr) return;
  chooser.guess(what, reason_for(source, *first), std::min(first->probability, kMostOfGuess));
}

/// Parts of meshes of which hair bones move others, that cover the crown, too.
void take_beside_moved(const SourceModel& source, HairChooser& chooser) {
  take_too(
      source, "what is beside the hair that bones move", "it is beside what hair bones move",
      [](const HairCandidate& part) { return part.at(Feature::kBesideMoved) > 0 && is_cover(part); }, chooser);
}

/// Parts of a material that hair has, too, where names spoke of some of them alone.
void take_alike(const SourceModel& source, HairChooser& chooser) {
  std::vector<bool> is_of_hair(source.materials.size() + 1, false);  // The last: no material.
  const auto material = [&](std::uint32_t m) {
    return std::min<std::size_t>(source.meshes[m].material, source.materials.size());
  };
  for (std::uint32_t m = 0; m < source.meshes.size(); ++m)
    if (!chooser.so_far().taken[m].empty()) is_of_hair[material(m)] = true;
  is_of_hair.back() = false;
  const auto is_alike = [&](const HairCandidate& part) {
    return is_of_hair[material(part.mesh)] && part.probability >= kLikely && part.at(Feature::kCalledOther) == 0 &&
           part.at(Feature::kFace) <= kMostFace && part.at(Feature::kEyeBones) <= kMovedByEyes;
  };
  take_too(source, "what has the material of the hair, too", "it has the material of the hair", is_alike, chooser);
}

/// Asks whether what was found is all: takes what covers a crown that it leaves bare, or warns where nothing does.
/// Where bones said what hair is, they may move only some of it.
void take_rest(const SourceModel& source, FoundBy found, HairChooser& chooser) {
  const HairCandidates& candidates = chooser.candidates();
  if (!candidates.sees_head) return;
  if (found == FoundBy::kBones) take_beside_moved(source, chooser);
  if (found == FoundBy::kName) take_alike(source, chooser);
  const double crown = chosen_share(candidates, chooser.so_far(), Feature::kCrown);
  const double face = chosen_share(candidates, chooser.so_far(), Feature::kFace);
  if (crown <= kBare && take_crown(source, chooser)) return;
  if (crown > kBare || is_face_hair(source, chooser.so_far())) return;
  if (face <= crown) return;  // What hangs behind or beside a head may be all: tails, or strips on painted hair.
  chooser.guess("what was found", "it lies on the face and leaves the crown of the head bare", 0.6);
}

/// Whether something tells it from a face, a body or a helmet of unknown colour: a mesh of its own, its colour, bones.
bool is_told_apart(const HairCandidate& part) {
  return part.is_whole_mesh || part.at(Feature::kUnlikeFace) > kOtherColor || part.at(Feature::kBesideMoved) > 0;
}

/// Takes the likeliest part, and what is as likely, of a character on which nothing is called hair; false where no part
/// is likely enough.
bool take_likeliest(const SourceModel& source, HairChooser& chooser) {
  const HairCandidates& candidates = chooser.candidates();
  if (!candidates.sees_head) return false;
  const auto likely = std::ranges::find_if(candidates.list, [](const HairCandidate& part) {
    return part.probability >= kLikely && part.at(Feature::kCrown) > kBare && is_told_apart(part);
  });
  if (likely == candidates.list.end()) return false;
  const HairCandidate& best = *likely;
  chooser.guess(name_of(source, best), reason_for(source, best), std::min(best.probability, kMostOfGuess));
  for (const HairCandidate& part : candidates.list)
    if (&part == &best || (part.probability >= kLikely && is_told_apart(part)))
      chooser.take_triangles(part.mesh, part.taken, reason_for(source, part));
  return true;
}

/// Whether the likeliest part is opaque: what is transparent may be a glass, or soft edges of brows.
bool knows_better_than_alpha(const SourceModel& source, const HairCandidates& candidates) {
  if (!candidates.sees_head || candidates.list.empty()) return false;
  const HairCandidate& best = candidates.list[0];
  return best.probability >= kLikely && best.at(Feature::kCrown) > kMuchOfCrown && is_told_apart(best) &&
         !is_transparent(source, source.meshes[best.mesh]);
}

bool is_file_called_hair(const SourceModel& source) {
  return is_called_hair(std::filesystem::path(source.path).stem().string());
}

/// Hair by itself leaves the face open; a head closes it, a body stands on its feet.
void take_everything(const SourceModel& source, std::uint32_t head, HairChooser& chooser) {
  for (std::uint32_t m = 0; m < source.meshes.size(); ++m) chooser.take_mesh(m, "all of it may be hair");
  if (is_face_hair(source, chooser.so_far())) return;
  const double open = open_face(source);
  const bool is_open = open > kOpenFace, stands = stands_on_ground(source);
  chooser.guess("all of it",
                fmt::format("nothing says what is hair; {}{}",
                            is_open ? "it leaves a face open, as hair alone does" : "it goes all round, as a head does",
                            stands ? ", and stands on the ground as a body does" : ""),
                stands || !is_open           ? kMaybeHead
                : head == importer::kNoIndex ? kHairAlone
                                             : kMostOfGuess,
                {{"open", open}, {"stands", stands ? 1 : 0}, {"called", is_file_called_hair(source) ? 1 : 0}});
}

}  // namespace

tl::expected<HairChoice, ToolError> choose_hair(const SourceModel& source, const HairRecipe& recipe,
                                                Findings& findings) {
  if (auto ok = check_hair_names(source, recipe); !ok) return tl::unexpected(ok.error());
  HairChooser chooser(source, recipe, findings);
  if (recipe.names_hair()) {
    if (auto ok = choose_by_recipe(source, recipe, chooser); !ok) return tl::unexpected(ok.error());
    return std::move(chooser).finish();
  }
  const std::uint32_t head = guess_head_node(source);
  const std::vector<bool> bones = find_hair_bones(source);
  FoundBy by = FoundBy::kName;
  choose_by_name(source, bones, head, chooser);
  if (!chooser.found()) {
    by = FoundBy::kBones;
    choose_by_bones(source, bones, head, chooser);
  }
  const bool is_character = moves_limbs(source);
  if (!chooser.found() && !(is_character && knows_better_than_alpha(source, chooser.candidates()))) {
    by = FoundBy::kAlpha;
    choose_by_transparency(source, bones, head, chooser);
  }
  if (!chooser.found() && is_character) {
    if (!take_likeliest(source, chooser)) return no_hair_on(source, chooser.candidates());
  } else if (chooser.found() && head != importer::kNoIndex) {
    take_rest(source, by, chooser);
  }
  const bool is_body = !chooser.found() && is_bare_body(source, recipe.patch_weld_distance);
  if (is_body && !is_file_called_hair(source)) return no_hair_in_body(source);
  if (!chooser.found()) take_everything(source, head, chooser);
  take_caps(source, chooser);
  take_cores(source, head, chooser);
  return std::move(chooser).finish();
}

}  // namespace coif::cook
