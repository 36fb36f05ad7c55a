#include "fuzz/lone_file.h"
#include "fuzz/promise.h"
#include "fuzz/targets.h"

#include "cache/manifest.h"

#include <set>

namespace coif::fuzz {

bool try_manifest(Input input) {
  static const LoneFile file("manifest.json");
  const auto requests = read_manifest(file.with(input), "out");
  if (!requests) {
    promise(requests.error().kind == ToolError::Kind::kBadInput, "a refusal is the manifest's fault");
    return false;
  }
  std::set<std::string> outputs;
  for (const CookRequest& request : *requests) {
    promise(request.output.starts_with("out/"), "no output leaves the folder");
    promise(request.output.find("/../") == std::string::npos, "no output climbs");
    promise(!request.output.ends_with('/'), "an output is a file");
    promise(outputs.insert(request.output).second, "no two assets have one output");
  }
  return true;
}

}  // namespace coif::fuzz
