#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace coif {

struct ChildLimits {
  std::uint64_t memory_bytes = 0;  ///< Address space that the child may add to what it inherits.
  std::uint32_t seconds = 0;       ///< Processor time, and wall-clock time beside it.
  std::uint64_t output_bytes = 0;  ///< What the child may send back.
};

struct ChildResult {
  enum class End {
    kFinished,     ///< `output` is complete as far as the child is honest; check it all the same.
    kCrashed,      ///< `code`: the signal, or the exit status where `by_signal` is false.
    kTooSlow,      ///< Ran past `seconds`.
    kOutOfMemory,  ///< An allocation failed in the child.
    kTooMuchOutput,
    kNotStarted,  ///< `code`: errno of pipe or fork.
  };
  End end = End::kNotStarted;
  int code = 0;
  bool by_signal = false;
  std::vector<std::uint8_t> output;  ///< Empty unless kFinished.
};

/// Runs `work` in a forked child under limits and returns the bytes that it returned. The child cannot write files,
/// holds no descriptor of this process but the pipe, prints nothing and dies with this process. Blocks until the child
/// is gone; leaves no zombie. Memory limits are off under AddressSanitizer, whose shadow needs terabytes of address
/// space. Throws TookTooLong, the child gone, where the time that this process may work (platform/work_limit.h) is over
/// while it waits. `work` must not rely on other threads: only the calling one exists in the child.
[[nodiscard]] ChildResult run_in_child(const ChildLimits& limits,
                                       const std::function<std::vector<std::uint8_t>()>& work);

/// False under AddressSanitizer, whose shadow needs terabytes of address space.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool kMemoryIsLimited = false;
#else
inline constexpr bool kMemoryIsLimited = true;
#endif

/// Bytes of address space that this process has, what it only reserved included.
[[nodiscard]] std::uint64_t address_space_in_use();

/// Bytes of address space that this process may have from now on; returns what it might have.
std::uint64_t swap_memory_limit(std::uint64_t bytes);

/// Calls work(i) for each i below `count` in a process of its own, up to `jobs` at once, and returns what each call
/// returned, in their order; nothing for a process that crashed, was killed or could not be started. The processes are
/// forks without limits: call before starting threads. What `work` prints goes where this process prints.
[[nodiscard]] std::vector<std::optional<std::string>> run_in_processes(
    std::size_t count, unsigned jobs, const std::function<std::string(std::size_t)>& work);

}  // namespace coif
