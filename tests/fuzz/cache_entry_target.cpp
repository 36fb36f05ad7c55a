#include "fuzz/promise.h"
#include "fuzz/targets.h"

#include "cache/cook_cache.h"

namespace coif::fuzz {

bool try_cache_entry(Input input) {
  const auto entry = decode_entry(std::as_bytes(input));
  if (!entry) return false;
  const auto bytes = encode_entry(*entry);
  const auto again = decode_entry(bytes);
  promise(again.has_value(), "an entry that was read can be written and read");
  promise(encode_entry(*again) == bytes, "an entry comes back as it was");
  return true;
}

}  // namespace coif::fuzz
