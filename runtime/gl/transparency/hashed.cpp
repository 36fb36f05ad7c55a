#include "gl/transparency_mode.h"

#include <hair_shaders.h>

namespace coif {
namespace {

constexpr FragmentCode kHashedCode = {.id = 3,
                                      .keep = kShaderKeepHashedGlsl,
                                      .output = kShaderHairOutputGlsl,
                                      .vertex = "#define COIF_REST_PLACE\n",
                                      .thins = true};

PassList plan(const MaterialRecord& material, const AlphaRange& texture) {
  PassList drawn;
  drawn.add_for(drawn_alpha(material, texture), thinned_pass(material, kHashedCode));
  return drawn;
}

}  // namespace

const TransparencyMode kHashedMode = {"hashed", plan};

}  // namespace coif
