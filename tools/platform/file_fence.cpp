#include "platform/descriptor.h"
#include "platform/job.h"

#include <linux/landlock.h>
#include <linux/seccomp.h>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>

namespace coif::platform {
namespace {

// Rights by the version of Landlock that knows them; asking a kernel for one that it does not know is an error. Written
// as numbers where the headers of the oldest system that builds this lack the names.
constexpr std::uint64_t kRightsOfVersion1 = (1u << 13) - 1;
constexpr std::uint64_t kRefer = 1u << 13, kTruncate = 1u << 14, kDeviceControl = 1u << 15;
constexpr std::uint64_t kBindAndConnect = 3;
constexpr std::uint64_t kAbstractSockets = 1, kSignals = 2;

struct Ruleset {
  std::uint64_t files;
  std::uint64_t network;  // since version 4
  std::uint64_t scopes;   // since version 6
};

long landlock_version() { return syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION); }

Descriptor make_ruleset() {
  const long version = landlock_version();
  if (version < 1) return {};
  Ruleset all{kRightsOfVersion1, version >= 4 ? kBindAndConnect : 0, version >= 6 ? kAbstractSockets | kSignals : 0};
  if (version >= 2) all.files |= kRefer;
  if (version >= 3) all.files |= kTruncate;
  if (version >= 5) all.files |= kDeviceControl;
  const std::size_t known = version >= 6 ? sizeof all : version >= 4 ? offsetof(Ruleset, scopes) : sizeof all.files;
  return Descriptor(syscall(SYS_landlock_create_ruleset, &all, known, 0));
}

bool allow(const Descriptor& ruleset, const std::filesystem::path& path, std::uint64_t rights) {
  const Descriptor place(open(path.c_str(), O_PATH | O_CLOEXEC));
  if (!place.is_open()) return false;
  const landlock_path_beneath_attr rule{rights, place.get()};
  return syscall(SYS_landlock_add_rule, ruleset.get(), LANDLOCK_RULE_PATH_BENEATH, &rule, 0) == 0;
}

/// Whether the kernel takes filters of calls at all. A null filter is refused before anything changes.
bool has_call_filters() { return prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, nullptr, 0, 0) != 0 && errno == EFAULT; }

}  // namespace

std::string missing_sandbox() {
  if (landlock_version() < 1) return "this kernel has no Landlock, or it is turned off";
  if (!has_call_filters()) return "this kernel takes no filter of system calls (seccomp)";
  return {};
}

bool lock_up(const std::vector<std::filesystem::path>& folders, const std::filesystem::path& file) {
  const bool is_fenced = fence_files(folders, file);
  return filter_calls() && is_fenced;
}

bool fence_files(const std::vector<std::filesystem::path>& folders, const std::filesystem::path& file) {
  const Descriptor ruleset = make_ruleset();
  if (!ruleset.is_open()) return false;
  const auto readable = [&](const std::filesystem::path& folder) {
    return allow(ruleset, folder, LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR);
  };
  const bool allowed =
      std::ranges::all_of(folders, readable) && (file.empty() || allow(ruleset, file, LANDLOCK_ACCESS_FS_READ_FILE));
  return allowed && prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         syscall(SYS_landlock_restrict_self, ruleset.get(), 0) == 0;
}

}  // namespace coif::platform
