// The smallest programs that use one part of coif each; which one this is, its build defines. The guards look what was
// linked into each of them. All of it is refused here: there is neither an asset nor an OpenGL context.
#if defined GAME_only_open
// A tool of a game that reads assets and nothing else.
#include <coif/asset.h>

int main() {
  alignas(64) static constexpr std::byte kText[256] = {};
  coif::Asset asset;
  return !asset.open(kText) && !asset.is_open() ? 0 : 1;
}

#elif defined GAME_only_lod
// A game that chooses levels of detail and simulates elsewhere.
#include <coif/lod.h>

int main() {
  constexpr coif::LodRecord kLods[] = {{0, 1, 0.5f, 0.0f}, {1, 1, 0.0f, 0.01f}};
  const float far_away = coif::screen_share(0.25f, 10.0f, 1.0f);
  return coif::choose_lod(kLods, far_away, 0) == 1 ? 0 : 1;
}

#elif defined GAME_only_head_bone
// A game that asks where an animated head is.
#include <coif/head_bone.h>

int main() {
  const coif::HeadBone centimetres{.metres_per_unit = 0.01};
  coif::HeadPose head;
  const coif::BoneMatrix bone{{{0, 0, 1, 0}, {0, 1, 0, 160}, {-1, 0, 0, 0}}};
  return coif::head_pose_of_bone(bone, centimetres, head) == coif::Status::kOk && head.position[1] < 2 ? 0 : 1;
}

#elif defined GAME_step_by_thesis
// A game that names the thesis's solver and no other.
#include <coif/hair.h>

int main() {
  coif::Hair hair;
  const coif::Asset asset;
  const coif::HairDesc desc{.solver = &coif::kThesisSolver};
  return hair.create(asset, desc, {}) == coif::Status::kAssetLacksData && hair.step({}) != coif::Status::kOk ? 0 : 1;
}

#elif defined GAME_step_cascade
// A game whose hair is all of one model.
#include <coif/hair.h>

int main() {
  coif::Hair hair;
  const coif::Asset asset;
  const coif::HairDesc desc{.solver = &coif::kCascadeSolver};
  return hair.create(asset, desc, {}) == coif::Status::kAssetLacksData && hair.step({}) != coif::Status::kOk ? 0 : 1;
}

#elif defined GAME_step_world
// A game with many hair styles, a few heads of each.
#include <coif/hair_world.h>

int main() {
  coif::HairWorld world;
  const coif::WorldDesc desc{.heads = 0, .solver = &coif::kCascadeSolver};
  coif::WorldAsset none;
  const bool is_refused = world.create(desc, {}) == coif::Status::kBadArgument;
  const bool has_none = world.add_asset(coif::Asset(), none) != coif::Status::kOk;
  return is_refused && has_none && world.step({}) != coif::Status::kOk ? 0 : 1;
}

#elif defined GAME_step_character
// A game whose hair, all of one model, is on characters.
#include <coif/hair.h>

int main() {
  coif::Hair hair;
  const coif::Asset asset;
  const coif::HairDesc desc{.solver = &coif::kCharacterCascadeSolver, .moving_colliders = 4, .follows_poses = true};
  const bool refuses = hair.set_colliders(0, {}) != coif::Status::kOk &&
                       hair.set_pose(0, {}, {}) != coif::Status::kOk && hair.set_body(0, {}) != coif::Status::kOk;
  return hair.create(asset, desc, {}) == coif::Status::kAssetLacksData && refuses ? 0 : 1;
}

#elif defined GAME_only_skin
// A game that skins on the processor and simulates elsewhere.
#include <coif/skinning.h>

int main() {
  const coif::Asset asset;
  coif::SkinnedVertex out[1];
  return coif::skin_vertices(asset, {}, 0, out) == coif::Status::kAssetLacksData ? 0 : 1;
}

#elif defined GAME_only_skeleton
// An engine whose own skeleton takes the bones.
#include <coif/bone_transforms.h>

int main() {
  const coif::Asset asset;
  return coif::bone_transforms(asset, {}, {}) == coif::Status::kAssetLacksData ? 0 : 1;
}

#elif defined GAME_only_bound
// A renderer that culls by itself.
#include <coif/bounds.h>

int main() {
  const coif::Asset asset;
  const coif::BoneBox box{{0, 0, 0}, {1, 1, 1}};
  const coif::Mat34 rest;
  coif::HairBounds bounds;
  const bool refuses = coif::find_bone_boxes(asset, {}) == coif::Status::kAssetLacksData;
  return refuses && coif::bound_hair({&box, 1}, {&rest, 1}, bounds) == coif::Status::kOk && bounds.highest.x >= 1 ? 0
                                                                                                                  : 1;
}

#elif defined GAME_only_lines
// A game's editor, which shows bones and nothing else.
#include <coif/debug_lines.h>

int main() {
  const coif::Asset asset;
  return coif::draw_bone_lines(asset, {}, {}) == coif::Status::kAssetLacksData ? 0 : 1;
}

#elif defined GAME_only_cull
// A renderer for another graphics interface: it asks which heads are seen, and fills its uniform blocks.
#include <coif/drawing.h>

int main() {
  coif::DrawnHair hair;
  hair.lod_count = 1;
  hair.reach = {{0, 0, 0}, 0.1f};
  coif::HairInstance heads[2];
  heads[1].head.position[0] = 5;
  coif::DrawView view;  // orthographic, a metre each way
  for (int i = 0; i < 4; ++i) view.clip_from_world[5 * i] = 1;
  coif::DrawBlock block;
  const coif::MatrixLayout layout = coif::matrix_layout_of(hair, 16384);
  const bool refuses = coif::fill_draw_block(view, {}, layout.rows_of_head, block) == coif::Status::kBadArgument;
  const coif::VisibleCrowd crowd(hair, heads, view.eye, view.clip_from_world);
  return refuses && crowd.count({0, 0}, 0, 2) == 1 && crowd.find({0, 0}, 0) == 0 ? 0 : 1;
}

#elif defined GAME_make_renderer
// Links the renderer without any OpenGL library: its functions come from the host, and a host without one is refused.
#include <coif/renderer.h>

int main() {
  coif::HairRenderer renderer;
  return renderer.create({}) == coif::Status::kBadArgument && !renderer.is_created() ? 0 : 1;
}

#elif defined GAME_only_draw
// A game that draws hair in the way that is the default and simulates elsewhere.
#include <coif/renderer.h>

int main() {
  coif::HairRenderer renderer;
  coif::HairModel model;
  const coif::Asset asset;
  const bool refused = renderer.create({}) == coif::Status::kBadArgument &&
                       model.upload(renderer, asset) == coif::Status::kNotCreated &&
                       renderer.draw(model, {}, {}) == coif::Status::kNotCreated;
  return refused ? 0 : 1;
}

#elif defined GAME_draw_hashed || defined GAME_draw_jittered || defined GAME_draw_exactly
// A program that draws soft hair in one other way, and holds no way beside it.
#include <coif/renderer.h>
#include <coif/research.h>

#ifdef GAME_draw_hashed
constexpr const coif::TransparencyMode& kMode = coif::kHashedMode;
#elif defined GAME_draw_jittered
constexpr const coif::TransparencyMode& kMode = coif::kJitteredMode;
#else
constexpr const coif::TransparencyMode& kMode = coif::kExactMode;
#endif

int main() {
  coif::HairRenderer renderer;
  coif::HairModel model;
  const coif::Asset asset;
  // Named at once: a DrawDesc without it names the default.
  const coif::DrawDesc desc{.clip_from_world = {}, .eye = {}, .lights = {}, .transparency = &kMode};
  const bool refused = renderer.create({}) == coif::Status::kBadArgument &&
                       model.upload(renderer, asset, kMode) == coif::Status::kNotCreated &&
                       renderer.draw(model, {}, desc) == coif::Status::kNotCreated;
  return refused ? 0 : 1;
}

#elif defined GAME_draw_motion
// A game with temporal anti-aliasing.
#include <coif/motion_vectors.h>

int main() {
  coif::HairRenderer renderer;
  coif::HairModel model;
  const coif::Asset asset;
  const bool refused = renderer.create({}) == coif::Status::kBadArgument &&
                       model.upload(renderer, asset) == coif::Status::kNotCreated &&
                       renderer.draw(model, {}, {}) == coif::Status::kNotCreated &&
                       coif::draw_motion_vectors(renderer, model, {}, {}, {}) == coif::Status::kNotCreated;
  return refused ? 0 : 1;
}

#elif defined GAME_draw_by_bones
// A game that sorts bones in every frame.
#include <coif/renderer.h>

int main() {
  coif::HairRenderer renderer;
  coif::HairModel model;
  coif::BoneOrder order;
  const coif::Asset asset;
  coif::DrawDesc desc;
  desc.order = &order;
  const bool refused = renderer.create({}) == coif::Status::kBadArgument &&
                       order.create(asset, {}) == coif::Status::kAssetLacksData &&
                       model.upload(renderer, asset) == coif::Status::kNotCreated &&
                       renderer.draw(model, {}, desc) == coif::Status::kNotCreated;
  return refused ? 0 : 1;
}

#elif defined GAME_cast_plainly
// A program whose hair casts shadows by depth maps alone.
#include <coif/shadow.h>

int main() {
  coif::HairRenderer renderer;
  coif::HairModel model;
  coif::HairShadow shadow;
  const coif::Asset asset;
  // Named at once: descriptions without them name the defaults.
  const coif::ShadowDesc plain{.technique = &coif::kPlainShadow};
  const bool refused = renderer.create({}) == coif::Status::kBadArgument &&
                       model.upload(renderer, asset, coif::kOpaqueMode) == coif::Status::kNotCreated &&
                       shadow.create(renderer, {}, plain) == coif::Status::kNotCreated &&
                       shadow.begin({}, {}) == coif::Status::kNotCreated &&
                       shadow.draw({}) == coif::Status::kNotCreated;
  return refused ? 0 : 1;
}
#endif
