#include "vector_math.h"

#include "head_pose.h"

#include <coif/bit_cast.h>

#include <cstdint>

namespace coif {
namespace plain {
namespace {

/// Nearest whole number; |x| below 2^62.
constexpr double rounded(double x) { return double(std::int64_t(x < 0 ? x - 0.5 : x + 0.5)); }

/// sum of x^k / k! from `first` to 17, divided by x^first: for |x| up to 1 exact to the last bits.
constexpr double exponential_tail(double x, int first) {
  double sum = 0;
  for (int k = 17; k > first; --k) sum = (sum + 1) * x / k;
  double factorial = 1;
  for (int k = 2; k <= first; ++k) factorial *= k;
  return (sum + 1) / factorial;
}

}  // namespace

double exp(double x) {
  if (!(x > -708)) return 0;
  if (x > 708) x = 708;
  constexpr double kLn2High = 0.693147180369123816490, kLn2Low = 1.90821492927058770002e-10;
  const double power = rounded(x * 1.44269504088896340736);
  const double rest = (x - power * kLn2High) - power * kLn2Low;
  return exponential_tail(rest, 0) * bit_cast<double>(std::uint64_t(std::int64_t(power) + 1023) << 52);
}

double expm1(double x) { return x > -0.5 && x < 0.5 ? x * exponential_tail(x, 1) : exp(x) - 1; }

SineCosine sine_cosine(double x) {
  // pi/2 in two parts, of which the first has few enough digits for its products to be exact.
  constexpr double kHigh = 1.57079632673412561417, kLow = 6.07710050650619224932e-11;
  const double quarters = rounded(x * 0.63661977236758134308);
  const double rest = (x - quarters * kHigh) - quarters * kLow, square = rest * rest;
  double sine = 0, cosine = 0;
  for (int k = 18; k > 0; k -= 2) {
    sine = (1 - sine) * square / (k * (k + 1));
    cosine = (1 - cosine) * square / (k * (k - 1));
  }
  sine = rest * (1 - sine);
  cosine = 1 - cosine;
  switch (std::int64_t(quarters) & 3) {
    case 0: return {sine, cosine};
    case 1: return {cosine, -sine};
    case 2: return {-sine, -cosine};
    default: return {-cosine, sine};
  }
}

}  // namespace plain

bool is_unit(const Quat& rotation) { return is_one(norm(rotation)); }

Status normalise_pose(const HeadPose& pose, HeadPose& unit) { return make_unit(pose, unit); }

}  // namespace coif
