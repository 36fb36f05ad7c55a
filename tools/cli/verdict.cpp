#include "cli/verdict.h"

#include "base/json.h"
#include "base/text.h"
#include "render/picture.h"
#include "report/page/report_page.h"
#include "validate/issue_codes.h"

#include <fmt/format.h>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coif::cli {
namespace {

using nlohmann::ordered_json;

ordered_json folded_list(const std::vector<validate::FoldedIssues>& folded) {
  auto list = ordered_json::array();
  for (const validate::FoldedIssues& more : folded) {
    list.push_back({{"code", more.code}, {"severity", name(more.severity)}, {"count", more.count}});
  }
  return list;
}

const char* verdict_word(const Verdict& verdict) {
  if (!verdict.readable) return "unreadable";
  return verdict.issues.valid() ? "valid" : "invalid";
}

}  // namespace

std::string verdicts_json(const std::vector<Verdict>& verdicts) {
  auto files = ordered_json::array();
  for (const Verdict& verdict : verdicts) {
    const validate::JudgedIssues& issues = verdict.issues;
    files.push_back({{"path", verdict.path},
                     {"valid", issues.valid()},
                     {"errors", issues.errors},
                     {"warnings", issues.warnings},
                     {"infos", issues.infos},
                     {"issues", validate::issues_json(issues.shown)},
                     {"folded", folded_list(issues.folded)}});
  }
  return json_text({{"files", std::move(files)}});
}

std::string verdicts_text(const std::vector<Verdict>& verdicts) {
  std::string text;
  for (const Verdict& verdict : verdicts) {
    text += fmt::format("{}: {}\n", verdict.path, verdict_word(verdict));
  }
  return text;
}

namespace {

using nlohmann::ordered_json;

std::string meaning(const std::string& code) {
  const validate::IssueCode* row = validate::find_issue_code(code);
  return row == nullptr ? "" : fmt::format("{} {}", row->meaning, row->cure);
}

ordered_json issue_rows(const validate::JudgedIssues& issues) {
  ordered_json rows = ordered_json::array();
  for (const Diagnostic& issue : issues.shown) {
    ordered_json& row = rows.emplace_back(issue);
    row["meaning"] = meaning(issue.code);
  }
  for (const validate::FoldedIssues& more : issues.folded) {
    rows.push_back({{"code", more.code},
                    {"severity", name(more.severity)},
                    {"where", ""},
                    {"message", fmt::format("{} more like this", more.count)},
                    {"meaning", ""}});
  }
  return rows;
}

ordered_json file_json(const Verdict& verdict) {
  const validate::JudgedIssues& issues = verdict.issues;
  ordered_json pictures = ordered_json::array();
  for (const IssuePicture& picture : verdict.pictures.pictures) {
    const std::string caption = fmt::format("Patch {}, in red, from its own side.", picture.patch);
    pictures.push_back({{"caption", caption}, {"png", base64(picture.png)}});
  }
  return {
      {"path", verdict.path},
      {"verdict", fmt::format("{}: {}, {}, {}.", verdict_word(verdict), counted(issues.errors, "error", "errors"),
                              counted(issues.warnings, "warning", "warnings"), counted(issues.infos, "note", "notes"))},
      {"issues", issue_rows(issues)},
      {"pictures", pictures},
      {"why_no_pictures", verdict.pictures.why_none}};
}

}  // namespace

// The layout of the page: validate_page.json.
extern "C" const char coif_validate_page[];

std::string verdict_page(std::span<const Verdict> verdicts) {
  const auto valid = std::ranges::count_if(verdicts, [](const Verdict& v) { return v.issues.valid(); });
  ordered_json report{{"title", "coif validate"},
                      {"finding", fmt::format("{} of {} files are valid.", valid, verdicts.size())},
                      {"files", ordered_json::array()}};
  for (const Verdict& verdict : verdicts) report["files"].push_back(file_json(verdict));
  return report::page_html(report, coif_validate_page);
}

namespace {

constexpr std::size_t kMostPictures = 12;

std::vector<std::uint32_t> patches_of(std::span<const Diagnostic> issues) {
  std::vector<std::uint32_t> patches;
  for (const Diagnostic& issue : issues) {
    const bool known = issue.patch && std::ranges::find(patches, *issue.patch) != patches.end();
    if (issue.patch && !known && patches.size() < kMostPictures) patches.push_back(*issue.patch);
  }
  return patches;
}

Eigen::Vector3d middle_of(const Asset& asset, std::span<const std::uint32_t> corners) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const std::uint32_t corner : corners) {
    sum += Eigen::Vector3f(asset.vertices()[corner].position).cast<double>();
  }
  return sum / double(corners.size());
}

render::PictureSettings look_at(const Asset& asset, std::uint32_t patch) {
  render::PictureSettings settings;
  settings.width = settings.height = 360;
  settings.patches = true;
  while (settings.lod + 1 < asset.stored_lods().size() && patch >= asset.stored_lods()[settings.lod + 1].first_patch)
    ++settings.lod;
  settings.marked_patch = patch - (asset.stored_lods().empty() ? 0 : asset.stored_lods()[settings.lod].first_patch);
  const PatchRecord& record = asset.patches()[patch];
  const Eigen::Vector3d from = middle_of(asset, asset.indices().subspan(record.first_index, record.index_count)) -
                               middle_of(asset, asset.lod_indices(settings.lod));
  constexpr double kDegrees = 180 / std::numbers::pi;
  settings.yaw_degrees = std::atan2(from.x(), from.z()) * kDegrees;
  settings.pitch_degrees = std::clamp(std::atan2(from.y(), std::hypot(from.x(), from.z())) * kDegrees, -30.0, 60.0);
  settings.warm_up = false;
  return settings;
}

}  // namespace

IssuePictures picture_issues(const Asset& asset, std::span<const Diagnostic> issues) {
  IssuePictures result;
  const std::vector<std::uint32_t> patches = patches_of(issues);
  if (patches.empty()) return result;
  auto maker = render::PictureMaker::create(asset);
  if (!maker) {
    result.why_none = maker.error().message;
    return result;
  }
  for (const std::uint32_t patch : patches) {
    const auto picture = maker->take(look_at(asset, patch));
    if (!picture) {
      result.why_none = picture.error().message;
      return result;
    }
    result.pictures.push_back({patch, render::encode_png(*picture)});
  }
  return result;
}

}  // namespace coif::cli
