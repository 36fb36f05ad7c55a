#include "bench/machine_peak.h"

#include "bench/frame_times.h"

#include <algorithm>
#include <cstdlib>

#if defined(__x86_64__)
#define COIF_FOR_AVX2 [[gnu::target("avx2")]]
#define COIF_FOR_AVX512 [[gnu::target("avx512f")]]
#else
#define COIF_FOR_AVX2
#define COIF_FOR_AVX512
#endif

namespace coif {
namespace {

using Float4 [[gnu::vector_size(16)]] = float;
using Float8 [[gnu::vector_size(32)]] = float;
using Float16 [[gnu::vector_size(64)]] = float;

constexpr int kRuns = 60;
constexpr int kChains = 6;     // of each kind; more than latency times ports, and few enough for 16 registers
constexpr int kRounds = 2000;  // a run is some microseconds long

/// Most operations per nanosecond that any run of `kernel`, of `operations`, reached.
template <class Kernel>
double best_rate(double operations, const Kernel& kernel) {
  Stopwatch watch;
  double best = 0;
  for (int run = 0; run < kRuns; ++run) {
    watch.start();
    kernel();
    best = std::max(best, operations / std::max(1.0, watch.seconds() * 1e9));
  }
  return best;
}

/// Keeps the compiler from computing in advance, or not at all, what `value` holds.
template <class Vector>
[[gnu::always_inline]] inline void pin(Vector& value) {
#if defined(__x86_64__)
  asm volatile("" : "+v"(value));
#else
  asm volatile("" : "+m"(value));
#endif
}

template <class Vector>
[[gnu::always_inline]] inline void multiply_and_add() {
  Vector factor = Vector{} + 0.999999f, term = Vector{} + 1e-6f, products[kChains], sums[kChains];
  for (int i = 0; i < kChains; ++i) products[i] = sums[i] = Vector{} + 1.0f;
  for (int round = 0; round < kRounds; ++round) {
    for (int i = 0; i < kChains; ++i) products[i] = products[i] * factor, sums[i] = sums[i] + term;
    pin(factor);
  }
  for (int i = 0; i < kChains; ++i) pin(products[i]), pin(sums[i]);
}

template <class Vector>
[[gnu::always_inline]] inline void divide() {
  Vector divisor = Vector{} + 1.000001f, quotients[kChains];
  for (int i = 0; i < kChains; ++i) quotients[i] = Vector{} + 1.0f;
  for (int round = 0; round < kRounds; ++round) {
    for (int i = 0; i < kChains; ++i) quotients[i] = quotients[i] / divisor;
    pin(divisor);
  }
  for (int i = 0; i < kChains; ++i) pin(quotients[i]);
}

void multiply_and_add_4() { multiply_and_add<Float4>(); }
COIF_FOR_AVX2 void multiply_and_add_8() { multiply_and_add<Float8>(); }
COIF_FOR_AVX512 void multiply_and_add_16() { multiply_and_add<Float16>(); }
void divide_4() { divide<Float4>(); }
COIF_FOR_AVX2 void divide_8() { divide<Float8>(); }
COIF_FOR_AVX512 void divide_16() { divide<Float16>(); }

void triad(std::span<float> a, const float* b, const float* c) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = b[i] + 0.5f * c[i];
}
#if defined(__x86_64__)
COIF_FOR_AVX2 void triad_8(std::span<float> a, const float* b, const float* c) {
#pragma GCC ivdep
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = b[i] + 0.5f * c[i];
}
#endif

}  // namespace

bool has_width(VectorWidth width) {
#if defined(__x86_64__)
  if (width == VectorWidth::k8) return __builtin_cpu_supports("avx2") != 0;
  if (width == VectorWidth::k16) return __builtin_cpu_supports("avx512f") != 0;
#endif
  return width == VectorWidth::k4;
}

double peak_instructions() {
#if defined(__x86_64__)
  // Some instructions of every kind, as code has them, and none that waits for another. (Processors decode two that do
  // nothing as one.)
  static constexpr long kInstructions = 6 * 12;
  return best_rate(double(kRounds) * kInstructions, [] {
    for (int round = 0; round < kRounds; ++round) {
      asm volatile(
          ".rept 12\n add $1, %%eax\n add $1, %%ecx\n pshufd $0, %%xmm0, %%xmm1\n mov (%0), %%rdx\n add $1, %%esi\n"
          "pshufd $0, %%xmm0, %%xmm2\n .endr"
          :
          : "r"(&kInstructions)
          : "eax", "ecx", "rdx", "esi", "xmm1", "xmm2");
    }
  });
#else
  return 0;
#endif
}

double peak_arithmetic(VectorWidth width) {
  const auto kernel = width == VectorWidth::k16  ? multiply_and_add_16
                      : width == VectorWidth::k8 ? multiply_and_add_8
                                                 : multiply_and_add_4;
  return best_rate(2.0 * kChains * kRounds, kernel);
}

double peak_divisions(VectorWidth width) {
  const auto kernel = width == VectorWidth::k16 ? divide_16 : width == VectorWidth::k8 ? divide_8 : divide_4;
  return best_rate(double(kChains) * kRounds, kernel);
}

double peak_traffic(std::size_t bytes) {
  const std::size_t count = std::max<std::size_t>(64, bytes / 3 / sizeof(float) / 64 * 64);
  auto* memory = static_cast<float*>(std::aligned_alloc(64, 3 * count * sizeof(float)));
  if (memory == nullptr) return 0;
  std::fill_n(memory, 3 * count, 1.0f);
  const auto kernel = has_width(VectorWidth::k8) ? triad_8 : triad;
  // Small arrays are gone over more than once, so that a run is long enough to time.
  const std::size_t passes = 1 + (std::size_t{1} << 20) / (3 * count * sizeof(float));
  const double rate = best_rate(double(passes * 3 * count * sizeof(float)), [&] {
    for (std::size_t pass = 0; pass < passes; ++pass) {
      kernel({memory, count}, memory + count, memory + 2 * count);
      pin(memory);
    }
  });
  std::free(memory);
  return rate;
}

}  // namespace coif
