#include "platform/job.h"

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace coif::platform {
namespace {

// System calls that the headers of the oldest supported system do not name.
#if defined(__x86_64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_X86_64;
constexpr std::uint32_t kOtherCalls = 0x40000000;  // The ABI x32 in the same process.
#elif defined(__aarch64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_AARCH64;
constexpr std::uint32_t kOtherCalls = 0;
#else
constexpr std::uint32_t kArchitecture = 0;
constexpr std::uint32_t kOtherCalls = 0;
#endif

// Numbers of calls that are the same on all architectures.
constexpr int kPidfdSendSignal = 424, kIoUringSetup = 425, kIoUringEnter = 426, kIoUringRegister = 427, kOpenTree = 428,
              kMoveMount = 429, kFsopen = 430, kFsconfig = 431, kFsmount = 432, kFspick = 433, kPidfdOpen = 434,
              kClone3 = 435, kPidfdGetfd = 438, kProcessMadvise = 440, kMountSetattr = 442, kProcessMrelease = 448;

/// Refused with any arguments: sockets, other programs, other processes, and the kernel's rarer parts.
constexpr int kRefused[] = {
    SYS_socket,
    SYS_socketpair,
    SYS_connect,
    SYS_bind,
    SYS_listen,
    SYS_accept,
    SYS_accept4,
    SYS_sendto,
    SYS_sendmsg,
    SYS_sendmmsg,
    SYS_recvfrom,
    SYS_recvmsg,
    SYS_recvmmsg,
    SYS_execve,
    SYS_execveat,
    SYS_ptrace,
    SYS_process_vm_readv,
    SYS_process_vm_writev,
    SYS_kcmp,
    SYS_rt_sigqueueinfo,
    SYS_rt_tgsigqueueinfo,
    SYS_setns,
    SYS_unshare,
    SYS_mount,
    SYS_umount2,
    SYS_pivot_root,
    SYS_chroot,
    SYS_bpf,
    SYS_perf_event_open,
    SYS_userfaultfd,
    SYS_keyctl,
    SYS_add_key,
    SYS_request_key,
    SYS_init_module,
    SYS_finit_module,
    SYS_delete_module,
    SYS_kexec_load,
    SYS_reboot,
    SYS_swapon,
    SYS_swapoff,
    SYS_open_by_handle_at,
    SYS_name_to_handle_at,
    SYS_fanotify_init,
    SYS_migrate_pages,
    SYS_move_pages,
    SYS_setpriority,
    SYS_ioprio_set,
    SYS_sched_setscheduler,
    SYS_sched_setparam,
    SYS_sched_setattr,
    SYS_quotactl,
    SYS_acct,
    SYS_msgget,
    SYS_semget,
    SYS_shmget,
    SYS_mq_open,
    kPidfdSendSignal,
    kPidfdOpen,
    kPidfdGetfd,
    kProcessMadvise,
    kProcessMrelease,
    kIoUringSetup,
    kIoUringEnter,
    kIoUringRegister,
    kOpenTree,
    kMoveMount,
    kFsopen,
    kFsconfig,
    kFsmount,
    kFspick,
    kMountSetattr,
#if defined(__x86_64__)
    SYS_fork,
    SYS_vfork,
    SYS_uselib,
    SYS_iopl,
    SYS_ioperm,
    SYS_modify_ldt,
    SYS_kexec_file_load,
#endif
};

/// Refused unless they are about this process itself, which their first argument names.
constexpr int kOfItself[] = {SYS_kill, SYS_tgkill, SYS_prlimit64, SYS_sched_setaffinity};

using Program = std::vector<sock_filter>;

void load(Program& program, std::size_t offset) {
  program.push_back(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, std::uint32_t(offset)));
}
void refuse(Program& program, int why) {
  program.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | (std::uint32_t(why) & SECCOMP_RET_DATA)));
}
void allow(Program& program) { program.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)); }

/// Offset of the argument's lower half, which is all of an int. Both architectures are little endian.
constexpr std::size_t argument(std::size_t i) { return offsetof(seccomp_data, args) + 8 * i; }

/// Call `number`, where the value at `offset` is neither of two, is refused.
void allow_only(Program& program, int number, std::size_t offset, std::uint32_t value, std::uint32_t or_else) {
  program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, std::uint32_t(number), 0, 5));
  load(program, offset);
  program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, 2, 0));
  program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, or_else, 1, 0));
  refuse(program, EPERM);
  allow(program);
}

/// Call `number` with one of `values` as its second argument is refused.
void refuse_second(Program& program, int number, std::initializer_list<std::uint32_t> values) {
  const auto count = std::uint8_t(values.size());
  program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, std::uint32_t(number), 0, std::uint8_t(count + 3)));
  load(program, argument(1));
  std::uint8_t left = count;
  for (const std::uint32_t value : values) program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, left--, 0));
  allow(program);
  refuse(program, EPERM);
}

Program make_program() {
  Program program;
  load(program, offsetof(seccomp_data, arch));
  program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, kArchitecture, 1, 0));
  refuse(program, EPERM);
  load(program, offsetof(seccomp_data, nr));
  if (kOtherCalls != 0) {
    program.push_back(BPF_JUMP(BPF_JMP | BPF_JGE | BPF_K, kOtherCalls, 0, 1));
    refuse(program, ENOSYS);
  }
  for (const int number : kRefused) {
    program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, std::uint32_t(number), 0, 1));
    refuse(program, EPERM);
  }
  // Threads are no processes. The C library uses clone() where clone3(), whose flags lie in memory, does not exist.
  program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, std::uint32_t(kClone3), 0, 1));
  refuse(program, ENOSYS);
  program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, std::uint32_t(SYS_clone), 0, 4));
  load(program, argument(0));
  program.push_back(BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, CLONE_THREAD, 1, 0));
  refuse(program, EPERM);
  allow(program);
  // A descriptor can be made to send signals, too.
  constexpr std::uint32_t kSetOwner = 8, kSetSignal = 10, kSetOwnerOfKind = 15, kInjectKey = 0x5412;
  refuse_second(program, SYS_fcntl, {kSetOwner, kSetSignal, kSetOwnerOfKind});
  refuse_second(program, SYS_ioctl, {kInjectKey});
  const auto self = std::uint32_t(getpid());
  for (const int number : kOfItself) {
    // For a signal, 0 means the whole group.
    const bool takes_zero = number == SYS_prlimit64 || number == SYS_sched_setaffinity;
    allow_only(program, number, argument(0), self, takes_zero ? 0 : self);
  }
  const auto thread = std::uint32_t(syscall(SYS_gettid));
  allow_only(program, SYS_tkill, argument(0), thread, thread);
  allow(program);
  return program;
}

}  // namespace

bool filter_calls() {
  if (kArchitecture == 0 || prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return false;
  Program program = make_program();
  const sock_fprog filter{static_cast<unsigned short>(program.size()), program.data()};
  return prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter, 0, 0) == 0;
}

}  // namespace coif::platform
