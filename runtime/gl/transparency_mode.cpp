#include "gl/transparency_mode.h"

namespace coif {

const char* name_of(const TransparencyMode& transparency) { return transparency.name; }

}  // namespace coif
