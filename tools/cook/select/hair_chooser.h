#pragma once

#include "cook/recipe/hair_recipe.h"
#include "cook/select/hair_candidates.h"
#include "cook/select/hair_evidence.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace coif::cook {

/// Collects a choice of hair mesh by mesh, with the reasons. All arguments of the constructor must outlive it.
class HairChooser {
 public:
  HairChooser(const importer::SourceModel& source, const HairRecipe& recipe, Findings& findings);

  [[nodiscard]] bool found() const { return found_ > 0; }
  [[nodiscard]] const HairChoice& so_far() const { return choice_; }
  /// The candidates of the whole model, found when they are first asked for.
  [[nodiscard]] const HairCandidates& candidates();

  void take_mesh(std::uint32_t m, const std::string& why);
  /// Takes the pieces of mesh `m` for which `fits`; `bones` and `head` as for weigh_pieces().
  void take_pieces(std::uint32_t m, const std::vector<bool>& bones, std::uint32_t head, const std::string& why,
                   const std::function<bool(const PieceEvidence&)>& fits);
  /// `taken`: of each triangle of mesh `m`.
  void take_triangles(std::uint32_t m, const std::vector<bool>& taken, const std::string& why);

  /// A decision to which finish() adds the recipe's line that confirms all that was taken.
  void guess(std::string chosen, std::string reason, double probability, Features features = {}) {
    guesses_.push_back({"hair", std::move(chosen), std::move(reason), probability, "", std::move(features)});
  }

  /// Reports the guesses, and what was not taken.
  HairChoice finish() &&;

 private:
  void note(std::uint32_t m, std::size_t triangles, const std::string& why);

  const importer::SourceModel& source_;
  const HairRecipe& recipe_;
  Findings& findings_;
  HairChoice choice_;
  std::optional<HairCandidates> candidates_;
  std::vector<Decision> guesses_;
  std::size_t found_ = 0;  ///< Triangles.
};

}  // namespace coif::cook
