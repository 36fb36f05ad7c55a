#pragma once

// The records of an FBX file, binary or as text, one after the other. Nothing is stored and no array is unpacked.

#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

namespace coif::importer {

/// One value of a record. Texts point into the file.
struct FbxValue {
  enum class Kind : std::uint8_t { kNumber, kText, kArray };
  Kind kind = Kind::kText;
  std::string_view
      text;  ///< Of a text; of an array of a binary file that is not packed and holds doubles, its bytes; else empty.
  double number = 0;       ///< Of a number.
  std::int64_t whole = 0;  ///< Of a number that is whole, for example an object's id.
};

/// Most values of a record that are kept; those after them are passed over.
inline constexpr std::size_t kMostFbxValues = 8;

struct FbxRecord {
  std::string_view name;
  unsigned depth = 0;                ///< 0: "Objects", "Connections" and their like.
  std::span<const FbxValue> values;  ///< The first of them, kMostFbxValues at most.
};

/// Calls `visit` for each record in the file's order, a record before those within it, which follow only where `visit`
/// returns true. What a binary file holds within the others is passed over. Returns false where the file is no FBX, is
/// cut off or damaged; `visit` may have been called before. Takes time in proportion to the file and next to no memory,
/// and never calls itself. Reads binary files of all versions (64-bit sizes from 7500 on) and text; records may stand
/// 64 deep.
[[nodiscard]] bool walk_fbx(std::string_view file, const std::function<bool(const FbxRecord&)>& visit);

}  // namespace coif::importer
