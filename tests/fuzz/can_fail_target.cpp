#include "fuzz/promise.h"
#include "fuzz/targets.h"

namespace coif::fuzz {

bool try_can_fail(Input input) {
  promise(input.empty() || input[0] != '!', "no input begins with an exclamation mark");
  return true;
}

}  // namespace coif::fuzz
