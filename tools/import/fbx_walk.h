#pragma once
// The records of an FBX file, binary or as text, one after the other. Nothing is stored and no array is unpacked.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <type_traits>

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

// What walks of both encodings of an FBX share.

using FbxVisit = std::function<bool(const FbxRecord&)>;

inline constexpr std::size_t kMostFbxDepth = 64;

/// The values of one record as they are found.
class FbxValues {
 public:
  void clear() { count_ = 0; }
  void add(const FbxValue& value) {
    if (!is_full()) values_[count_++] = value;
  }
  [[nodiscard]] bool is_full() const { return count_ == values_.size(); }
  [[nodiscard]] std::span<const FbxValue> all() const { return std::span(values_).first(count_); }

 private:
  std::array<FbxValue, kMostFbxValues> values_;
  std::size_t count_ = 0;
};

template <class Number>
FbxValue fbx_number(Number number) {
  if constexpr (std::is_floating_point_v<Number>) {
    const bool fits = std::abs(number) < Number(9e18);  // false for NaN
    return {FbxValue::Kind::kNumber, {}, double(number), fits ? std::int64_t(number) : 0};
  } else {
    return {FbxValue::Kind::kNumber, {}, double(number), std::int64_t(number)};
  }
}

/// walk_fbx() of a text.
[[nodiscard]] bool walk_text_fbx(std::string_view file, const FbxVisit& visit);

}  // namespace coif::importer
