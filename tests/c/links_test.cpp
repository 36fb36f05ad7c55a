// Linked chains, in C.

#include "c/in_c.h"
#include "sim/linked_sheet.h"

#include <coif.h>

#include <gtest/gtest.h>

#include <cstring>
#include <memory>

namespace coif::c_links_test {
namespace {

class CLinks : public testing::Test {
 protected:
  coif_hair* create(std::uint32_t solver, std::uint32_t keeps_links) {
    coif_hair_desc desc;
    coif_hair_desc_init(&desc);
    EXPECT_EQ(desc.keeps_links, 0u);
    desc.solver = solver;
    desc.keeps_links = keeps_links;
    const std::size_t bytes = coif_hair_memory_need(file_.bytes().data(), file_.bytes().size(), &desc);
    if (bytes == 0) return nullptr;
    memory_.push_back(std::make_unique<AlignedBytes>(std::vector<std::byte>(bytes)));
    coif_hair* hair = nullptr;
    EXPECT_EQ(coif_hair_create(file_.bytes().data(), file_.bytes().size(), &desc, memory_.back()->bytes().data(), bytes,
                               &hair),
              COIF_OK);
    return hair;
  }

  const TestRig rig_ = links_test::sheet_rig();
  AlignedBytes file_{write_asset(rig_.contents())};
  std::vector<std::unique_ptr<AlignedBytes>> memory_;
};

TEST_F(CLinks, AreKeptAsInCppWhereTheyAreAskedFor) {
  for (const std::uint32_t keeps : {0u, 1u}) {
    for (const bool is_worn : {false, true}) {
      const LinkCode* const links = keeps == 0 ? nullptr : is_worn ? &kCharacterLinks : &kLinks;
      TestHair same(rig_, {.solver = is_worn ? &kCharacterSolver : &kCoifSolver, .links = links});
      coif_hair* const hair = create(is_worn ? COIF_SOLVER_CHARACTER : COIF_SOLVER_COIF, keeps);
      ASSERT_NE(hair, nullptr);
      const coif_head_pose upright = in_c({});
      ASSERT_EQ(coif_hair_reset(hair, 0, &upright), COIF_OK);
      coif_step_settings settings;
      coif_step_settings_init(&settings);
      for (int frame = 1; frame < 40; ++frame) {
        const HeadPose pose = wander(frame / 60.0);
        const coif_head_pose its = in_c(pose);
        ASSERT_EQ(coif_hair_set_head(hair, 0, &its), COIF_OK);
        ASSERT_EQ(same.hair.set_head(0, pose), Status::kOk);
        ASSERT_EQ(coif_hair_step(hair, &settings), COIF_OK);
        ASSERT_EQ(same.hair.step({}), Status::kOk);
      }
      const auto palette = same.hair.palette(0);
      EXPECT_EQ(std::memcmp(coif_hair_palette(hair, 0), palette.data(), palette.size_bytes()), 0);
    }
  }
}

TEST_F(CLinks, AreNotOfAlgorithm1) { EXPECT_EQ(create(COIF_SOLVER_THESIS, 1), nullptr); }

}  // namespace
}  // namespace coif::c_links_test
