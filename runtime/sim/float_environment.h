#pragma once
// The conditions for equal numbers everywhere: those on the compiler are checked here, those on the processor are set
// here.

#include <cfloat>

#if defined(__FAST_MATH__)
#error "coif's simulation gives the same bits on every machine, which -ffast-math does not: leave it out for coif"
#endif
#if !defined(FLT_EVAL_METHOD) || FLT_EVAL_METHOD != 0
#error "coif's simulation gives the same bits on every machine, which x87 does not: compile with -msse2 -mfpmath=sse"
#endif

#if defined(__SSE__) || defined(_M_X64)
#include <xmmintrin.h>
#elif defined(__aarch64__) || defined(_M_ARM64)
#include <cstdint>
#endif

namespace coif {

/// While it lives, numbers are rounded to nearest, subnormals are kept and nothing traps, whatever the host's thread
/// has chosen. The destructor restores that choice with its flags. Masked lanes are computed too, and may divide by
/// zero. Most threads have chosen nothing; then this costs next to nothing (writing the register takes as long as
/// setting a head), and the computation leaves its flags. Use it around calls of functions in other files: within one
/// function the compiler may move arithmetic past it.
class FloatEnvironment {
 public:
  FloatEnvironment() : host_(read()), is_plain_(has_plain_control(host_)) {
    if (!is_plain_) write(kPlain);
  }
  ~FloatEnvironment() {
    if (!is_plain_) write(host_);
  }
  FloatEnvironment(const FloatEnvironment&) = delete;
  FloatEnvironment& operator=(const FloatEnvironment&) = delete;

 private:
#if defined(__SSE__) || defined(_M_X64)
  using Word = unsigned;
  static constexpr Word kPlain = 0x1F80;  ///< MXCSR: all exceptions masked.
  static constexpr Word kFlags = 0x3F;
  static bool has_plain_control(Word word) { return (word & ~kFlags) == kPlain; }
  static Word read() { return _mm_getcsr(); }
  static void write(Word word) { _mm_setcsr(word); }
#elif defined(__aarch64__)
  struct Word {
    std::uint64_t control, flags;  ///< FPCR and FPSR.
  };
  static constexpr Word kPlain{0, 0};
  static bool has_plain_control(const Word& word) { return word.control == 0; }
  static Word read() {
    Word word;
    __asm__ volatile("mrs %0, fpcr\n\tmrs %1, fpsr" : "=r"(word.control), "=r"(word.flags));
    return word;
  }
  static void write(const Word& word) {
    __asm__ volatile("msr fpcr, %0\n\tmsr fpsr, %1" : : "r"(word.control), "r"(word.flags) : "memory");
  }
#else
  using Word = int;  // A processor without such settings.
  static constexpr Word kPlain = 0;
  static bool has_plain_control(Word) { return true; }
  static Word read() { return 0; }
  static void write(Word) {}
#endif
  Word host_;
  bool is_plain_;
};

}  // namespace coif
