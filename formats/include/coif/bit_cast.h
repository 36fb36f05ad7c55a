#pragma once
// std::bit_cast, also where the standard library is older than the compiler, as Emscripten's of Debian 12 is.

#include <bit>

namespace coif {

#ifdef __cpp_lib_bit_cast
using std::bit_cast;
#else
template <typename To, typename From>
constexpr To bit_cast(const From& from) {
  return __builtin_bit_cast(To, from);
}
#endif

}  // namespace coif
