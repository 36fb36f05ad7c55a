// What vectors of motion refuse and leave, and who keeps the last frame.

#include "gl/motion_scene.h"
#include "models/skinned_asset.h"

#include <coif/hair.h>
#include <coif/last_frame.h>

#include <GLES3/gl3.h>

#include <array>
#include <cstring>
#include <limits>
#include <vector>

namespace coif::motion_arguments_test {

using MotionArguments = MotionScene;

TEST_F(MotionArguments, AreRefusedForWhatDoesNotFitAndNothingIsDrawn) {
  const std::array card{DrawnCard{}};
  const DrawnAsset flat(card_contents(card));
  const Frame frame = frame_of(*flat, 0, 0);
  HairModel model;
  const HairInstance good{frame.head, frame.palette, 0};
  const MotionDesc desc = desc_of(frame, frame);
  EXPECT_EQ(draw_motion_vectors(renderer_, model, {&good, 1}, {&good, 1}, desc), Status::kNotCreated);
  EXPECT_EQ(prepare_motion_vectors(renderer_, model), Status::kNotCreated);
  ASSERT_EQ(model.upload(renderer_, *flat), Status::kOk);
  clear_vectors();
  calls_->forget();
  HairInstance bad_scale = good, bad_palette = good;
  bad_scale.head.scale = 0;
  bad_palette.palette = {};
  const auto draw = [&](const HairInstance& now, const HairInstance& before, const MotionDesc& with) {
    return draw_motion_vectors(renderer_, model, {&now, 1}, {&before, 1}, with);
  };
  EXPECT_EQ(draw_motion_vectors(renderer_, model, {&good, 1}, {}, desc), Status::kSizeMismatch);
  EXPECT_EQ(draw(good, bad_scale, desc), Status::kBadScale);
  EXPECT_EQ(draw(bad_scale, good, desc), Status::kBadScale);
  EXPECT_EQ(draw(good, bad_palette, desc), Status::kSizeMismatch);
  for (const float alpha : {-0.1f, 1.1f, std::numeric_limits<float>::quiet_NaN()}) {
    MotionDesc bad = desc;
    bad.alpha = alpha;
    EXPECT_EQ(draw(good, good, bad), Status::kBadArgument);
    EXPECT_EQ(prepare_motion_vectors(renderer_, model, bad), Status::kBadArgument);
  }
  MotionDesc bad = desc;
  bad.previous_clip_from_world[3] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(draw(good, good, bad), Status::kBadArgument);
  EXPECT_EQ(calls_->draws + calls_->links, 0);
  model.destroy();
}

TEST_F(MotionArguments, MatricesThatTheStreamHasNoRoomForAreRefused) {
  DrawnCard card;
  const DrawnAsset asset(card_contents(std::span(&card, 1), kMaxBones));
  HairModel model;
  ASSERT_EQ(model.upload(renderer_, *asset), Status::kOk);
  const Frame frame = frame_of(*asset, 0, 0);
  const HairInstance one{frame.head, frame.palette, 0};
  EXPECT_EQ(draw_motion_vectors(renderer_, model, {&one, 1}, {&one, 1}, desc_of(frame, frame)), Status::kBadArgument);
  model.destroy();
}

TEST_F(MotionArguments, LeaveOpenGlAsDrawDoes) {
  const std::array card{DrawnCard{}};
  const DrawnAsset flat(card_contents(card));
  const Frame frame = frame_of(*flat, 0, 0);
  vectors(*flat, frame, frame);
  GLint value = -1;
  for (const GLenum what :
       {GL_CURRENT_PROGRAM, GL_VERTEX_ARRAY_BINDING, GL_UNIFORM_BUFFER_BINDING, GL_TEXTURE_BINDING_2D}) {
    glGetIntegerv(what, &value);
    EXPECT_EQ(value, 0) << what;
  }
  EXPECT_FALSE(glIsEnabled(GL_DEPTH_TEST));
  EXPECT_FALSE(glIsEnabled(GL_BLEND));
  GLboolean mask[4] = {};
  glGetBooleanv(GL_COLOR_WRITEMASK, mask);
  EXPECT_TRUE(mask[0] && mask[3]);
}

TEST(LastFrame, KeepsEveryHeadsMatricesWhileTheNextStepChangesThem) {
  const DrawnAsset wig(made_up_wig({.strips = 6, .texture_size = 32}));
  struct alignas(64) Block {
    std::byte bytes[64];
  };
  const HairDesc desc{.instances = 3};
  std::vector<Block> memory(Hair::memory_need(*wig, desc).bytes / sizeof(Block) + 1);
  Hair hair;
  std::vector<Mat34> kept((*wig).bones().size() * 3);
  EXPECT_EQ(keep_palettes(hair, kept), Status::kNotCreated);
  ASSERT_EQ(hair.create(*wig, desc, std::as_writable_bytes(std::span(memory))), Status::kOk);
  EXPECT_EQ(keep_palettes(hair, std::span(kept).first(5)), Status::kSizeMismatch);
  for (int frame = 1; frame <= 5; ++frame) {
    std::vector<std::vector<Mat34>> own;
    for (std::uint32_t head = 0; head < 3; ++head) {
      own.emplace_back(hair.palette(head).begin(), hair.palette(head).end());
      HeadPose pose;
      pose.position[0] = 0.01 * frame * (1 + head);
      ASSERT_EQ(hair.set_head(head, pose), Status::kOk);
    }
    ASSERT_EQ(keep_palettes(hair, kept), Status::kOk);
    ASSERT_EQ(hair.step({}), Status::kOk);
    for (std::uint32_t head = 0; head < 3; ++head) {
      const auto found = kept_palette(kept, hair.bone_count(), head);
      EXPECT_EQ(std::memcmp(found.data(), own[head].data(), found.size_bytes()), 0);
      EXPECT_NE(std::memcmp(found.data(), hair.palette(head).data(), found.size_bytes()), 0);
    }
  }
}

}  // namespace coif::motion_arguments_test
