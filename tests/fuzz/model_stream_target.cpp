#include "fuzz/promise.h"
#include "fuzz/targets.h"

#include "import/model_stream.h"
#include "import/source_model.h"

#include <algorithm>

namespace coif::fuzz {

bool try_model_stream(Input input) {
  ImportOutcome outcome = tl::unexpected(ToolError{ToolError::Kind::kInternal, "untouched"});
  if (!decode_outcome(input, outcome)) {
    promise(!outcome && outcome.error().message == "untouched", "a refusal leaves the outcome untouched");
    return false;
  }
  promise(!outcome || find_model_fault(*outcome).empty(), "a model that was accepted has no fault");
  promise(std::ranges::equal(encode_outcome(outcome), input), "what was accepted is encoded to the same bytes");
  return true;
}

}  // namespace coif::fuzz
