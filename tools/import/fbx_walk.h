#pragma once

// What walks of both encodings of an FBX share.

#include "import/fbx_records.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <span>
#include <string_view>
#include <type_traits>

namespace coif::importer {

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
