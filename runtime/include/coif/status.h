#pragma once

#include <coif/export.h>

#include <cstdint>

namespace coif {

/// Result of a runtime call. Unless a call says otherwise, any value but kOk leaves the state and all outputs as they
/// were.
enum class [[nodiscard]] Status : std::uint8_t{
    kOk = 0,
    kBadTimeStep,     ///< dt is not a number, below zero or infinite.
    kBadPose,         ///< A pose has a NaN, an infinity or a rotation that is not a unit quaternion.
    kBadArgument,     ///< Another argument is not finite or outside its documented range.
    kBadIndex,        ///< No such instance or bone.
    kMemoryTooSmall,  ///< The memory given is smaller than memory_need() says, or not aligned.
    kNotCreated,      ///< The object has not been created, or its creation failed.
    kAssetLacksData,  ///< The asset has no chunk that this call needs (for example no mesh to draw).
    kSizeMismatch,    ///< Spans that belong together have different sizes.
    kDriver,          ///< OpenGL ES refused: function missing, shader not compiled, out of memory.
    kForeignState,    ///< The saved state is that of another asset, solver or number of heads, or of another version.
    kDamagedState,    ///< The bytes are not a saved state, or were changed or cut after it was saved.
    kNotAsked,        ///< The hair was created without what this call needs: see HairDesc.
    kBadScale,  ///< HeadPose::scale is outside kSmallestScale..kLargestScale; a scale of 0 was probably never set.
};

/// One sentence, static storage, never null.
[[nodiscard]] COIF_API const char* describe(Status status);

}  // namespace coif
