#include "cli/batch.h"

#include "base/text.h"
#include "cli/batch_job.h"
#include "report/page/html_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace coif {
namespace {

std::string text_of(const Outcomes& file, const char* key) { return file[key].get<std::string>(); }

/// Of all paths under `key`, with a slash at its end; nothing where they share none.
std::string common_folder(const std::vector<Outcomes>& files, const char* key) {
  std::string folder = files.empty() ? "" : text_of(files[0], key);
  for (const Outcomes& file : files) {
    const std::string path = text_of(file, key);
    folder.resize(std::size_t(std::ranges::mismatch(folder, path).in1 - folder.begin()));
  }
  return folder.substr(0, folder.rfind('/') + 1);
}

/// Long paths would push what matters off the screen.
struct Places {
  std::string sources;  ///< The folder of all.
  std::string assets;

  std::string source(const Outcomes& file) const { return text_of(file, "source").substr(sources.size()); }
  std::string asset(const Outcomes& file) const { return text_of(file, "output").substr(assets.size()); }
};

/// The page's reader knows which file it is about.
std::string fault_of(const Outcomes& file) {
  const std::string error = text_of(file, "error"), prefix = text_of(file, "source") + ": ";
  return error.starts_with(prefix) ? error.substr(prefix.size()) : error;
}

Table failures(const std::vector<Outcomes>& files, const Places& places) {
  Table table{{{"Source"}, {"Status"}, {"What and cure", Column::Kind::kProse}}, {}};
  for (const Outcomes& file : files) {
    table.rows.push_back({{places.source(file)}, {text_of(file, "status"), CellLook::kBad}, {fault_of(file)}});
  }
  return table;
}

std::string lines(const Outcomes& texts) {
  std::string all;
  for (const auto& text : texts) all += (all.empty() ? "" : "\n") + text.get<std::string>();
  return all;
}

Table assets(const std::vector<Outcomes>& files, const std::vector<Bytes>& pictures, const Places& places) {
  using Kind = Column::Kind;
  Table table{{{"Picture"},
               {"Source and asset"},
               {"Triangles", Kind::kNumbers},
               {"Moving bones", Kind::kNumbers},
               {"Bytes", Kind::kNumbers},
               {"ms", Kind::kNumbers},
               {"From cache"},
               {"Warnings", Kind::kProse}},
              {}};
  for (std::size_t i = 0; i < files.size(); ++i) {
    const Outcomes& file = files[i];
    const auto figure = [&](const char* key) { return Cell{fmt::format("{}", file[key].get<std::uint64_t>())}; };
    table.rows.push_back({{"", CellLook::kPlain, pictures[i]},
                          {places.source(file) + "\n" + places.asset(file)},
                          figure("triangles"),
                          figure("simulated_bones"),
                          figure("bytes"),
                          {fmt::format("{:.0f}", file["ms"].get<double>())},
                          {file["from_cache"].get<bool>() ? "yes" : "no"},
                          {lines(file["warnings"]), file["warnings"].empty() ? CellLook::kPlain : CellLook::kWarning}});
  }
  return table;
}

std::string undrawn_text(std::size_t count) {
  return fmt::format("{} not drawn: no mesh inside, or no OpenGL ES 3.0 here; 'coif render' tells which.",
                     counted(count, "asset is", "assets are"));
}

}  // namespace

std::string batch_page(const Outcomes& outcomes, unsigned jobs) {
  const std::vector<Outcomes> files(outcomes.begin(), outcomes.end());
  std::vector<Outcomes> cooked, failed;
  std::ranges::partition_copy(files, std::back_inserter(cooked), std::back_inserter(failed), is_cooked);
  std::vector<std::string> outputs;
  for (const Outcomes& file : cooked) outputs.push_back(text_of(file, "output"));
  const std::vector<Bytes> pictures = thumbnails(outputs, jobs);
  const Places places{common_folder(files, "source"), common_folder(files, "output")};
  const auto undrawn = std::size_t(std::ranges::count_if(pictures, &Bytes::empty));
  HtmlPage page("coif cook");
  page.summary(sentence(count(outcomes)) + ".");
  page.paragraph(fmt::format("Sources lie in {}, assets in {}", places.sources.empty() ? "./" : places.sources,
                             places.assets.empty() ? "./" : places.assets));
  if (!failed.empty()) {
    page.heading("Failed");
    page.table(failures(failed, places));
  }
  page.heading("Cooked");
  if (undrawn > 0) page.paragraph(undrawn_text(undrawn));
  page.table(assets(cooked, pictures, places));
  return page.text();
}

}  // namespace coif
