#include "gl/passes.h"

#include <hair_shaders.h>

namespace coif {
namespace {

constexpr FragmentCode kCheckerboardCode = {
    .id = 8, .keep = kShaderKeepCheckerboardGlsl, .output = kShaderHairOutputGlsl, .thins = true};

}  // namespace

const TransparencyMode kCheckerboardMode = {"checkerboard", plan_thinned<kCheckerboardCode>};

}  // namespace coif
