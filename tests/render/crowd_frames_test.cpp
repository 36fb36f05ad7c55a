// What a game pays for a crowd again and again, in every mode: nothing but draw calls.

#include "gl/card_asset.h"
#include "gl/counted_gl_test.h"
#include "gl/made_up_wig.h"
#include "render/transparency_modes.h"

#include <GLES3/gl3.h>

#include <vector>

namespace coif {
namespace {

using CrowdFrames = CountedGlTest;

TEST_F(CrowdFrames, MakeNoObjectsInAnyMode) {
  const OpenedAsset wig(made_up_wig({.strips = 6, .bones_per_chain = 4, .texture_size = 32}));
  const std::vector<Mat34> palette((*wig).bones().size());
  std::vector<HairInstance> heads(120);  // more than a uniform block holds
  for (std::size_t i = 0; i < heads.size(); ++i) {
    heads[i].palette = palette;
    heads[i].head.position[0] = -0.9 + 0.015 * double(i);
  }
  HairModel model;
  ASSERT_EQ(model.upload(renderer_, *wig), Status::kOk);
  for (const TransparencyMode* mode : transparency_modes()) {
    DrawDesc desc = at_rest();
    desc.transparency = mode;
    // The first frame builds the mode's programs and what it needs of a picture's size.
    ASSERT_EQ(renderer_.draw(model, heads, desc), Status::kOk) << name_of(*mode);
    calls_->forget();
    for (int frame = 0; frame < 3; ++frame) ASSERT_EQ(renderer_.draw(model, heads, desc), Status::kOk);
    EXPECT_GT(calls_->instances, 0) << name_of(*mode);
    EXPECT_EQ(calls_->links, 0) << name_of(*mode);
    EXPECT_EQ(calls_->objects, 0) << name_of(*mode);
    EXPECT_EQ(calls_->storage, 0) << name_of(*mode);
  }
  model.destroy();
}

}  // namespace
}  // namespace coif
