#include "base/files.h"

#include "base/text.h"
#include "platform/program.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <new>
#include <random>
#include <system_error>

namespace coif {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kAlignment = 64;

tl::unexpected<ToolError> cannot_open(const fs::path& path, const std::error_code& why) {
  return file_failure(ToolError::Kind::kFileAccess, path, "cannot open: {}", why.message());
}

std::error_code last_error() { return {errno, std::generic_category()}; }

tl::expected<std::size_t, ToolError> readable_size(const fs::path& path) {
  std::error_code why;
  const auto status = fs::status(path, why);
  if (!fs::exists(status)) {
    return cannot_open(path, why ? why : std::make_error_code(std::errc::no_such_file_or_directory));
  }
  if (fs::is_directory(status)) return cannot_open(path, std::make_error_code(std::errc::is_a_directory));
  // A pipe has no size, and opening one would wait for a writer.
  if (!fs::is_regular_file(status)) {
    return file_failure(ToolError::Kind::kFileAccess, path, "cannot open: not a regular file");
  }
  const std::uintmax_t size = fs::file_size(path, why);
  if (why) return cannot_open(path, why);
  if (size > FileBytes::kMaxBytes) {
    return file_failure(ToolError::Kind::kBadInput, path, "{} bytes are more than the {} that are accepted", size,
                        FileBytes::kMaxBytes);
  }
  return static_cast<std::size_t>(size);
}

}  // namespace

FileBytes::FileBytes(std::size_t size) : size_(size) {
  bytes_.reset(static_cast<std::byte*>(std::aligned_alloc(kAlignment, (size / kAlignment + 1) * kAlignment)));
  if (!bytes_) throw std::bad_alloc();
}

FileBytes FileBytes::copy(std::span<const std::byte> bytes) {
  FileBytes result(bytes.size());
  std::ranges::copy(bytes, result.bytes_.get());
  return result;
}

tl::expected<FileBytes, ToolError> FileBytes::read(const fs::path& path) {
  const auto size = readable_size(path);
  if (!size) return tl::unexpected(size.error());
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) return cannot_open(path, last_error());

  FileBytes result(*size);
  if (std::fread(result.bytes_.get(), 1, *size, file.get()) != *size) {
    return file_failure(ToolError::Kind::kFileAccess, path, "cannot read");
  }
  return result;
}

bool is_lfs_pointer(std::string_view bytes) {
  return bytes.size() < 1024 && bytes.starts_with("version https://git-lfs.github.com/spec/");
}

std::vector<fs::path> folders_of_source(const fs::path& source, std::span<const fs::path> roots) {
  const auto here = [](const fs::path& folder) { return folder.empty() ? fs::path(".") : folder; };
  std::error_code error;
  std::vector<fs::path> folders{fs::canonical(here(source.parent_path()), error)};
  if (error) return {};
  const fs::path real = fs::canonical(source, error);
  if (!error) folders.push_back(real.parent_path());
  for (const fs::path& root : roots) {
    const fs::path place = fs::canonical(here(root), error);
    if (!error) folders.push_back(place);
  }
  return folders;
}

bool lies_in(const fs::path& file, std::span<const fs::path> folders) {
  std::error_code error;
  const fs::path real = fs::canonical(file, error);
  if (error) return false;
  return std::ranges::any_of(
      folders, [&](const fs::path& folder) { return std::ranges::mismatch(folder, real).in1 == folder.end(); });
}

namespace {

tl::unexpected<ToolError> cannot_write(const fs::path& path, const std::string& why) {
  return file_failure(ToolError::Kind::kFileAccess, path, "cannot write: {}", why);
}

}  // namespace

std::string file_identity(const fs::path& path) {
  if (path.empty()) return {};
  if (auto number = platform::file_number(path)) return *number;
  std::error_code error;
  const fs::path place = fs::weakly_canonical(fs::absolute(path, error), error);
  return (error ? path : place).string();
}

tl::expected<void, ToolError> check_output(const fs::path& output, std::initializer_list<fs::path> inputs) {
  return check_output(output, std::span(inputs.begin(), inputs.size()));
}

tl::expected<void, ToolError> check_output(const fs::path& output, std::span<const fs::path> inputs) {
  std::error_code ignored;
  if (output == "-") {
    return usage("-: nothing is written to the standard output but text; name a file, or ./- for one of that name");
  }
  if (fs::is_directory(output, ignored)) return cannot_write(output, "it is a folder; name a file in it");
  const fs::path folder = output.has_parent_path() ? output.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, ignored)) {
    return cannot_write(output, fmt::format("no folder '{}'; create it first", folder.string()));
  }
  const std::string place = file_identity(output);
  for (const fs::path& input : inputs) {
    if (input.empty() || file_identity(input) != place) continue;
    const std::string as_what = output == input ? "" : fmt::format(" ('{}')", input.string());
    return file_failure(ToolError::Kind::kUsage, output, "is also an input{}; choose another output", as_what);
  }
  return {};
}

tl::expected<void, ToolError> check_outputs(std::span<const NamedOutput> outputs, std::span<const fs::path> inputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (outputs[i].path.empty()) continue;
    for (std::size_t k = 0; k < i; ++k) {
      if (file_identity(outputs[i].path) == file_identity(outputs[k].path))
        return usage(fmt::format("{} and {} name the same file", outputs[i].option, outputs[k].option));
    }
    if (auto checked = check_output(outputs[i].path, inputs); !checked) return checked;
  }
  return {};
}

tl::expected<std::string, ToolError> choose_suffix(const fs::path& output,
                                                   std::initializer_list<std::string_view> allowed) {
  const std::string suffix = lower_case(output.extension().string());
  if (std::find(allowed.begin(), allowed.end(), suffix) != allowed.end()) return suffix;
  return file_failure(ToolError::Kind::kUsage, output, "the suffix must be {}", fmt::join(allowed, " or "));
}

namespace {

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

/// The part of a file's name that leaves room for the suffix of temporary_name().
std::string stem_of_temporary(const std::string& name) {
  constexpr std::size_t kLongestName = 255, kAdded = 32;  // NAME_MAX, which all usual file systems have
  return name.substr(0, kLongestName - kAdded);
}

/// "NAME.PROCESS.RANDOM.tmp", in the same folder as NAME.
std::string temporary_name(const std::string& name) {
  // Machines and containers that share a folder have equal process numbers.
  return stem_of_temporary(name) + fmt::format(".{}.{:08x}.tmp", platform::process_number(), std::random_device{}());
}

bool is_temporary_of(const std::string& file, const std::string& name) {
  constexpr std::string_view kEnd = ".tmp";
  if (!file.starts_with(name + ".") || !file.ends_with(kEnd) || file.size() < name.size() + kEnd.size() + 3)
    return false;
  const std::string middle = file.substr(name.size() + 1, file.size() - name.size() - 1 - kEnd.size());
  const std::size_t dot = middle.find('.');
  return dot != std::string::npos && middle.size() - dot == 9 && middle.find_first_not_of("0123456789") == dot &&
         middle.find_first_not_of("0123456789abcdef", dot + 1) == std::string::npos;
}

/// Removes temporary files of this output that killed processes left, if they are so old that nobody writes them any
/// more.
void remove_old_temporaries(const fs::path& target) {
  constexpr auto kOld = std::chrono::hours(1);
  std::error_code error;
  for (fs::directory_iterator it(folder_of(target), error), end; !error && it != end; it.increment(error)) {
    if (!is_temporary_of(it->path().filename().string(), stem_of_temporary(target.filename().string()))) continue;
    std::error_code ignored;
    const auto written = fs::last_write_time(it->path(), ignored);
    if (!ignored && fs::file_time_type::clock::now() - written > kOld) fs::remove(it->path(), ignored);
  }
}

}  // namespace

tl::expected<void, ToolError> write_output(const fs::path& output, std::span<const std::byte> bytes,
                                           platform::Durability durability) {
  std::error_code why;
  // Through a link, so that the link stays and its target is replaced.
  const fs::path target = fs::is_symlink(output, why) ? fs::weakly_canonical(output, why) : output;
  if (fs::exists(target, why) && !fs::is_regular_file(target, why)) {
    // Renaming over /dev/stdout or a pipe would replace the device.
    if (const std::error_code failed = platform::write_device(target, bytes))
      return cannot_write(output, failed.message());
    return {};
  }
  remove_old_temporaries(target);
  fs::path temporary = target;
  temporary.replace_filename(temporary_name(target.filename().string()));
  std::error_code failed = platform::write_new_file(temporary, bytes, durability);
  if (!failed) fs::rename(temporary, target, failed);
  if (!failed && durability == platform::Durability::kNow) failed = platform::sync_folder(folder_of(target));
  if (failed) {
    fs::remove(temporary, why);
    return cannot_write(output, failed.message());
  }
  return {};
}

}  // namespace coif
