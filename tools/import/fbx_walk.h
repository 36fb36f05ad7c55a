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
  /// A text; or the bytes of a binary file's array of unpacked doubles; else empty.
  std::string_view text;
  double number = 0;       ///< A number's value.
  std::int64_t whole = 0;  ///< The value of an integer, for example an object's id.
};

/// Most values of a record that are kept; further ones are skipped.
inline constexpr std::size_t kMostFbxValues = 8;

struct FbxRecord {
  std::string_view name;
  unsigned depth = 0;                ///< 0: "Objects", "Connections" and their like.
  std::span<const FbxValue> values;  ///< The first ones, at most kMostFbxValues.
};

/// Calls `visit` for each record in the file's order. A record comes before its children, which follow only where
/// `visit` returns true; in a binary file the others are skipped. Returns false where the file is not an FBX, is cut
/// off or damaged; `visit` may have been called before. Takes time in proportion to the file and next to no memory, and
/// is not recursive. Reads binary files of all versions (64-bit sizes from 7500 on) and text; records may be nested 64
/// deep.
[[nodiscard]] bool walk_fbx(std::string_view file, const std::function<bool(const FbxRecord&)>& visit);

// Shared by the readers of both encodings of an FBX.

using FbxVisit = std::function<bool(const FbxRecord&)>;

inline constexpr std::size_t kMostFbxDepth = 64;

/// Collects the values of one record.
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
