#include "import/fbx_walk.h"

#include <algorithm>
#include <charconv>
#include <cstdint>

namespace coif::importer {
namespace {

/// An FBX as text: `Name: value, value {` records `}`. A record is complete where the next name or a brace begins.
class TextFbx {
 public:
  TextFbx(std::string_view file, const FbxVisit& visit) : file_(file), visit_(visit) {}

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

  /// Returns whether more text follows. A comment goes to the end of its line.
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
    if (const auto [stop, fault] = std::from_chars(text.data(), end, whole); stop == end && fault == std::errc{})
      return fbx_number(whole);
    std::uint64_t large = 0;
    if (const auto [stop, fault] = std::from_chars(text.data(), end, large); stop == end && fault == std::errc{})
      return fbx_number(large);
    double number = 0;
    if (const auto [stop, fault] = std::from_chars(text.data(), end, number); stop == end && fault == std::errc{})
      return fbx_number(number);
    return {FbxValue::Kind::kText, text};
  }

  std::string_view file_;
  const FbxVisit& visit_;
  std::size_t at_ = 0;
  std::size_t depth_ = 0;
  std::size_t deepest_ = 0;  // Depth of the records that `visit_` wants now.
  std::string_view name_;
  bool has_name_ = false;
  FbxValues values_;
};

}  // namespace

bool walk_text_fbx(std::string_view file, const FbxVisit& visit) { return TextFbx(file, visit).walk(); }

}  // namespace coif::importer
