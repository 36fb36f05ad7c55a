#pragma once

#include "gl/gl_functions.h"

#include <cstddef>
#include <span>

namespace coif {

inline constexpr std::size_t kMaxPieces = 32;

/// Compiles and links a program from pieces of GLSL ES 3.00, at most kMaxPieces for each shader, without their #version
/// line. Returns 0 on failure, with the driver's log in `log`, always ended by a zero byte.
GLuint build_program(const GlFunctions& gl, std::span<const char* const> vertex, std::span<const char* const> fragment,
                     std::span<char> log);

}  // namespace coif
