#include "gl/passes.h"

#include <hair_shaders.h>

namespace coif {
namespace {

constexpr FragmentCode kHashedCode = {.id = 3,
                                      .keep = kShaderKeepHashedGlsl,
                                      .output = kShaderHairOutputGlsl,
                                      .vertex = "#define COIF_REST_PLACE\n",
                                      .thins = true};

}  // namespace

const TransparencyMode kHashedMode = {"hashed", plan_thinned<kHashedCode>};

}  // namespace coif
