#include "cli/batch_summary.h"

#include "cli/json_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace coif {
namespace {

std::string line_of(const Outcomes& file, std::size_t width) {
  const bool done = is_cooked(file);
  const auto figure = [&](const char* key) { return done ? fmt::format("{}", file[key].get<std::uint64_t>()) : "-"; };
  const char* from_cache = !done ? "-" : file["from_cache"].get<bool>() ? "yes" : "no";
  return fmt::format("{:{}}  {:14}  {:>9}  {:>10}  {:>8.0f}  {}\n", file["source"].get<std::string>(), width,
                     file["status"].get<std::string>(), figure("triangles"), figure("bytes"), file["ms"].get<double>(),
                     from_cache);
}

}  // namespace

bool is_cooked(const nlohmann::ordered_json& outcome) { return outcome["exit_code"] == 0; }

BatchCounts count(const Outcomes& outcomes) {
  BatchCounts counts{.asked = outcomes.size()};
  for (const auto& file : outcomes) {
    const bool done = is_cooked(file);
    ++(done ? counts.cooked : counts.failed);
    if (done && file["from_cache"].get<bool>()) ++counts.from_cache;
  }
  return counts;
}

std::string sentence(const BatchCounts& counts) {
  return fmt::format("{} asked, {} cooked ({} from the cache), {} failed", counts.asked, counts.cooked,
                     counts.from_cache, counts.failed);
}

std::string batch_json(const Outcomes& outcomes) {
  const BatchCounts counts = count(outcomes);
  return json_text({{"asked", counts.asked},
                    {"cooked", counts.cooked},
                    {"from_cache", counts.from_cache},
                    {"failed", counts.failed},
                    {"files", outcomes}});
}

std::string batch_text(const Outcomes& outcomes) {
  std::size_t width = 4;
  for (const auto& file : outcomes) width = std::max(width, file["source"].get_ref<const std::string&>().size());
  std::string text = fmt::format("{:{}}  {:14}  {:>9}  {:>10}  {:>8}  {}\n", "file", width, "status", "triangles",
                                 "bytes", "ms", "from cache");
  for (const auto& file : outcomes) text += line_of(file, width);
  return text + sentence(count(outcomes)) + "\n";
}

}  // namespace coif
