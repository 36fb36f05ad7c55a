// The program of libFuzzer for the readers of strands alone, which need neither the runtime nor the cook and are built
// in a minute. COIF_FUZZ_TARGET in the environment names the reader that gets the bytes.

#include "fuzz/targets.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv);
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {
const coif::fuzz::Target* chosen = nullptr;
}  // namespace

int LLVMFuzzerInitialize(int*, char***) {
  const char* const name = std::getenv("COIF_FUZZ_TARGET");
  chosen = coif::fuzz::find_target(name ? name : "", "COIF_FUZZ_TARGET must name a target");
  if (!chosen) std::exit(2);
  return 0;
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  chosen->run({data, size});
  return 0;
}
