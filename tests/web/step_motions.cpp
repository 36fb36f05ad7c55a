// Steps assets by every solver of the C interface through every built-in motion, and prints a hash of all matrices of
// all frames. step_motions.mjs does the same through the package and the WebAssembly build, which has to print the same
// lines.
//
//   step_motions poses FILE              the heads' poses, computed once: sines differ between C libraries
//   step_motions hashes FILE ASSET...    a line for each asset, solver and motion
#include "motion/head_path.h"

#include <coif.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace {

constexpr std::uint32_t kFrames = 150;  // at 60 a second
constexpr std::uint32_t kHeads = 2;     // the second half a second behind, and half as large again
constexpr std::uint32_t kDelay = 30;
constexpr const char* kSolvers[] = {"coif", "thesis", "passive", "cascade", "character"};

/// Two words of hash, of 32-bit arithmetic alone.
class Hash {
 public:
  void add(const void* data, std::size_t bytes) {
    const auto* at = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i + 4 <= bytes; i += 4) {
      std::uint32_t word = 0;
      std::memcpy(&word, at + i, 4);
      first_ = (first_ ^ word) * 16777619u;
      second_ = (second_ + word) * 2246822507u;
      second_ ^= second_ >> 13;
    }
  }
  void print() const { std::printf("%08x%08x\n", first_, second_); }

 private:
  std::uint32_t first_ = 2166136261u, second_ = 1;
};

struct Aligned {
  explicit Aligned(std::size_t size) : bytes(size), data(std::aligned_alloc(64, (size + 63) / 64 * 64)) {}
  ~Aligned() { std::free(data); }
  Aligned(const Aligned&) = delete;
  Aligned& operator=(const Aligned&) = delete;
  std::size_t bytes;
  void* data;
};

/// kFrames poses of each motion, one after the other, as C has them.
int write_poses(const char* path) {
  std::ofstream file(path, std::ios::binary);
  for (const coif::motion::MotionInfo& motion : coif::motion::all_motions()) {
    for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
      const coif::HeadPose pose = coif::motion::head_pose(motion.motion, (frame + 1) / 60.0);
      file.write(reinterpret_cast<const char*>(&pose), sizeof pose);
    }
  }
  file.close();
  return file ? 0 : 1;
}

std::vector<char> read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void ask(coif_status status, const char* what) {
  if (status == COIF_OK) return;
  std::fprintf(stderr, "step_motions: %s: %s\n", what, coif_describe(status));
  std::exit(1);
}

/// What a character has beside it: a ball beside its face, wind of its own, gusts, a body that goes along.
void bring_company(coif_hair* hair, const coif_head_pose& head, std::uint32_t i, const coif_body_bone* body,
                   std::uint32_t count) {
  coif_moving_collider ball;
  coif_moving_collider_init(&ball);
  for (int k = 0; k < 3; ++k) ball.center[k] = head.position[k] + (k == 1 ? -0.0625 : 0.125);
  ball.radius = 0.0625f;
  ask(coif_hair_set_colliders(hair, i, &ball, 1), "set_colliders");
  const coif_head_air air{{0.5f, 0.25f, 0}, 0.75f};
  ask(coif_hair_set_air(hair, i, &air), "set_air");
  std::vector<coif_body_pose> poses(count);
  for (std::uint32_t b = 0; b < count; ++b) {
    for (int k = 0; k < 3; ++k) poses[b].position[k] = head.position[k] + double(body[b].joint[k]);
    poses[b].rotation = {body[b].rotation[0], body[b].rotation[1], body[b].rotation[2], body[b].rotation[3]};
  }
  if (count > 0) ask(coif_hair_set_body(hair, i, poses.data(), count), "set_body");
}

void play(const std::string& name, const Aligned& asset, std::uint32_t solver, std::size_t motion,
          const coif_head_pose* path) {
  static coif_asset view;
  ask(coif_asset_open(&view, asset.data, asset.bytes, nullptr, 0), "open");
  std::uint32_t body_count = 0;
  const coif_body_bone* const body = coif_asset_body_bones(&view, &body_count);
  const bool is_worn = solver == COIF_SOLVER_CHARACTER;
  coif_hair_desc desc;
  coif_hair_desc_init(&desc);
  desc.instances = kHeads;
  desc.solver = solver;
  desc.keeps_links = solver != COIF_SOLVER_THESIS;
  if (is_worn) desc.moving_colliders = desc.has_own_air = desc.feels_gusts = desc.follows_body = 1;
  const Aligned memory(coif_hair_memory_need(asset.data, asset.bytes, &desc));
  coif_hair* hair = nullptr;
  ask(coif_hair_create(asset.data, asset.bytes, &desc, memory.data, memory.bytes, &hair), "create");
  if (is_worn) {
    coif_gusts gusts;
    coif_gusts_init(&gusts);
    gusts.amplitude = 1.5f;
    ask(coif_hair_set_gusts(hair, &gusts), "set_gusts");
  }
  coif_step_settings settings;
  coif_step_settings_init(&settings);
  Hash hash;
  for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
    std::array<coif_head_pose, kHeads> heads{path[frame], path[frame < kDelay ? 0 : frame - kDelay]};
    heads[1].scale = 1.5f;
    ask(coif_hair_set_heads(hair, heads.data(), kHeads), "set_heads");
    for (std::uint32_t i = 0; is_worn && i < kHeads; ++i) bring_company(hair, heads[i], i, body, body_count);
    ask(coif_hair_step(hair, &settings), "step");
    for (std::uint32_t i = 0; i < kHeads; ++i) {
      hash.add(coif_hair_palette(hair, i), coif_hair_bone_count(hair) * sizeof(coif_mat34));
    }
  }
  std::printf("%s %s %s ", name.c_str(), kSolvers[solver], coif::motion::all_motions()[motion].name);
  hash.print();
}

int print_hashes(const char* poses_path, char** begin, char** end) {
  const std::vector<char> poses = read(poses_path);
  const std::size_t motions = coif::motion::all_motions().size();
  if (poses.size() != motions * kFrames * sizeof(coif_head_pose)) return 1;
  for (char** path = begin; path < end; ++path) {
    const std::vector<char> file = read(*path);
    const Aligned asset(file.size());
    std::memcpy(asset.data, file.data(), file.size());
    for (std::uint32_t solver = 0; solver < std::size(kSolvers); ++solver) {
      for (std::size_t motion = 0; motion < motions; ++motion) {
        play(std::filesystem::path(*path).stem(), asset, solver, motion,
             reinterpret_cast<const coif_head_pose*>(poses.data()) + motion * kFrames);
      }
    }
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string what = argc > 2 ? argv[1] : "";
  if (what == "poses") return write_poses(argv[2]);
  if (what == "hashes") return print_hashes(argv[2], argv + 3, argv + argc);
  std::fprintf(stderr, "usage: step_motions poses FILE | hashes FILE ASSET...\n");
  return 2;
}
