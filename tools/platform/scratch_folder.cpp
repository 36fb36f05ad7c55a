#include "platform/files.h"

#include "platform/spawn.h"

#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>
#include <cerrno>
#include <string>

namespace coif::platform {
namespace {

namespace fs = std::filesystem;

/// Removes the folder once nobody holds the other end of the line any more: its owner has closed it, or is gone.
Bytes keep_folder(const JobCall& call) {
  setsid();  // Signals from a terminal to the program must not reach this process.
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE}) signal(number, SIG_IGN);
  const fs::path folder(std::string(call.request().begin(), call.request().end()));
  call.note("");
  call.wait_for_end();
  std::error_code ignored;
  fs::remove_all(folder, ignored);
  return {};
}

const Job kKeepFolder("keep scratch folder", keep_folder);

tl::unexpected<FolderFault> no_folder(const fs::path& place, std::error_code why) {
  return tl::unexpected(FolderFault{place, why});
}

}  // namespace

/// The process that removes the folder.
class ScratchFolder::Keeper {
 public:
  explicit Keeper(const std::string& folder) : spawned_(spawn(kKeepFolder, true)) {
    if (spawned_.error != 0) return;
    JobHeader header;
    header.request_bytes = folder.size();
    header.outlives = 1;
    const int line = spawned_.line.get();
    std::error_code why = write_all(line, std::as_bytes(std::span(&header, 1)));
    if (!why) why = write_all(line, std::as_bytes(std::span(folder)));
    // Its note means that it ignores signals now.
    JobFrame frame;
    if (!why && ::read(line, &frame, sizeof frame) != ssize_t(sizeof frame))
      why = std::make_error_code(std::errc::io_error);
    spawned_.error = why.value();
  }
  Keeper(const Keeper&) = delete;
  Keeper& operator=(const Keeper&) = delete;
  ~Keeper() {
    (void)spawned_.line.close();
    while (spawned_.process > 0 && waitpid(spawned_.process, nullptr, 0) < 0 && errno == EINTR) {
    }
  }

  [[nodiscard]] std::error_code fault() const { return {spawned_.error, std::generic_category()}; }

 private:
  Spawned spawned_;
};

ScratchFolder::ScratchFolder(fs::path path, std::unique_ptr<Keeper> keeper)
    : path_(std::move(path)), keeper_(std::move(keeper)) {}
ScratchFolder::ScratchFolder(ScratchFolder&&) noexcept = default;
ScratchFolder::~ScratchFolder() = default;

tl::expected<ScratchFolder, FolderFault> ScratchFolder::create() {
  std::error_code error;
  const fs::path place = fs::temp_directory_path(error);
  if (error) return no_folder("TMPDIR", error);
  std::string name = (place / "coif-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) return no_folder(place, last_error());
  auto keeper = std::make_unique<Keeper>(name);
  if (const std::error_code why = keeper->fault()) {
    fs::remove(name, error);
    return no_folder(place, why);
  }
  return ScratchFolder(name, std::move(keeper));
}

}  // namespace coif::platform
