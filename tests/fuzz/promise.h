#pragma once

#include <cstdio>
#include <cstdlib>

namespace coif::fuzz {

/// Ends the process, as a crash would, where `kept` is false.
inline void promise(bool kept, const char* what) {
  if (kept) return;
  std::fprintf(stderr, "broken promise: %s\n", what);
  std::abort();
}

}  // namespace coif::fuzz
