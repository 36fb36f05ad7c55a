#pragma once

// Files lie about their unit and about where up is, and most do not know that they do. What is found here is decided by
// all that a model shows, of which the file's own word is one vote.

#include "cook/recipe/findings.h"
#include "cook/size/measured_model.h"
#include "import/source_model.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace coif::cook {

struct HairRecipe;

/// What an artist should look at, one sentence each.
struct SizeDoubt {
  enum class Of {
    kOtherUnit,     ///< The file's unit lost.
    kDoubtfulUnit,  ///< It holds, or the caller's does, against much.
    kOtherUp,       ///< The file's up axis lost.
    kDoubtfulUp,    ///< It holds, or the caller's does, against much.
  } of;
  std::string text;
};

/// In the table of issues.
[[nodiscard]] const char* code_of(SizeDoubt::Of of);

/// A model's own size and attitude.
struct JudgedSize {
  double factor = 1;                                       ///< For its lengths.
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  ///< For its directions.
  std::vector<SizeDoubt> doubts = {};
  std::vector<std::string> notes = {};    ///< What spoke for and against.
  std::optional<SelectedHair> hair = {};  ///< Of the model as it was, where it was looked at like that.

  [[nodiscard]] bool changes() const { return factor != 1 || !rotation.isIdentity(); }
};

/// Compares what the file says (SourceModel::space) with head, body, named joints, hair and strips. The file's word
/// holds unless what the model shows is clearly against it and clearly for another common unit or axis; what the caller
/// gave holds always. Without anything known to be hair the body alone is looked at.
[[nodiscard]] JudgedSize judge_size(const importer::SourceModel& source, const HairRecipe& recipe);

/// The model with that applied.
[[nodiscard]] importer::SourceModel settled(importer::SourceModel source, const JudgedSize& size);

struct SettledSource {
  std::optional<importer::SourceModel> model;  ///< As it is cooked; none where it is right as it is.
  std::optional<SelectedHair> hair =
      {};  ///< What select_hair() finds in a model that is right, as far as that is known already.
};

/// Judges a model and applies what comes out. Appends what is to be said.
[[nodiscard]] SettledSource settle_size(const importer::SourceModel& source, const HairRecipe& recipe,
                                        Findings& findings);

}  // namespace coif::cook
