// Draws hair in the middle of an engine's own frame, into the engine's framebuffer with its own colour and depth
// textures: after the engine's solid things, before its transparent ones.
//
//   draw_in_host_frame bob.coif
//
// host_frame.* stands for the engine. Everything that concerns coif is here.

#include "host_frame.h"

#include <coif/hair.h>
#include <coif/renderer.h>

#include <cstdio>
#include <cstdlib>
#include <span>
#include <vector>

namespace {

/// coif wants memory aligned to 64 bytes; a game has its own allocator for that.
struct alignas(64) CacheLine {
  std::byte bytes[64];
};
using Memory = std::vector<CacheLine>;

Memory allocate(std::size_t bytes) { return Memory((bytes + sizeof(CacheLine) - 1) / sizeof(CacheLine)); }

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

int fail(const char* what, const char* why) {
  std::fprintf(stderr, "draw_in_host_frame: %s: %s\n", what, why);
  return EXIT_FAILURE;
}

/// One head, 1.6 m above the ground.
coif::HeadPose head_pose() {
  coif::HeadPose pose;
  pose.position[1] = 1.6;
  return pose;
}

/// Creates the hair of one head and lets it hang for a second.
coif::Status settle(const coif::Asset& asset, Memory& memory, coif::Hair& hair) {
  const coif::MemoryNeed need = coif::Hair::memory_need(asset, {});
  memory = allocate(need.bytes);
  coif::Status status = hair.create(asset, {}, use(memory, need.bytes));
  if (status == coif::Status::kOk) status = hair.reset(0, head_pose());
  for (int frame = 0; frame < 60 && status == coif::Status::kOk; ++frame) status = hair.step({});
  return status;
}

/// The engine's camera and lights, as coif wants them.
coif::DrawDesc description(const host::Camera& camera, std::span<const coif::Light> lights) {
  coif::DrawDesc desc;
  const auto matrix = camera.clip_from_world();
  for (std::size_t i = 0; i < matrix.size(); ++i) desc.clip_from_world[i] = matrix[i];
  desc.eye = {camera.eye[0], camera.eye[1], camera.eye[2]};
  desc.lights = lights;
  desc.framebuffer_is_srgb = true;  // the colour texture's format is GL_SRGB8_ALPHA8
  return desc;
}

/// The frame after each of its parts.
struct Stages {
  host::Pixels solid, hair, pane;
  bool is_undisturbed = false;  ///< The engine's target, viewport and scissor after the hair.
};

constexpr host::Rectangle kPost{-0.06f, 1.2f, -0.02f, 2.0f, 0.3f, {0.6f, 0.6f, 0.6f, 1.0f}};  // before the hair
constexpr host::Rectangle kPane{-2.0f, 0.0f, 2.0f, 4.0f, -0.4f, {0.9f, 0.8f, 0.1f, 0.5f}};    // behind it

coif::Status draw_frame(const host::Frame& frame, coif::HairRenderer& renderer, const coif::HairModel& model,
                        const coif::Hair& hair, Stages& stages) {
  const host::Camera camera;
  const coif::Light sun{.from = {0.3f, 1.0f, 0.6f}};
  frame.begin();
  frame.draw(camera, kPost);  // solid things come first: their depth hides the hair behind them
  stages.solid = frame.read();

  // draw() resets the state that its header names to OpenGL's initial values and changes nothing else. An engine that
  // caches the state has to forget that part of it here.
  const coif::HairInstance head{head_pose(), hair.palette(0)};
  const coif::Status status = renderer.draw(model, {&head, 1}, description(camera, {&sun, 1}));
  stages.is_undisturbed = frame.is_as_begun();
  stages.hair = frame.read();

  frame.draw(camera, kPane);  // transparent things come last: the hair has written its depth and stays in front
  stages.pane = frame.read();
  return status;
}

struct Counts {
  int hair = 0;         ///< Pixels that the hair changed.
  int over_post = 0;    ///< Those on the post; there must be none, since the post is nearer.
  int before_pane = 0;  ///< Those that the pane left unchanged: solid hair before it.
  int tinted = 0;       ///< Pixels that the pane changed.
};

Counts count(const Stages& stages) {
  const std::uint32_t background = stages.solid.front();
  Counts counts;
  for (std::size_t i = 0; i < stages.solid.size(); ++i) {
    const bool is_hair = stages.hair[i] != stages.solid[i], is_tinted = stages.pane[i] != stages.hair[i];
    counts.hair += is_hair;
    counts.over_post += is_hair && stages.solid[i] != background;
    counts.before_pane += is_hair && !is_tinted;
    counts.tinted += is_tinted;
  }
  return counts;
}

int report(const Stages& stages) {
  const Counts counts = count(stages);
  std::printf("%d pixels of hair, %d over the post before it, %d solid before the pane behind it; %d tinted\n",
              counts.hair, counts.over_post, counts.before_pane, counts.tinted);
  if (!stages.is_undisturbed) return fail("draw", "the engine's target, viewport or scissor is another one");
  if (counts.over_post > 0) return fail("draw", "hair behind the post is seen");
  return EXIT_SUCCESS;
}

int run(const coif::Asset& asset) {
  Memory memory;
  coif::Hair hair;
  if (const coif::Status status = settle(asset, memory, hair); status != coif::Status::kOk) {
    return fail("simulate", coif::describe(status));
  }
  host::Context context;
  host::Frame frame;
  if (!context.open()) return fail("skipped", "no OpenGL ES 3.0 here");
  if (!frame.create()) return fail("framebuffer", "the driver refuses it");

  coif::HairRenderer renderer;
  coif::HairModel model;
  if (renderer.create(host::Context::loader()) != coif::Status::kOk) return fail("create", renderer.failure());
  if (model.upload(renderer, asset) != coif::Status::kOk) return fail("upload", renderer.failure());
  Stages stages;
  const coif::Status status = draw_frame(frame, renderer, model, hair, stages);
  model.destroy();  // while the context lives
  renderer.destroy();
  return status == coif::Status::kOk ? report(stages) : fail("draw", coif::describe(status));
}

}  // namespace

int main(int argument_count, char** arguments) {
  if (argument_count != 2) return fail("usage", "draw_in_host_frame FILE.coif");
  Memory file;
  const std::span<std::byte> bytes = read_file(arguments[1], file);
  coif::Asset asset;
  if (const coif::LoadStatus status = asset.open(bytes); !status)
    return fail(arguments[1], coif::describe(status.code));
  return run(asset);
}
