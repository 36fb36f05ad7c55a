#include "gl/passes.h"

#include <coif/research.h>

#include <hair_shaders.h>

namespace coif {
namespace {

constexpr FragmentCode kCheckerboardCode = {
    .id = 8, .keep = kShaderKeepCheckerboardGlsl, .output = kShaderHairOutputGlsl, .thins = true};

constexpr FragmentCode kBayerCode = {.id = 9,
                                     .keep = kShaderKeepBayerGlsl,
                                     .output = kShaderHairOutputGlsl,
                                     .shared = kShaderBayerSquareGlsl,
                                     .thins = true};

}  // namespace

const TransparencyMode kCheckerboardMode = {"checkerboard", plan_thinned<kCheckerboardCode>};

const TransparencyMode kBayerMode = {"bayer", plan_thinned<kBayerCode>};

}  // namespace coif
