// A game that knows only the installed package. With an asset: maps the file and steps one head for a second. Without:
// makes sure that something else is refused.
#include <coif/asset.h>
#include <coif/hair.h>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace {

/// The file's bytes where the system keeps them: nothing is copied, and a write into them would end the program. Empty
/// where that fails; unmapped when the program ends.
std::span<const std::byte> map_file(const char* path) {
  const int file = open(path, O_RDONLY);
  if (file < 0) return {};
  const off_t size = lseek(file, 0, SEEK_END);
  void* const bytes = size > 0 ? mmap(nullptr, std::size_t(size), PROT_READ, MAP_PRIVATE, file, 0) : MAP_FAILED;
  close(file);
  if (bytes == MAP_FAILED) return {};
  return {static_cast<const std::byte*>(bytes), std::size_t(size)};
}

bool refuses_text() {
  alignas(64) std::byte text[256] = {};
  coif::Asset asset;
  const coif::LoadStatus status = asset.open(text);
  std::printf("%s\n", coif::describe(status.code));
  return !status && !asset.is_open();
}

bool steps_for_a_second(const char* path) {
  coif::Asset asset;
  if (!asset.open(map_file(path))) return false;
  const coif::MemoryNeed need = coif::Hair::memory_need(asset, {});
  const std::size_t whole_lines = (need.bytes + need.alignment - 1) / need.alignment * need.alignment;
  auto* memory = static_cast<std::byte*>(std::aligned_alloc(need.alignment, whole_lines));
  coif::Hair hair;
  if (memory == nullptr || hair.create(asset, {}, {memory, need.bytes}) != coif::Status::kOk) return false;
  for (int frame = 1; frame <= 60; ++frame) {
    coif::HeadPose pose;
    pose.position[0] = 0.02 * frame;
    if (hair.set_head(0, pose) != coif::Status::kOk || hair.step({}) != coif::Status::kOk) return false;
  }
  std::printf("%u bones, last moved to x = %g m\n", hair.bone_count(), double(hair.palette(0).back().m[0][3]));
  return hair.palette(0).size() == asset.bones().size();
}

}  // namespace

int main(int argc, char** argv) {
  const bool good = refuses_text() && (argc < 2 || steps_for_a_second(argv[1]));
  return good ? 0 : 1;
}
