#include "gl/fragment_code.h"

#include <hair_shaders.h>

namespace coif {

const FragmentCode kRangeCode = {0, kShaderKeepRangeGlsl, kShaderHairOutputGlsl};

}  // namespace coif
