#include "validate/asset_issues.h"

#include "validate/asset_checks.h"
#include "write/chunk_file.h"

#include <fmt/format.h>

namespace coif {
namespace {

std::string place(const LoadStatus& status) {
  if (status.chunk == 0) return "";
  const std::string chunk = "chunk " + chunk_name(status.chunk);
  return status.code == LoadCode::kHash ? chunk : fmt::format("{}, record {}", chunk, status.item);
}

}  // namespace

std::string describe_text(const LoadStatus& status) {
  if (status.code == LoadCode::kMagic) return describe(status.code);  // the first byte of a text tells nobody anything
  char text[256];
  return std::string(text, describe(status, text, sizeof text));
}

std::vector<Issue> find_asset_issues(const Asset& asset) {
  Issues issues;
  for (const auto check : {check_bones, check_dynamics, check_geometry, check_patches, check_orders, check_skin,
                           check_textures, check_alpha, check_unwrapping, check_quality}) {
    check(asset, issues);
  }
  return issues;
}

Issue refusal_issue(const LoadStatus& status) {
  return make_issue(fmt::format("A{}", 100 + int(status.code)), describe_text(status), place(status));
}

}  // namespace coif
