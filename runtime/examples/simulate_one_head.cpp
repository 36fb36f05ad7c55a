// The shortest complete use of coif::sim: one head, one asset, two seconds of a shaking head.
//
//   simulate_one_head bob.coif
//
// Shows everything that a game does: read, open, give memory, then in each frame move the head, step, use the matrices.

#include <coif/hair.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <vector>

namespace {

/// The library wants memory aligned to 64 bytes; a game has its own allocator for that.
struct alignas(64) CacheLine {
  std::byte bytes[64];
};
using Memory = std::vector<CacheLine>;

Memory allocate(std::size_t bytes) { return Memory((bytes + sizeof(CacheLine) - 1) / sizeof(CacheLine)); }

/// The first `bytes` of the memory.
std::span<std::byte> use(Memory& memory, std::size_t bytes) {
  return std::as_writable_bytes(std::span(memory)).first(bytes);
}

/// The whole file; empty if it cannot be read.
std::span<std::byte> read_file(const char* path, Memory& memory) {
  std::FILE* const file = std::fopen(path, "rb");
  if (file == nullptr) return {};
  std::fseek(file, 0, SEEK_END);
  const long end = std::ftell(file);
  std::rewind(file);
  const std::size_t bytes = end > 0 ? std::size_t(end) : 0;
  memory = allocate(bytes);
  const bool whole = std::fread(memory.data(), 1, bytes, file) == bytes;
  std::fclose(file);
  return whole ? use(memory, bytes) : std::span<std::byte>{};
}

/// Where the game's animation puts the head: it shakes by half a radian, twice a second, 1.7 m above the ground. From
/// the matrix of your skeleton's head bone, head_pose_of_bone() in coif/head_bone.h computes such a pose.
coif::HeadPose head_at(double seconds) {
  const double angle = 0.5 * std::sin(4.0 * 3.14159265 * seconds);
  coif::HeadPose pose;
  pose.position[1] = 1.7;
  pose.rotation = {0, float(std::sin(angle / 2)), 0, float(std::cos(angle / 2))};
  return pose;
}

/// Metres from rest to now of the particle that moved furthest. A renderer would upload hair.palette(0) instead and
/// draw it under the head's world matrix.
float largest_swing(const coif::Hair& hair, std::span<const coif::Vec3> rest) {
  float largest = 0;
  std::vector<coif::Vec3> now(rest.size());
  if (hair.bone_ends(0, now) != coif::Status::kOk) return largest;
  for (std::size_t i = 0; i < now.size(); ++i) {
    const float swing = std::hypot(now[i].x - rest[i].x, now[i].y - rest[i].y, now[i].z - rest[i].z);
    largest = std::fmax(largest, swing);
  }
  return largest;
}

/// The game's main loop: each frame sets the head's new pose and steps to it.
coif::Status play(coif::Hair& hair, float& largest) {
  // Puts the head where it appears, with its hair at rest: every pose from now on is movement.
  if (const coif::Status status = hair.reset(0, head_at(0)); status != coif::Status::kOk) return status;
  std::vector<coif::Vec3> rest(hair.bone_count());
  if (const coif::Status status = hair.bone_ends(0, rest); status != coif::Status::kOk) return status;

  coif::StepSettings settings;
  settings.dt = 1.0f / 60.0f;
  for (int frame = 1; frame <= 120; ++frame) {
    if (const coif::Status status = hair.set_head(0, head_at(frame / 60.0)); status != coif::Status::kOk) return status;
    if (const coif::Status status = hair.step(settings); status != coif::Status::kOk) return status;
    largest = std::fmax(largest, largest_swing(hair, rest));
  }
  return coif::Status::kOk;
}

int fail(const char* what, const char* why) {
  std::fprintf(stderr, "simulate_one_head: %s: %s\n", what, why);
  return EXIT_FAILURE;
}

}  // namespace

int main(int argument_count, char** arguments) {
  if (argument_count != 2) return fail("usage", "simulate_one_head FILE.coif");

  // The file's bytes are used in place: keep them for as long as the hair lives. open() checks everything once.
  Memory file;
  const std::span<std::byte> bytes = read_file(arguments[1], file);
  if (bytes.empty()) return fail(arguments[1], "cannot read, or empty");
  coif::Asset asset;
  if (const coif::LoadStatus status = asset.open(bytes); !status) {
    char text[160];
    coif::describe(status, text, sizeof text);
    return fail(arguments[1], text);
  }

  // memory_need() says how much memory one head takes. After create() nothing is ever allocated.
  const coif::HairDesc desc{.instances = 1};
  const coif::MemoryNeed need = coif::Hair::memory_need(asset, desc);
  Memory memory = allocate(need.bytes);
  coif::Hair hair;
  if (const coif::Status status = hair.create(asset, desc, use(memory, need.bytes)); status != coif::Status::kOk) {
    return fail("create", coif::describe(status));
  }

  float largest = 0;
  if (const coif::Status status = play(hair, largest); status != coif::Status::kOk) {
    return fail("play", coif::describe(status));
  }
  std::printf("%u bones, %zu bytes, largest swing %.1f cm\n", hair.bone_count(), need.bytes, 100 * double(largest));
  return EXIT_SUCCESS;
}
