#include "gl/passes.h"

#include <hair_shaders.h>

namespace coif {
namespace {

constexpr FragmentCode kBayerCode = {.id = 9,
                                     .keep = kShaderKeepBayerGlsl,
                                     .output = kShaderHairOutputGlsl,
                                     .shared = kShaderBayerSquareGlsl,
                                     .thins = true};

}  // namespace

const TransparencyMode kBayerMode = {"bayer", plan_thinned<kBayerCode>};

}  // namespace coif
