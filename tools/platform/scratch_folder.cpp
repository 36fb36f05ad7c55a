#include "platform/scratch_folder.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

namespace coif {
namespace {

namespace fs = std::filesystem;

tl::unexpected<FolderFault> no_folder(const fs::path& place, int why) {
  return tl::unexpected(FolderFault{place, {why, std::generic_category()}});
}

/// Until nobody can write into the pipe any more: all processes that could are gone, or the folder's owner closed it.
[[noreturn]] void keep(int descriptor, const fs::path& folder) {
  setsid();  // what a terminal sends to the program is not for this one
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE}) signal(number, SIG_IGN);
  const int null = open("/dev/null", O_RDWR);
  for (const int standard : {0, 1, 2})
    dup2(null, standard);  // whoever reads what the program prints need not wait for this one
  char byte;
  while (read(descriptor, &byte, 1) < 0 && errno == EINTR) {
  }
  std::error_code ignored;
  fs::remove_all(folder, ignored);
  _exit(0);
}

}  // namespace

tl::expected<ScratchFolder, FolderFault> ScratchFolder::create() {
  std::error_code error;
  const fs::path place = fs::temp_directory_path(error);
  if (error) return no_folder("TMPDIR", error.value());
  std::string name = (place / "coif-XXXXXX").string();
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return no_folder(place, errno);
  const auto fail = [&](int why) {
    close(ends[0]);
    close(ends[1]);
    return no_folder(place, why);
  };
  if (mkdtemp(name.data()) == nullptr) return fail(errno);
  const pid_t keeper = fork();
  if (keeper == 0) {
    close(ends[1]);
    keep(ends[0], name);
  }
  if (keeper < 0) {
    const int why = errno;
    fs::remove(name, error);
    return fail(why);
  }
  close(ends[0]);
  return ScratchFolder(name, ends[1], keeper);
}

ScratchFolder::ScratchFolder(ScratchFolder&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)), keeper_(other.keeper_) {}

ScratchFolder::~ScratchFolder() {
  if (descriptor_ < 0) return;
  close(descriptor_);
  while (waitpid(keeper_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

}  // namespace coif
