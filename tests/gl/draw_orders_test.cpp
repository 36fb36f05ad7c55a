// A draw order may depend on the side that the head is seen from.

#include "gl/counted_gl_test.h"

#include <coif/view_cells.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace coif {
namespace {

/// Two cards in one place, half transparent: what is drawn later shows more. Stored: red, then blue; from behind the
/// other way round.
AssetContents red_before_blue() {
  std::array<Card, 2> cards{};
  cards[0].rgba = {255, 0, 0, 160};
  cards[1].rgba = {0, 0, 255, 160};
  for (Card& card : cards) card.half_size = 0.2f;
  AssetContents contents = card_contents(cards);
  contents.orders = {2, 3, 0, 1};  // triangles
  contents.order_views.assign(kViewCells, 0);
  for (std::uint32_t cell = 0; cell < kViewCells; ++cell) {
    float direction[3];
    view_cell_direction(cell, direction);
    if (direction[2] < 0) contents.order_views[cell] = 1;
  }
  return contents;
}

HairInstance head_at(float x, bool seen_from_behind) {
  HairInstance head;
  head.head.position[0] = x;
  if (seen_from_behind) head.head.rotation = {0, 1, 0, 0};
  return head;
}

bool is_red(const Pixel& pixel) { return pixel[0] > pixel[2] + 20; }
bool is_blue(const Pixel& pixel) { return pixel[2] > pixel[0] + 20; }

class DrawOrders : public CountedGlTest {
 protected:
  void draw_heads(const AssetContents& contents, std::vector<HairInstance> heads) {
    const HeadDraw desc = at_rest();
    for (HairInstance& head : heads) head.palette = desc.palette;
    HairModel model;
    ASSERT_EQ(model.upload(renderer_, *OpenedAsset(contents)), Status::kOk);
    clear();
    calls_->forget();
    ASSERT_EQ(renderer_.draw(model, heads, desc), Status::kOk);
    model.destroy();
  }
};

TEST_F(DrawOrders, SideOfTheHeadThatIsSeenChoosesTheOrder) {
  draw_heads(red_before_blue(), {head_at(0, false)});
  EXPECT_TRUE(is_blue(middle_pixel()));
  draw_heads(red_before_blue(), {head_at(0, true)});
  EXPECT_TRUE(is_red(middle_pixel()));
}

TEST_F(DrawOrders, AssetWithoutOrdersKeepsTheStoredOne) {
  AssetContents contents = red_before_blue();
  contents.orders.clear();
  contents.order_views.clear();
  draw_heads(contents, {head_at(0, true)});
  EXPECT_TRUE(is_blue(middle_pixel()));
}

TEST_F(DrawOrders, HeadsOfACrowdEachHaveTheirOwn) {
  const AssetContents contents = red_before_blue();
  draw_heads(contents, {head_at(-0.5f, false), head_at(0, true), head_at(0.5f, false)});
  EXPECT_TRUE(is_blue(pixel(8, 16)));
  EXPECT_TRUE(is_red(pixel(16, 16)));
  EXPECT_TRUE(is_blue(pixel(24, 16)));
  const int of_both = calls_->draws;
  draw_heads(contents, {head_at(-0.5f, false), head_at(0.5f, false)});
  EXPECT_EQ(of_both, 2 * calls_->draws) << "one set of draw calls for each order in view";
}

}  // namespace
}  // namespace coif
