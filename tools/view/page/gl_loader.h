#pragma once

#include <coif/renderer.h>

namespace coif::view {

/// Finds Emscripten's OpenGL ES functions that the renderer and its shadows call. By name from a list, because its own
/// search links every function that there is.
[[nodiscard]] GlLoader web_gl_loader();

}  // namespace coif::view
