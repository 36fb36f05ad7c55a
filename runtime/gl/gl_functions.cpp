#include "gl/gl_functions.h"

namespace coif {

const char* load_gl_functions(const GlLoader& loader, GlFunctions& functions) {
#define COIF_GL_LOAD(name)                                                                               \
  functions.name = reinterpret_cast<decltype(functions.name)>(loader.get_proc("gl" #name, loader.user)); \
  if (functions.name == nullptr) return "gl" #name;
  COIF_GL_FUNCTIONS(COIF_GL_LOAD)
#undef COIF_GL_LOAD
  return nullptr;
}

void clear_errors(const GlFunctions& gl) {
  // A lost context may report an error for ever; there are fewer kinds than this.
  for (int i = 0; i < 16 && gl.GetError() != GL_NO_ERROR; ++i) {
  }
}

}  // namespace coif
