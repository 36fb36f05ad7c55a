#pragma once

#include <coif/export.h>

#include <cstddef>
#include <cstdint>

namespace coif {

/// Why a file was refused. The order is the order of the checks.
enum class LoadCode : std::uint8_t {
  kOk = 0,
  kTooSmall,        ///< Shorter than the header.
  kMisaligned,      ///< The caller's memory does not start at a multiple of 16 (64 where texels are used).
  kMagic,           ///< Not a cooked hair asset.
  kMajorVersion,    ///< Cooked for another major version of the format.
  kSize,            ///< The header's size is not the size of the bytes given: truncated or extended.
  kChunkCount,      ///< More chunks than the format allows, or than the file can hold.
  kHash,            ///< Bytes were changed after cooking: in the chunk named, else in the header or the table.
  kChunkRange,      ///< A chunk lies outside the file, overlaps another or is not aligned.
  kChunkDuplicate,  ///< The same chunk twice.
  kChunkUnknown,    ///< A chunk that must be understood is not known to this version.
  kChunkMissing,    ///< A chunk that another needs is absent.
  kChunkSize,       ///< A chunk's size does not fit its records or the count declared elsewhere.
  kReserved,        ///< A reserved field is not zero.
  kNotFinite,       ///< A number is NaN, infinite or outside its range.
  kEnumerator,      ///< An enumerator has a value that this version does not know.
  kReference,       ///< An index points outside the array it refers to.
  kBoneOrder,       ///< Head first, then scalp, then simulated, parents before children: broken.
  kBoneJoint,       ///< A bone does not start where its simulated parent ends.
  kColliderSet,     ///< A bone's set names a collider that does not exist, or belongs to a rigid bone.
  kChainCover,      ///< Chains do not cover the simulated bones exactly once.
  kOpenBones,       ///< A chain's order keeps more bones open, waiting for children, than a solver has room for.
  kPatchCover,      ///< Patches do not cover the index list exactly once, in order.
  kLodCover,        ///< Levels of detail do not cover the patches exactly once, in order.
  kLodOrder,        ///< Screen sizes do not fall to 0 from level to level, or errors do not grow from 0.
  kLodBones,        ///< A bone is simulated in levels where it cannot be, or not in level 0.
  kOrderCover,      ///< A draw order does not have every triangle of a level of detail exactly once.
  kWeightSum,       ///< Skin weights of a vertex do not add up to one.
  kName,            ///< Names do not end with a zero byte.
  kLinkOrder,       ///< Links are not trees between bones of equal depth in different chains, by depth.
};

/// The result of opening an asset; carries its own evidence.
struct [[nodiscard]] LoadStatus {
  LoadCode code = LoadCode::kOk;
  std::uint32_t chunk = 0;     ///< Chunk id where it applies, else 0.
  std::uint64_t item = 0;      ///< Index of the offending record, or of the byte.
  std::uint64_t expected = 0;  ///< What the check wanted, where it is a number.
  std::uint64_t found = 0;     ///< What the file has.

  explicit operator bool() const { return code == LoadCode::kOk; }
};

/// One sentence, static storage, never null.
[[nodiscard]] COIF_API const char* describe(LoadCode code);

/// Writes "chunk BONE, record 7: ... (expected 3, found 9)" into `text`, always ended by a zero byte, cut where
/// `capacity` is too small. Returns the length written.
COIF_API std::size_t describe(const LoadStatus& status, char* text, std::size_t capacity);

}  // namespace coif
