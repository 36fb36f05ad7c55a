#include "gl/transparency/covered.h"

#include <hair_shaders.h>

namespace coif {
namespace {

constexpr FragmentCode kProportionalCode = {
    .id = 10, .keep = kShaderKeepProportionalGlsl, .output = kShaderCoverageOutputGlsl, .thins = true};

}  // namespace

const TransparencyMode kProportionalMode = {"proportional", plan_counted<kProportionalCode>, draw_counted};

}  // namespace coif
