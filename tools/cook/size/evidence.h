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

/// One length of a model beside what it usually is.
struct SizeEvidence {
  const char* what;        ///< "the head's radius".
  double metres;           ///< In the model as it was imported.
  double low, high;        ///< Between these nothing is said against it. Metres.
  double weight;           ///< How far it is to be relied on, 0..1.
  bool of_person = false;  ///< Of the one who wears the hair: all of these together count as one.
  double spread = 1;       ///< Of its logarithm outside of what is usual, against that of dolls and giants.
};

/// Of a model with Y up: head, body, skeleton, hair and the width of its strips, as far as it has them.
[[nodiscard]] std::vector<SizeEvidence> measure_model(const KnownModel& known, const HairRecipe& recipe);

/// Logarithm of how likely all lengths are, multiplied with `factor`: 0 where each is a usual one, else less. Between
/// the lengths of people and those of dolls and giants it falls as a normal distribution of their logarithms, to a
/// floor.
[[nodiscard]] double size_likelihood(std::span<const SizeEvidence> evidence, double factor);

/// Directions of a model that may be up: first the one that it was imported with.
inline constexpr std::size_t kUps = 6;
[[nodiscard]] Eigen::Vector3d up_direction(std::size_t up);

/// What takes that direction to Y the shortest way.
[[nodiscard]] Eigen::Matrix3d y_up_from_direction(std::size_t up);

/// How a model speaks for each direction: logarithms of likelihoods, 0 at most.
struct UpEvidence {
  const char* what;  ///< "the head is above the hips".
  std::array<double, kUps> likelihood{};
};

[[nodiscard]] std::vector<UpEvidence> weigh_ups(const KnownModel& known);

/// A unit that a model may be in, and the logarithm of how likely that is before the model is looked at; 0 for the
/// file's own.
struct UnitPrior {
  double factor = 1;  ///< For the lengths as they were imported.
  double likelihood = 0;
};

/// First the file's own unit, or metres where it has none, then those that files are in by mistake: powers of ten of
/// it, inches and feet. A file's word counts the more the less it could be there by itself: the format's definition, a
/// unit that somebody chose, the value that every exporter writes, the output of a converter that knows no units. A
/// file without a unit may be in one of its own, that of the head that its strands grew on: the one that makes their
/// scalp a usual one, to two digits. `scalp_radius`: of these, as it was imported; 0: not known.
[[nodiscard]] std::vector<UnitPrior> unit_priors(const importer::SourceModel& model, const HairRecipe& recipe,
                                                 double scalp_radius);

/// The same for each direction of up_direction().
[[nodiscard]] std::array<double, kUps> up_priors(const importer::SourceModel& model);

}  // namespace coif::cook
