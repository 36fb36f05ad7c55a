#include "cli/batch_page.h"

#include "cli/asset_file.h"
#include "counted.h"
#include "pipeline/process_pool.h"
#include "render/picture.h"
#include "report/page/html_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace coif {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::uint32_t kThumbnailPixels = 144;

/// The bytes of a PNG file; nothing where the asset cannot be drawn, or not here.
std::string thumbnail(const std::string& path) {
  const auto file = AssetFile::open(path);
  if (!file) return {};
  PictureSettings settings;
  settings.width = settings.height = kThumbnailPixels;
  settings.warm_up = false;
  const auto picture = render_picture(file->asset(), settings);
  if (!picture) return {};
  const Bytes png = encode_png(*picture);
  return {png.begin(), png.end()};
}

bool is_cooked(const Outcomes& file) { return file["exit_code"] == 0; }

/// One each, empty where there is none.
std::vector<Bytes> thumbnails(const std::vector<Outcomes>& files, unsigned jobs) {
  const auto answers = run_in_processes(files.size(), jobs, [&](std::size_t i) {
    return is_cooked(files[i]) ? thumbnail(files[i]["output"].get<std::string>()) : std::string{};
  });
  std::vector<Bytes> pictures;
  for (const auto& answer : answers) pictures.push_back(answer ? Bytes(answer->begin(), answer->end()) : Bytes{});
  return pictures;
}

std::string lines(const Outcomes& texts) {
  std::string all;
  for (const auto& text : texts) all += (all.empty() ? "" : "\n") + text.get<std::string>();
  return all;
}

std::vector<Cell> row_of(const Outcomes& file, const Bytes& picture) {
  const std::string source = file["source"].get<std::string>() + "\n" + file["output"].get<std::string>();
  if (!is_cooked(file)) {
    return {{}, {source}, {file["status"].get<std::string>(), CellLook::kBad}, {}, {}, {}, {}, {}, {file["error"]}};
  }
  const auto figure = [&](const char* key) { return Cell{fmt::format("{}", file[key].get<std::uint64_t>())}; };
  const Cell warnings{lines(file["warnings"]), file["warnings"].empty() ? CellLook::kPlain : CellLook::kWarning};
  return {{"", CellLook::kPlain, picture},
          {source},
          {"ok", CellLook::kGood},
          figure("triangles"),
          figure("simulated_bones"),
          figure("bytes"),
          {fmt::format("{:.0f}", file["ms"].get<double>())},
          {file["from_cache"].get<bool>() ? "yes" : "no"},
          warnings};
}

}  // namespace

std::string batch_page(const Outcomes& outcomes, unsigned jobs) {
  std::vector<Outcomes> files(outcomes.begin(), outcomes.end());
  std::ranges::stable_partition(files, [](const Outcomes& file) { return !is_cooked(file); });
  const std::vector<Bytes> pictures = thumbnails(files, jobs);
  using Kind = Column::Kind;
  Table table{{{"Picture"},
               {"Source and asset"},
               {"Status"},
               {"Triangles", Kind::kNumbers},
               {"Moving bones", Kind::kNumbers},
               {"Bytes", Kind::kNumbers},
               {"ms", Kind::kNumbers},
               {"From cache"},
               {"Errors and warnings", Kind::kProse}},
              {}};
  for (std::size_t i = 0; i < files.size(); ++i) table.rows.push_back(row_of(files[i], pictures[i]));
  HtmlPage page("coif cook");
  page.summary(sentence(count(outcomes)) + ".");
  const auto undrawn =
      count(outcomes).cooked - std::ranges::count_if(pictures, [](const Bytes& p) { return !p.empty(); });
  if (undrawn > 0) {
    page.paragraph(fmt::format("{} not drawn: no mesh inside, or no OpenGL ES 3.0 here; 'coif render' tells which.",
                               counted(undrawn, "asset is", "assets are")));
  }
  page.table(table);
  return page.text();
}

}  // namespace coif
