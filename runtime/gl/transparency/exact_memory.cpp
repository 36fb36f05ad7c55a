#include "gl/transparency/exact_memory.h"

#include <cstdio>
#include <new>

namespace coif {
namespace {

ExactMemory& memory_in(ModeMemory& memory) { return *std::launder(reinterpret_cast<ExactMemory*>(memory.bytes)); }

void release_all(const GlFunctions& gl, ModeMemory& memory) {
  ExactMemory& exact = memory_in(memory);
  release(gl, exact.lists);
  release(gl, exact.functions, exact.peel);
}

const char* load(const GlLoader& loader, ExactFunctions& functions) {
#define COIF_GL_LOAD(name)                                                                               \
  functions.name = reinterpret_cast<decltype(functions.name)>(loader.get_proc("gl" #name, loader.user)); \
  if (functions.name == nullptr) return "gl" #name;
  COIF_EXACT_FUNCTIONS(COIF_GL_LOAD)
#undef COIF_GL_LOAD
  functions.MemoryBarrier =
      reinterpret_cast<decltype(functions.MemoryBarrier)>(loader.get_proc("glMemoryBarrier", loader.user));
  return nullptr;
}

}  // namespace

ExactMemory* exact_memory(const ModeDraw& draw) {
  static_assert(sizeof(ExactMemory) <= sizeof(ModeMemory::bytes));
  if (draw.memory.release != nullptr) return &memory_in(draw.memory);
  ExactMemory* const made = new (static_cast<void*>(draw.memory.bytes)) ExactMemory;
  if (const char* missing = load(draw.loader, made->functions)) {
    std::snprintf(draw.failure.data(), draw.failure.size(), "%s is missing; OpenGL ES 3.0 is needed", missing);
    return nullptr;
  }
  draw.memory.release = release_all;
  return made;
}

}  // namespace coif
