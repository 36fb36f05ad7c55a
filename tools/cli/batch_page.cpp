#include "cli/batch.h"

#include "base/encodings.h"
#include "base/text.h"
#include "report/page/report_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace coif::cli {
namespace {

std::string text_of(const Outcomes& file, const char* key) { return file[key].get<std::string>(); }

/// The longest common folder of the paths under `key`, with a slash at its end; empty where they share none.
std::string common_folder(const std::vector<Outcomes>& files, const char* key) {
  std::string folder = files.empty() ? "" : text_of(files[0], key);
  for (const Outcomes& file : files) {
    const std::string path = text_of(file, key);
    folder.resize(std::size_t(std::ranges::mismatch(folder, path).in1 - folder.begin()));
  }
  return folder.substr(0, folder.rfind('/') + 1);
}

/// Long paths would push the important columns off the screen.
struct Places {
  std::string sources;  ///< The common folder of all sources.
  std::string assets;

  std::string source(const Outcomes& file) const { return text_of(file, "source").substr(sources.size()); }
  std::string asset(const Outcomes& file) const { return text_of(file, "output").substr(assets.size()); }
};

/// The page's reader knows which file it is about.
std::string fault_of(const Outcomes& file) {
  const std::string error = text_of(file, "error"), prefix = text_of(file, "source") + ": ";
  return error.starts_with(prefix) ? error.substr(prefix.size()) : error;
}

Outcomes failures(const std::vector<Outcomes>& files, const Places& places) {
  Outcomes rows = Outcomes::array();
  for (const Outcomes& file : files) {
    rows.push_back({{"source", places.source(file)}, {"status", text_of(file, "status")}, {"error", fault_of(file)}});
  }
  return rows;
}

Outcomes assets(const std::vector<Outcomes>& files, const std::vector<platform::Bytes>& pictures,
                const Places& places) {
  Outcomes rows = Outcomes::array();
  for (std::size_t i = 0; i < files.size(); ++i) {
    const Outcomes& file = files[i];
    Outcomes row{{"png", base64(pictures[i])}, {"files", {places.source(file), places.asset(file)}}};
    for (const char* const key : {"triangles", "simulated_bones", "bytes", "ms", "from_cache", "warnings"}) {
      row[key] = file[key];
    }
    rows.push_back(row);
  }
  return rows;
}

std::string undrawn_text(std::size_t count) {
  return fmt::format("{} not drawn: no mesh inside, or no OpenGL ES 3.0 here; 'coif render' tells which.",
                     counted(count, "asset is", "assets are"));
}

}  // namespace

// The layout of the page: cook_page.json.
extern "C" const char coif_cook_page[];

std::string batch_page(const Outcomes& outcomes, unsigned jobs) {
  const std::vector<Outcomes> files(outcomes.begin(), outcomes.end());
  std::vector<Outcomes> cooked, failed;
  std::ranges::partition_copy(files, std::back_inserter(cooked), std::back_inserter(failed), is_cooked);
  std::vector<std::string> outputs;
  for (const Outcomes& file : cooked) outputs.push_back(text_of(file, "output"));
  const std::vector<platform::Bytes> pictures = thumbnails(outputs, jobs);
  const Places places{common_folder(files, "source"), common_folder(files, "output")};
  const auto undrawn = std::size_t(std::ranges::count_if(pictures, &platform::Bytes::empty));
  return report::page_html({{"title", "coif cook"},
                            {"finding", sentence(count(outcomes)) + "."},
                            {"sources", places.sources.empty() ? "./" : places.sources},
                            {"assets", places.assets.empty() ? "./" : places.assets},
                            {"undrawn", undrawn > 0 ? undrawn_text(undrawn) : ""},
                            {"failed", failures(failed, places)},
                            {"cooked", assets(cooked, pictures, places)}},
                           coif_cook_page);
}

}  // namespace coif::cli
