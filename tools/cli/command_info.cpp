#include "cli/asset_file.h"
#include "cli/asset_summary.h"
#include "cli/command.h"
#include "cli/options.h"
#include "cli/results.h"

#include <memory>

namespace coif {
namespace {

struct InfoOptions {
  std::string file;
  OutputFormat format = OutputFormat::kText;
};

tl::expected<Exit, ToolError> run_info(const InfoOptions& options) {
  const auto file = AssetFile::open(options.file);
  if (!file) return tl::unexpected(file.error());
  print_result(options.format == OutputFormat::kJson ? asset_json(file->asset())
                                                     : asset_text(options.file, file->asset()));
  return Exit::kOk;
}

}  // namespace

Command add_info(CLI::App& program) {
  CLI::App* app = program.add_subcommand("info", "Print what an asset holds and what each part costs");
  const auto options = std::make_shared<InfoOptions>();
  app->add_option("FILE", options->file, "A cooked asset")->required();
  add_format(*app, options->format);
  return {app, [options](const Messages&) { return run_info(*options); }};
}

}  // namespace coif
