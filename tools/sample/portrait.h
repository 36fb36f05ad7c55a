#pragma once

#include <cstddef>
#include <vector>

namespace coif::sample {

/// A bust with a face to show hair on: skin, eyes, lashes and a shirt with their colours, on a head, a neck and a root that hair
/// may hang from. The bytes of a glTF 2.0 binary, the same on every run; see portrait_head.h for its measures.
[[nodiscard]] std::vector<std::byte> make_portrait();

}  // namespace coif::sample
