#pragma once

#include "base/tool_error.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <span>

namespace coif::render {

/// A program of whole shaders, the fragment shader's in pieces, freed with the current OpenGL context. kUnsupported
/// with the driver's log where it refuses.
tl::expected<std::uint32_t, ToolError> build_gl_program(const char* vertex, std::span<const char* const> fragment);

}  // namespace coif::render
