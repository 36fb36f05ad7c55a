#include "gl/transparency_mode.h"

#include <hair_shaders.h>

namespace coif {
namespace {

constexpr FragmentCode kScreenDoorCode = {.id = 2,
                                          .keep = kShaderKeepScreenDoorGlsl,
                                          .output = kShaderHairOutputGlsl,
                                          .vertex = "#define COIF_CORNER\n",
                                          .thins = true};

PassList plan(const MaterialRecord& material, const AlphaRange& texture) {
  PassList drawn;
  drawn.add_for(drawn_alpha(material, texture), thinned_pass(material, kScreenDoorCode));
  return drawn;
}

}  // namespace

const TransparencyMode kScreenDoorMode = {"screendoor", plan};

}  // namespace coif
