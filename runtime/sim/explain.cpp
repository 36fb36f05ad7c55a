// Sentences about values that are refused. They follow from the same rules as the statuses: rules.h.

#include <coif/explain.h>

#include "rules.h"

#include <cmath>

namespace coif {
namespace {

/// Text that is cut to fit, and the length that it would have.
class Sentence {
 public:
  explicit Sentence(std::span<char> text) : text_(text) {
    if (!text_.empty()) text_[0] = '\0';
  }
  void add(char letter) {
    if (length_ + 1 < text_.size()) {
      text_[length_] = letter;
      text_[length_ + 1] = '\0';
    }
    ++length_;
  }
  void add(const char* words) {
    for (; *words != '\0'; ++words) add(*words);
  }
  void add(double number);
  [[nodiscard]] std::size_t length() const { return length_; }

 private:
  void add_digits(double number, int after_point);
  std::span<char> text_;
  std::size_t length_ = 0;
};

/// Up to 15 digits in front of the point; zeros at the end are left out.
void Sentence::add_digits(double number, int after_point) {
  char digits[24];
  int count = 0;
  for (int i = 0; i < after_point; ++i) number *= 10;
  auto whole = std::uint64_t(number + 0.5);
  for (; after_point > 0 && whole % 10 == 0; --after_point) whole /= 10;
  for (; whole != 0 || count <= after_point; whole /= 10) digits[count++] = char('0' + whole % 10);
  while (count > 0) {
    add(digits[--count]);
    if (count == after_point && count != 0) add('.');
  }
}

/// As many digits as tell bounds apart: six.
void Sentence::add(double number) {
  if (std::isnan(number)) return add("not a number");
  if (number < 0) add('-');
  const double size = std::fabs(number);
  if (std::isinf(size)) return add("infinite");
  if (size == 0) return add('0');
  int power = 0;
  double first = size;  // Between 1 and 10, as it will be rounded.
  for (; first >= 9.999995; first /= 10) ++power;
  for (; first < 1; first *= 10) --power;
  if (power >= -4 && power < 15) return add_digits(size, power < 6 ? 5 - power : 0);
  add_digits(first, 5);
  add('e');
  if (power < 0) add('-');
  add_digits(power < 0 ? -power : power, 0);
}

/// Writes about the first rule that is broken.
class Telling {
 public:
  Telling(const char* type, std::span<char> text) : type_(type), sentence_(text) {}

  void within(const char* member, double value, double least, double most, Status = Status::kBadArgument) {
    if ((value >= least && value <= most) || !begins(member)) return;
    sentence_.add(" is ");
    sentence_.add(value);
    if (std::isnan(value)) return;
    sentence_.add(value < least ? ", below " : ", above ");
    sentence_.add(value < least ? least : most);
  }
  void require(const char* what, bool holds, Status = Status::kBadArgument) {
    if (!holds) (void)begins(what);
  }
  void finite(const char* member, const Vec3& vector) {
    if (!is_finite(vector) && begins(member)) sentence_.add(" is not finite");
  }
  [[nodiscard]] std::size_t length() const { return sentence_.length(); }

 private:
  /// False where another rule was broken before.
  bool begins(const char* what) {
    if (sentence_.length() != 0) return false;
    sentence_.add(type_);
    sentence_.add(": ");
    sentence_.add(what);
    return true;
  }
  const char* type_;
  Sentence sentence_;
};

template <typename Value>
std::size_t explain_as(const char* type, const Value& value, std::span<char> text) {
  Telling telling(type, text);
  judge(value, telling);
  return telling.length();
}

void judge(const HeadPose& pose, Telling& is) {
  for (int axis = 0; axis < 3; ++axis) {
    constexpr const char* kPosition[] = {"position[0]", "position[1]", "position[2]"};
    is.within(kPosition[axis], pose.position[axis], -kMostDouble, kMostDouble);
  }
  is.within("length of rotation, which has to be a unit quaternion,", norm(pose.rotation), 1 - 1e-3, 1 + 1e-3);
  is.within("scale, one metre of the hair in world metres,", double(pose.scale), double(kSmallestScale),
            double(kLargestScale));
}

}  // namespace

std::size_t explain(const HairDesc& desc, std::span<char> text) { return explain_as("HairDesc", desc, text); }

std::size_t explain(const WorldDesc& desc, std::span<char> text) { return explain_as("WorldDesc", desc, text); }

std::size_t explain(const StepSettings& settings, std::span<char> text) {
  return explain_as("StepSettings", settings, text);
}

std::size_t explain(const HeadPose& pose, std::span<char> text) { return explain_as("HeadPose", pose, text); }

std::size_t explain(const DynamicsScale& scale, std::span<char> text) {
  return explain_as("DynamicsScale", scale, text);
}

std::size_t explain(const MovingCollider& collider, std::span<char> text) {
  return explain_as("MovingCollider", collider, text);
}

std::size_t explain(const HeadAir& air, std::span<char> text) { return explain_as("HeadAir", air, text); }

std::size_t explain(const Gusts& gusts, std::span<char> text) { return explain_as("Gusts", gusts, text); }

std::size_t explain(const Impulse& impulse, std::span<char> text) { return explain_as("Impulse", impulse, text); }

std::size_t explain(const Asset& asset, const HairDesc& desc, std::span<char> text) {
  if (asset.is_open()) return explain(desc, text);
  Telling telling("Asset", text);
  telling.require("it is not open; open() says why", false);
  return telling.length();
}

}  // namespace coif
