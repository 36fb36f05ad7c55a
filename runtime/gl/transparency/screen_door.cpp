#include "gl/passes.h"

#include <hair_shaders.h>

namespace coif {
namespace {

constexpr FragmentCode kScreenDoorCode = {.id = 2,
                                          .keep = kShaderKeepScreenDoorGlsl,
                                          .output = kShaderHairOutputGlsl,
                                          .shared = kShaderBayerSquareGlsl,
                                          .vertex = "#define COIF_CORNER\n",
                                          .thins = true};

}  // namespace

const TransparencyMode kScreenDoorMode = {"screendoor", plan_thinned<kScreenDoorCode>};

}  // namespace coif
