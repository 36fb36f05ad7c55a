#include "cook/select/hair_chooser.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace coif::cook {

HairChooser::HairChooser(const importer::SourceModel& source, const HairRecipe& recipe, Findings& findings)
    : source_(source), recipe_(recipe), findings_(findings) {
  choice_.taken.resize(source.meshes.size());
}

const HairCandidates& HairChooser::candidates() {
  if (!candidates_) candidates_ = find_hair_candidates(source_, recipe_.patch_weld_distance);
  return *candidates_;
}

void HairChooser::take_mesh(std::uint32_t m, const std::string& why) {
  take_triangles(m, std::vector<bool>(source_.meshes[m].triangles.size() / 3, true), why);
}

void HairChooser::take_pieces(std::uint32_t m, const std::vector<bool>& bones, std::uint32_t head,
                              const std::string& why, const std::function<bool(const PieceEvidence&)>& fits) {
  const importer::SourceMesh& mesh = source_.meshes[m];
  const MeshPieces pieces = find_pieces(mesh, recipe_.patch_weld_distance);
  const std::vector<PieceEvidence> evidence = weigh_pieces(source_, mesh, pieces, bones, head);
  std::vector<bool> taken;
  for (std::uint32_t piece : pieces.piece_of) taken.push_back(fits(evidence[piece]));
  take_triangles(m, taken, why);
}

void HairChooser::take_triangles(std::uint32_t m, const std::vector<bool>& taken, const std::string& why) {
  const auto count = std::size_t(std::ranges::count(taken, true));
  if (count == 0) return;
  choice_.taken[m].resize(taken.size(), false);
  for (std::size_t t = 0; t < taken.size(); ++t) choice_.taken[m][t] = choice_.taken[m][t] || taken[t];
  note(m, count, why);
}

HairChoice HairChooser::finish() && {
  for (Decision& guess : guesses_) {
    guess.key = recipe_line(source_, choice_, candidates());
    findings_.decide(std::move(guess));
  }
  for (std::uint32_t m = 0; m < source_.meshes.size(); ++m) {
    const std::size_t count = source_.meshes[m].triangles.size() / 3;
    const auto taken = std::size_t(std::ranges::count(choice_.taken[m], true));
    if (taken == 0) {
      findings_.leave_out({fmt::format("mesh '{}' ({} triangles)", source_.meshes[m].name, count), "not hair"});
    } else if (taken < count) {
      findings_.leave_out({fmt::format("mesh '{}', {} triangles", source_.meshes[m].name, count - taken),
                           "of pieces that are not hair"});
    }
  }
  return std::move(choice_);
}

void HairChooser::note(std::uint32_t m, std::size_t triangles, const std::string& why) {
  found_ += triangles;
  findings_.note(fmt::format("hair: mesh '{}' ({} triangles): {}", source_.meshes[m].name, triangles, why));
}

}  // namespace coif::cook
