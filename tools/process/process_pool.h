#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace coif {

/// Calls work(i) for each i below `count` in a process of its own, up to `jobs` at once, and returns what each call
/// returned, in their order; nothing for a process that crashed, was killed or could not be started. The processes are forks:
/// call before starting threads, and while no other child is waited for. What `work` prints goes where this process prints.
[[nodiscard]] std::vector<std::optional<std::string>> run_in_processes(
    std::size_t count, unsigned jobs, const std::function<std::string(std::size_t)>& work);

}  // namespace coif
