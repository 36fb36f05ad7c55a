// One target as a program of libFuzzer; COIF_FUZZ_TARGET is the function's name.

#include "fuzz/targets.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  coif::fuzz::COIF_FUZZ_TARGET({data, size});
  return 0;
}
