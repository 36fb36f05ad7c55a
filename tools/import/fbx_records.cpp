#include "import/fbx_records.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <vector>

namespace coif {
namespace {

using Visit = std::function<bool(const FbxRecord&)>;

constexpr std::size_t kMostFbxDepth = 64;
constexpr std::string_view kBinaryStart = "Kaydara FBX Binary";
constexpr std::size_t kVersionAt = 23;
constexpr std::uint32_t kFirstWideVersion = 7500;

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

/// A binary FBX: each record says where it ends, and its parts are checked against that.
class BinaryFbx {
 public:
  BinaryFbx(std::string_view file, const Visit& visit) : file_(file), visit_(visit) {}

  bool walk() {
    at_ = kVersionAt;
    std::uint32_t version = 0;
    if (!read(version)) return false;
    is_wide_ = version >= kFirstWideVersion;
    std::vector<std::size_t> ends{file_.size()};
    // A record of zeros ends a list of records. What follows the outermost list is no record.
    while (at_ < ends.back() || ends.size() > 1) {
      if (at_ == ends.back()) {
        ends.pop_back();
        continue;
      }
      Head head;
      if (!read_head(head, ends.back())) return false;
      if (head.end == 0) {
        if (ends.size() == 1) return true;
        at_ = ends.back();
        continue;
      }
      if (!read_values(head)) return false;
      const bool enters = visit_({head.name, unsigned(ends.size() - 1), values_.all()});
      if (!enters) {
        at_ = head.end;
      } else if (ends.size() == kMostFbxDepth) {
        return false;
      } else {
        ends.push_back(head.end);
      }
    }
    return true;
  }

 private:
  struct Head {
    std::size_t end = 0;  // 0: of a record of zeros
    std::uint64_t value_count = 0;
    std::size_t values_end = 0;
    std::string_view name;
  };

  template <class Number>
  bool read(Number& out) {
    if (file_.size() - at_ < sizeof out) return false;
    std::memcpy(&out, file_.data() + at_, sizeof out);
    at_ += sizeof out;
    return true;
  }

  bool read_size(std::uint64_t& out) {
    if (is_wide_) return read(out);
    std::uint32_t narrow = 0;
    const bool is_there = read(narrow);
    out = narrow;
    return is_there;
  }

  bool take(std::uint64_t size, std::string_view& out) {
    if (size > file_.size() - at_) return false;
    out = file_.substr(at_, std::size_t(size));
    at_ += std::size_t(size);
    return true;
  }

  bool read_head(Head& head, std::size_t list_end) {
    std::uint64_t end = 0, values_size = 0;
    std::uint8_t name_size = 0;
    if (!read_size(end) || !read_size(head.value_count) || !read_size(values_size) || !read(name_size)) return false;
    if (end == 0) return true;
    if (!take(name_size, head.name) || end > list_end || end < at_ || values_size > end - at_) return false;
    head.end = std::size_t(end);
    head.values_end = at_ + std::size_t(values_size);
    return true;
  }

  bool read_values(const Head& head) {
    values_.clear();
    for (std::uint64_t i = 0; i < head.value_count && !values_.is_full(); ++i) {
      if (!read_value() || at_ > head.values_end) return false;
    }
    at_ = head.values_end;
    return true;
  }

  template <class Number>
  bool add_number() {
    Number number{};
    if (!read(number)) return false;
    values_.add(fbx_number(number));
    return true;
  }

  bool add_text() {
    std::uint32_t size = 0;
    FbxValue value;
    if (!read(size) || !take(size, value.text)) return false;
    values_.add(value);
    return true;
  }

  bool add_array(char type) {
    std::uint32_t count = 0, encoding = 0, size = 0;
    FbxValue value{FbxValue::Kind::kArray, {}};
    if (!read(count) || !read(encoding) || !read(size) || !take(size, value.text)) return false;
    if (type != 'd' || encoding != 0 || size != count * std::uint64_t{sizeof(double)}) value.text = {};
    values_.add(value);
    return true;
  }

  bool read_value() {
    char type = 0;
    if (!read(type)) return false;
    switch (type) {
      case 'B':
      case 'C': return add_number<std::uint8_t>();
      case 'Y': return add_number<std::int16_t>();
      case 'I': return add_number<std::int32_t>();
      case 'L': return add_number<std::int64_t>();
      case 'F': return add_number<float>();
      case 'D': return add_number<double>();
      case 'S':
      case 'R': return add_text();
      case 'b':
      case 'c':
      case 'i':
      case 'l':
      case 'f':
      case 'd': return add_array(type);
      default: return false;
    }
  }

  std::string_view file_;
  const Visit& visit_;
  std::size_t at_ = 0;
  bool is_wide_ = false;
  FbxValues values_;
};

/// An FBX as text: `Name: value, value {` records `}`. A record is complete where the next name or a brace begins.
class TextFbx {
 public:
  TextFbx(std::string_view file, const Visit& visit) : file_(file), visit_(visit) {}

  bool walk() {
    bool had_record = false;
    while (skip_blanks()) {
      const char next = file_[at_];
      bool is_fine = true;
      if (next == ',') {
        ++at_;
      } else if (next == '{') {
        is_fine = open();
      } else if (next == '}') {
        is_fine = close();
      } else if (next == '"') {
        is_fine = quoted();
      } else {
        is_fine = word();
      }
      if (!is_fine) return false;
      had_record = had_record || has_name_;
    }
    finish();
    return had_record && depth_ == 0;
  }

 private:
  static bool is_blank(char letter) { return letter == ' ' || letter == '\t' || letter == '\r' || letter == '\n'; }

  /// Whether anything follows. A comment goes to the end of its line.
  bool skip_blanks() {
    while (at_ < file_.size()) {
      if (file_[at_] == ';') {
        at_ = std::min(file_.find('\n', at_), file_.size());
      } else if (is_blank(file_[at_])) {
        ++at_;
      } else {
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] bool is_visited() const { return depth_ <= deepest_; }

  /// Hands out the record that is complete now.
  void finish() {
    if (has_name_ && is_visited()) deepest_ = visit_({name_, unsigned(depth_), values_.all()}) ? depth_ + 1 : depth_;
    has_name_ = false;
  }

  bool open() {
    if (!has_name_ || depth_ + 1 == kMostFbxDepth) return false;
    finish();
    ++depth_;
    ++at_;
    return true;
  }

  bool close() {
    finish();
    if (depth_ == 0) return false;
    --depth_;
    deepest_ = std::min(deepest_, depth_);
    ++at_;
    return true;
  }

  bool quoted() {
    const std::size_t end = file_.find('"', at_ + 1);
    if (!has_name_ || end == std::string_view::npos) return false;
    values_.add({FbxValue::Kind::kText, file_.substr(at_ + 1, end - at_ - 1)});
    at_ = end + 1;
    return true;
  }

  bool word() {
    const std::size_t end = std::min(file_.find_first_of(" \t\r\n{},:;\"", at_), file_.size());
    const std::string_view text = file_.substr(at_, end - at_);
    at_ = end;
    if (at_ < file_.size() && file_[at_] == ':') {
      if (text.empty()) return false;
      ++at_;
      finish();
      name_ = text;
      has_name_ = true;
      values_.clear();
      return true;
    }
    if (has_name_ && is_visited() && !values_.is_full()) values_.add(value_of(text));
    return has_name_;
  }

  static FbxValue value_of(std::string_view text) {
    const char* const end = text.data() + text.size();
    std::int64_t whole = 0;
    if (const auto [stop, fault] = std::from_chars(text.data(), end, whole); stop == end && fault == std::errc{}) return fbx_number(whole);
    std::uint64_t large = 0;
    if (const auto [stop, fault] = std::from_chars(text.data(), end, large); stop == end && fault == std::errc{}) return fbx_number(large);
    double number = 0;
    if (const auto [stop, fault] = std::from_chars(text.data(), end, number); stop == end && fault == std::errc{}) return fbx_number(number);
    return {FbxValue::Kind::kText, text};
  }

  std::string_view file_;
  const Visit& visit_;
  std::size_t at_ = 0;
  std::size_t depth_ = 0;
  std::size_t deepest_ = 0;  // of the records that `visit_` wants now
  std::string_view name_;
  bool has_name_ = false;
  FbxValues values_;
};

}  // namespace

bool walk_fbx(std::string_view file, const Visit& visit) {
  static_assert(std::endian::native == std::endian::little, "binary FBX is little-endian");
  return file.starts_with(kBinaryStart) ? file.size() >= kVersionAt && BinaryFbx(file, visit).walk() : TextFbx(file, visit).walk();
}

}  // namespace coif
