#pragma once

#include "gl/gl_test.h"

#include <coif/research.h>

#include <GLES3/gl31.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace coif {

inline DrawnCard soft_card(const std::array<std::uint8_t, 4>& rgba, float z) {
  DrawnCard card;
  card.rgba = rgba;
  card.center[2] = z;
  return card;
}

/// A host that does not find some functions.
class WithoutFunctions {
 public:
  WithoutFunctions(const GlLoader& real, std::string absent) : real_(real), absent_(std::move(absent)) {}
  [[nodiscard]] GlLoader loader() { return {find, this}; }

 private:
  static void* find(const char* name, void* user) {
    const auto& self = *static_cast<WithoutFunctions*>(user);
    return name == self.absent_ ? nullptr : self.real_.get_proc(name, self.real_.user);
  }
  GlLoader real_;
  std::string absent_;
};

enum class Way { kLists, kPeeling, kOverflow };

inline std::string name_of(Way way) {
  return way == Way::kLists ? "Lists" : way == Way::kPeeling ? "Peeling" : "Overflow";
}

/// Every way must keep the same promises. An overflow is forced by lists that are too short.
class ExactMode : public CountedGlTest, public testing::WithParamInterface<Way> {
 protected:
  void SetUp() override {
    CountedGlTest::SetUp();
    if (context_) start(GetParam());
  }
  void start(Way way) {
    GLint blocks = 0;
    glGetIntegerv(GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS, &blocks);
    if (way != Way::kPeeling && (glGetError() != GL_NO_ERROR || blocks < 2)) GTEST_SKIP() << "no storage buffers";
    without_.emplace(calls_->loader(), way == Way::kPeeling ? "glMemoryBarrier" : "");
    RendererDesc desc = kSmallBlocks;
    desc.list_bytes = way == Way::kOverflow ? 64u << 10 : 4u << 20;
    ASSERT_EQ(renderer_.create(without_->loader(), desc), Status::kOk) << renderer_.failure();
  }
  static HeadDraw exact(std::uint32_t bones = 1) {
    HeadDraw desc = at_rest(bones);
    desc.transparency = &kExactMode;
    return desc;
  }
  void draw_exactly(const std::vector<DrawnCard>& cards) { draw_cards(cards, exact()); }

  std::optional<WithoutFunctions> without_;
};

}  // namespace coif
