#include "import/reader_process.h"

#include "base/files.h"
#include "base/json.h"
#include "platform/child_process.h"
#include "platform/job.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>

namespace coif::importer {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

tl::unexpected<ToolError> explain(const platform::ChildResult& result, const fs::path& path,
                                  const ImportSettings& settings) {
  using Kind = ToolError::Kind;
  switch (result.end) {
    case platform::ChildResult::End::kTooSlow:
      return file_failure(Kind::kBadInput, path, "the importer exceeded {} s; {}", settings.max_seconds, kReduce);
    case platform::ChildResult::End::kOutOfMemory:
    case platform::ChildResult::End::kTooMuchOutput:
      return file_failure(Kind::kBadInput, path, "the importer exceeded {} MiB of memory; {}",
                          settings.max_memory_bytes >> 20, kReduce);
    case platform::ChildResult::End::kNotStarted:
      if (result.code == EMFILE || result.code == ENFILE) {
        return file_failure(
            Kind::kFileAccess, path,
            "cannot start the import process: {}; nothing is wrong with the file: allow more open files ('ulimit -n')",
            std::strerror(result.code));
      }
      return file_failure(Kind::kInternal, path, "cannot start the import process: {}", std::strerror(result.code));
    case platform::ChildResult::End::kCrashed:
    case platform::ChildResult::End::kFinished: break;
  }
  return file_failure(Kind::kBadInput, path, "the importer crashed ({} {}); {}",
                      result.by_signal ? "signal" : "exit status", result.code, kReexport);
}

}  // namespace

tl::expected<platform::Bytes, ToolError> read_in_child(const platform::Job& job, const fs::path& path,
                                                       const ImportSettings& settings) {
  const platform::Bytes request = json::to_msgpack({{"path", path.string()}, {"settings", import_document(settings)}});
  const platform::ChildSettings child{platform::ChildKind::kReader,
                                      {settings.max_memory_bytes, settings.max_seconds, settings.max_memory_bytes},
                                      settings.stop};
  platform::ChildResult result = platform::run_in_child(job, request, child);
  const bool is_finished = result.end == platform::ChildResult::End::kFinished;
  if (is_finished && result.output.empty() && settings.requires_sandbox) {
    const std::string missing = platform::missing_sandbox();
    return file_failure(
        ToolError::Kind::kUnsupported, path,
        "was not read: {}, and --require-sandbox asks for a locked-up reader; use Linux 5.13 or later with Landlock "
        "and seccomp, or leave --require-sandbox out",
        missing.empty() ? "the process that reads it could not be locked up" : missing);
  }
  if (is_finished) return std::move(result.output);
  return explain(result, path, settings);
}

platform::Bytes answer_read(const platform::JobCall& call,
                            platform::Bytes (*read)(const fs::path& path, const ImportSettings& settings)) {
  const json request = json::from_msgpack(call.request());
  const fs::path path = request.at("path").get<std::string>();
  const ImportSettings settings = import_settings_from(request.at("settings"));
  const bool is_locked_up = platform::lock_up(folders_of_source(path, settings.roots), path);
  if (!is_locked_up && settings.requires_sandbox) return {};
  return read(path, settings);
}

json import_document(const ImportSettings& s) {
  std::vector<std::string> roots;
  for (const fs::path& root : s.roots) roots.push_back(root.string());
  return {{"metres_per_unit", s.metres_per_unit ? json(*s.metres_per_unit) : json(nullptr)},
          {"up_axis", s.up_axis ? json(int(*s.up_axis)) : json(nullptr)},
          {"roots", roots},
          {"variant", s.variant},
          {"meshes", s.meshes},
          {"max_memory_bytes", s.max_memory_bytes},
          {"max_seconds", s.max_seconds},
          {"max_file_bytes", s.max_file_bytes},
          {"requires_sandbox", s.requires_sandbox}};
}

ImportSettings import_settings_from(const json& document) {
  ImportSettings s;
  if (const json& unit = document.at("metres_per_unit"); !unit.is_null()) s.metres_per_unit = unit.get<double>();
  if (const json& axis = document.at("up_axis"); !axis.is_null()) s.up_axis = UpAxis(axis.get<int>());
  for (const json& root : document.at("roots")) s.roots.emplace_back(root.get<std::string>());
  document.at("variant").get_to(s.variant);
  document.at("meshes").get_to(s.meshes);
  document.at("max_memory_bytes").get_to(s.max_memory_bytes);
  document.at("max_seconds").get_to(s.max_seconds);
  document.at("max_file_bytes").get_to(s.max_file_bytes);
  document.at("requires_sandbox").get_to(s.requires_sandbox);
  return s;
}

tl::unexpected<ToolError> senseless_answer(const fs::path& path) {
  return file_failure(ToolError::Kind::kBadInput, path, "the importer crashed (its answer makes no sense); {}",
                      kReexport);
}

}  // namespace coif::importer
