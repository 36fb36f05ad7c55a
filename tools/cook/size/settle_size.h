#pragma once

// Files are often wrong about their unit and about which axis is up, without their authors' knowledge. All signs in a
// model decide here; the file's own statement is one vote.

#include "cook/recipe/findings.h"
#include "cook/size/measured_model.h"
#include "import/source_model.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace coif::cook {

struct HairRecipe;

/// Something that an artist should look at, one sentence.
struct SizeDoubt {
  enum class Of {
    kOtherUnit,     ///< The file's unit lost.
    kDoubtfulUnit,  ///< The file's or the caller's unit is kept against much evidence.
    kOtherUp,       ///< The file's up axis lost.
    kDoubtfulUp,    ///< The file's or the caller's axis is kept against much evidence.
  } of;
  std::string text;
};

/// The code in the table of issues.
[[nodiscard]] const char* code_of(SizeDoubt::Of of);

/// A model's own size and attitude.
struct JudgedSize {
  double factor = 1;                                       ///< For the model's lengths.
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  ///< For the model's directions.
  std::vector<SizeDoubt> doubts = {};
  std::vector<Decision> decisions = {};   ///< "size" and "up", unless the caller decides.
  std::optional<SelectedHair> hair = {};  ///< The hair of the original model, if it was looked for in that form.

  [[nodiscard]] bool changes() const { return factor != 1 || !rotation.isIdentity(); }
};

/// Compares the file's statement (SourceModel::space) with head, body, named joints, hair and strips. It holds unless
/// the model's evidence is clearly against it and clearly for another common unit or axis; values from the caller
/// always hold. Without anything known to be hair only the body is looked at.
[[nodiscard]] JudgedSize judge_size(const importer::SourceModel& source, const HairRecipe& recipe);

/// The model with that applied.
[[nodiscard]] importer::SourceModel settled(importer::SourceModel source, const JudgedSize& size);

struct SettledSource {
  std::optional<importer::SourceModel> model;  ///< The corrected model; none if the source is right.
  /// The result of select_hair() on a model that is right, if it is known already.
  std::optional<SelectedHair> hair = {};
};

/// Judges a model and applies the result. Appends messages.
[[nodiscard]] SettledSource settle_size(const importer::SourceModel& source, const HairRecipe& recipe,
                                        Findings& findings);

}  // namespace coif::cook
