#pragma once
// Functions that a maths library would give, in nothing but additions and products: libraries differ from machine to
// machine in the last bit, and the same hair has to move the same way on all of them. Used once per step or per head.

namespace coif::plain {

/// exp(x) to about 1e-15 of it; 0 below -708, the largest finite number's neighbourhood above 708.
[[nodiscard]] double exp(double x);

/// exp(x) - 1 without cancellation.
[[nodiscard]] double expm1(double x);

struct SineCosine {
  double sine, cosine;
};

/// To about 1e-15; |x| below 1e6.
[[nodiscard]] SineCosine sine_cosine(double x);

}  // namespace coif::plain
