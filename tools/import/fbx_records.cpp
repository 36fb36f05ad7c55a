#include "import/fbx_walk.h"

#include <bit>
#include <cstddef>
#include <cstring>
#include <vector>

namespace coif::importer {
namespace {

constexpr std::string_view kBinaryStart = "Kaydara FBX Binary";
constexpr std::size_t kVersionAt = 23;
constexpr std::uint32_t kFirstWideVersion = 7500;

/// A binary FBX: each record has its end, and its parts are checked against that.
class BinaryFbx {
 public:
  BinaryFbx(std::string_view file, const FbxVisit& visit) : file_(file), visit_(visit) {}

  bool walk() {
    at_ = kVersionAt;
    std::uint32_t version = 0;
    if (!read(version)) return false;
    is_wide_ = version >= kFirstWideVersion;
    std::vector<std::size_t> ends{file_.size()};
    // A record of zeros ends a list of records. Bytes after the outermost list are no record.
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
    std::size_t end = 0;  // 0 for a record of zeros.
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
  const FbxVisit& visit_;
  std::size_t at_ = 0;
  bool is_wide_ = false;
  FbxValues values_;
};

}  // namespace

bool walk_fbx(std::string_view file, const FbxVisit& visit) {
  static_assert(std::endian::native == std::endian::little, "binary FBX is little-endian");
  if (!file.starts_with(kBinaryStart)) return walk_text_fbx(file, visit);
  return file.size() >= kVersionAt && BinaryFbx(file, visit).walk();
}

}  // namespace coif::importer
