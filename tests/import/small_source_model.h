#pragma once

#include "import/source_model.h"

namespace coif::test {

/// A triangle on two nodes that uses every field of a model and keeps all of its promises.
[[nodiscard]] SourceModel small_source_model();

}  // namespace coif::test
