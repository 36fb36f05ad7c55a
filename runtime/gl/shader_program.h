#pragma once

#include "gl/gl_functions.h"

#include <cstddef>
#include <span>

namespace coif {

inline constexpr std::size_t kMaxPieces = 32;

inline constexpr char kGlsl300[] = "#version 300 es\n";
inline constexpr char kGlsl310[] = "#version 310 es\n";  ///< For OpenGL ES 3.1: storage buffers.

/// Compiles and links a program from pieces of GLSL ES, at most kMaxPieces for each shader, without their #version
/// line. Returns 0 on failure, with the driver's log in `log`, always ended by a zero byte.
GLuint build_program(const GlFunctions& gl, const char* version, std::span<const char* const> vertex,
                     std::span<const char* const> fragment, std::span<char> log);

}  // namespace coif
