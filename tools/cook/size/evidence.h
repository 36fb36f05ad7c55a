#pragma once

#include "cook/size/measured_model.h"
#include "import/source_model.h"

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace coif::cook {

struct HairRecipe;

/// A length of a model, and its usual range.
struct SizeEvidence {
  const char* what;        ///< "the head's radius".
  double metres;           ///< In the imported model.
  double low, high;        ///< Metres; the usual range, in which nothing is against it.
  double weight;           ///< Reliability, 0..1.
  bool of_person = false;  ///< Belongs to the person who wears the hair: all of these together count as one.
  double spread = 1;       ///< Spread of its logarithm outside the usual range, relative to that of dolls and giants.
};

/// Lengths of a model with Y up: head, body, skeleton, hair and the width of its strips, as far as it has them.
[[nodiscard]] std::vector<SizeEvidence> measure_model(const KnownModel& known, const HairRecipe& recipe);

/// Logarithm of the likelihood of all lengths after multiplication with `factor`: 0 where each is usual, else less.
/// Between people and dolls or giants it falls like a normal distribution of the logarithm, down to a floor.
[[nodiscard]] double size_likelihood(std::span<const SizeEvidence> evidence, double factor);

/// Directions of a model that may be up: first the one that it was imported with.
inline constexpr std::size_t kUps = 6;
[[nodiscard]] Eigen::Vector3d up_direction(std::size_t up);

/// The shortest rotation that takes that direction to Y.
[[nodiscard]] Eigen::Matrix3d y_up_from_direction(std::size_t up);

/// Evidence of a model for each direction: logarithms of likelihoods, at most 0.
struct UpEvidence {
  const char* what;  ///< "the head is above the hips".
  std::array<double, kUps> likelihood{};
};

[[nodiscard]] std::vector<UpEvidence> weigh_ups(const KnownModel& known);

/// A unit that a model may be in, and the logarithm of how likely that is before the model is looked at; 0 for the
/// file's own.
struct UnitPrior {
  double factor = 1;  ///< For the imported lengths.
  double likelihood = 0;
};

/// First the file's own unit, or metres if it has none; then units that files have by mistake: powers of ten of it,
/// inches and feet. The file's unit counts more, the less likely it is a mere default. From high to low: units that the
/// format defines, units that somebody chose, the value that every exporter writes, the output of a converter without
/// units. A file without a unit may be in the unit of the head on which its strands grew: the one, to two digits, with
/// which their scalp has the usual size. `scalp_radius`: of these strands, as imported; 0: not known.
[[nodiscard]] std::vector<UnitPrior> unit_priors(const importer::SourceModel& model, const HairRecipe& recipe,
                                                 double scalp_radius);

/// The priors of each direction of up_direction().
[[nodiscard]] std::array<double, kUps> up_priors(const importer::SourceModel& model);

}  // namespace coif::cook
