#include "validate/issue_codes.h"

#include "validate/code_tables.h"

#include <algorithm>
#include <cassert>
#include <tuple>

namespace coif {
namespace {

std::vector<IssueCode> all_codes() {
  std::vector<IssueCode> codes;
  for (const auto part : {refusal_codes(), asset_codes(), origin_codes()}) {
    codes.insert(codes.end(), part.begin(), part.end());
  }
  std::ranges::sort(codes, {}, [](const IssueCode& row) { return std::tuple(row.group, std::string_view(row.code)); });
  return codes;
}

}  // namespace

const char* name(Severity severity) {
  switch (severity) {
    case Severity::kInfo: return "info";
    case Severity::kWarning: return "warning";
    case Severity::kError: return "error";
  }
  return "error";
}

const char* name(IssueGroup group) {
  switch (group) {
    case IssueGroup::kContainer: return "container";
    case IssueGroup::kSkeleton: return "skeleton";
    case IssueGroup::kDynamics: return "dynamics";
    case IssueGroup::kGeometry: return "geometry";
    case IssueGroup::kPatches: return "patches";
    case IssueGroup::kOrders: return "orders";
    case IssueGroup::kSkin: return "skin";
    case IssueGroup::kTextures: return "textures";
    case IssueGroup::kQuality: return "quality";
    case IssueGroup::kSource: return "source";
  }
  return "unknown";
}

std::span<const IssueCode> issue_codes() {
  static const std::vector<IssueCode> codes = all_codes();
  return codes;
}

const IssueCode* find_issue_code(std::string_view code) {
  const auto found = std::ranges::find(issue_codes(), code, &IssueCode::code);
  return found == issue_codes().end() ? nullptr : &*found;
}

Issue make_issue(std::string_view code, std::string message, std::string where) {
  const IssueCode* row = find_issue_code(code);
  assert(row != nullptr && "an issue without a row in its table");
  return {
      std::string(code), row != nullptr ? row->severity : Severity::kError, std::move(message), std::move(where), {}};
}

}  // namespace coif
