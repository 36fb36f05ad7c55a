#pragma once

#include "cook/size/measured_model.h"

#include <span>
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

}  // namespace coif::cook
