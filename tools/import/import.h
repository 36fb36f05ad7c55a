#pragma once

#include "base/tool_error.h"
#include "import/source_model.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace coif::importer {

enum class UpAxis { kX, kY, kZ };

/// The rotation from axes in which `up` points up to those in which Y does.
[[nodiscard]] Eigen::Matrix3d y_up_from(UpAxis up);

struct ImportSettings {
  std::optional<double> metres_per_unit;  ///< Overrides the file's unit.
  std::optional<UpAxis> up_axis;          ///< Overrides the file's axis.
  /// Folders besides the model's own in which files that it names may lie, through links or paths with "..".
  std::vector<std::filesystem::path> roots;
  std::string variant;  ///< One of a glTF's KHR_materials_variants; empty: the materials that its meshes name.
  /// Names of wanted meshes, with * and ?; they decide which of several levels of detail is kept
  /// (keep_finest_levels()).
  std::vector<std::string> meshes;
  // Limits of the child process that parses the file. A file that exceeds one is refused; nothing else happens.
  /// In addition to this process's memory; no limit under ASan.
  std::uint64_t max_memory_bytes = std::uint64_t{4} << 30;
  std::uint32_t max_seconds = 120;  ///< Processor and wall-clock time.
  std::uint64_t max_file_bytes = std::uint64_t{1} << 30;
  bool requires_sandbox = false;  ///< Read nothing where this machine cannot lock up the child process.
  std::stop_token stop{};         ///< Requested: the child process is ended, and Stopped thrown.
};

/// Name and version of the library that reads sources, for example "assimp 5.2.4".
[[nodiscard]] std::string importer_name();
/// Records the importer's version in a model, for all formats: the version of the library that reads files other than
/// glTF.
void set_importer(SourceModel& model);

/// Reads the meshes of an FBX, glTF, GLB, VRM, OBJ or DAE. The parser runs in a child process under limits: third-party
/// importers crash on hostile files. Errors: kFileAccess (absent, unreadable), kBadInput (not parseable, crash, limit,
/// no triangles), kUnsupported (suffix or variant not known). Throws Stopped alone, where settings.stop is requested.
/// Blocks. The program's main() calls run_named_job() (platform/job.h).
tl::expected<SourceModel, ToolError> import_model(const std::filesystem::path& path,
                                                  const ImportSettings& settings = {});

/// File families that differ in how the importer treats units, axes and materials.
enum class SourceFormat { kFbx, kGltf, kObj, kDae, kHair, kTressFx };

struct SourceSuffix {
  const char* suffix;  ///< Lower case, with the dot.
  SourceFormat format;
};

/// The format's name for people.
[[nodiscard]] const char* format_name(SourceFormat format);

/// The entry for the path's suffix, whatever its case; none for a suffix that is not supported.
[[nodiscard]] std::optional<SourceSuffix> find_suffix(const std::filesystem::path& path);

/// ".fbx, .gltf, ..." for messages.
[[nodiscard]] std::string supported_suffixes();

// Checks before a file is read, and the cures in messages about it.

inline constexpr const char* kReexport = "open it in a modelling tool and export it again, best as glTF (.glb)";
inline constexpr const char* kReduce = "export only the hair and the head, best as glTF (.glb)";

/// Whether a model file can be read at all. Errors: kFileAccess (absent, no regular file, no permission), kBadInput
/// (empty, or above `max_bytes`).
[[nodiscard]] tl::expected<void, ToolError> check_readable(const std::filesystem::path& path, std::uint64_t max_bytes);

/// Looks through a COLLADA document for an accessor that reads beyond the end of its array. assimp 5.2 does so, and
/// what it finds there differs from run to run. None where all fit; else a sentence without the file's name. Text that
/// is not XML is left for assimp to refuse, which parses with the same library. Throws std::bad_alloc where memory runs
/// out. Source: Khronos, "COLLADA 1.4.1 Specification", chapter 5, <accessor>.
[[nodiscard]] std::optional<std::string> overrun_array(std::string_view document);

}  // namespace coif::importer
