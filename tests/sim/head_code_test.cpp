// What the code of each instruction set leaves of the lanes around a head's own.

#include "sim/lanes/lane_code.h"

#include "models/test_rig.h"

#include <gtest/gtest.h>

#include <cstring>

namespace coif::head_code_test {

/// Numbers that all differ, in every lane of whatever consists of lanes.
template <typename T>
void fill(T& lanes, float first) {
  auto* const floats = reinterpret_cast<float*>(&lanes);
  for (std::size_t i = 0; i < sizeof lanes / sizeof(float); ++i) floats[i] = first + float(i);
}

TEST(HeadCode, SpreadsOneLaneToAllAndWritesNothingBehind) {
  struct Guarded {
    Lanes before;
    MoveLanes lanes;
    Lanes after;
  };
  for (const InstructionSet set : runnable_sets()) {
    for (const std::uint32_t lane : {0u, 7u, kLanes - 1}) {
      Guarded from, to, untouched;
      fill(from, 1);
      fill(to, -1e6f);
      std::memcpy(&untouched, &to, sizeof to);
      head_code(set).spread(from.lanes, lane, to.lanes);
      const auto* const source = reinterpret_cast<const Lanes*>(&from.lanes);
      const auto* const goal = reinterpret_cast<const Lanes*>(&to.lanes);
      for (std::size_t n = 0; n < sizeof(MoveLanes) / sizeof(Lanes); ++n) {
        for (const float value : goal[n].v) EXPECT_EQ(value, source[n].v[lane]) << n;
      }
      EXPECT_EQ(std::memcmp(&to.before, &untouched.before, sizeof(Lanes)), 0);
      EXPECT_EQ(std::memcmp(&to.after, &untouched.after, sizeof(Lanes)), 0);
    }
  }
}

}  // namespace coif::head_code_test
