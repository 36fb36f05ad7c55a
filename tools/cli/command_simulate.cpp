#include "animation/recording.h"
#include "base/files.h"
#include "base/json.h"
#include "base/text.h"
#include "cli/command.h"
#include "cli/input_files.h"
#include "cli/messages.h"
#include "cli/options.h"
#include "render/picture.h"

#include <memory>
#include <utility>

namespace coif {
namespace {


struct SimulateOptions {
  std::string file;
  std::string output;
  HeadMotion motion;
  RecordingSettings recording;  ///< But for the motion.
  OutputFormat format = OutputFormat::kText;
};

std::vector<std::uint8_t> base_color_png(const Asset& asset) {
  const TextureRecord* texture = asset.texture(TextureRole::kBaseColor);
  if (!texture || texture->format != TexelFormat::kSrgb8Alpha8) return {};
  const auto texels = asset.texels(*texture, 0);
  Picture picture;
  picture.width = texture->width;
  picture.height = texture->height;
  const auto* first = reinterpret_cast<const std::uint8_t*>(texels.data());
  picture.rgba.assign(first, first + texels.size());
  return encode_png(picture);
}

tl::expected<std::vector<std::byte>, ToolError> encode(const SimulateOptions& options, const std::string& suffix,
                                                       const Asset& asset, const Recording& recording) {
  if (suffix == ".csv") {
    const std::string csv = to_csv(asset, recording);
    const auto bytes = std::as_bytes(std::span(csv));
    return std::vector<std::byte>(bytes.begin(), bytes.end());
  }
  std::vector<std::byte> glb = to_glb(asset, recording, base_color_png(asset));
  if (!glb.empty()) return glb;
  return tl::unexpected(
      ToolError{ToolError::Kind::kUsage, fmt::format("{}: more than 4 GiB; record fewer seconds", options.output)});
}

/// The movement of the head in `recording`; returns its name.
tl::expected<std::string, ToolError> choose_motion(const HeadMotion& chosen, RecordingSettings& recording,
                                                   const Messages& messages) {
  recording.motion = chosen.motion;
  if (!chosen.clip) return all_motions()[std::size_t(chosen.motion)].name;
  auto clip = open_clip(*chosen.clip, messages);
  if (!clip) return tl::unexpected(clip.error());
  recording.clip = std::move(clip->path);
  return std::move(clip->name);
}

std::string result_text(const SimulateOptions& options, const std::string& motion, const Asset& asset,
                        const Recording& recording) {
  if (options.format == OutputFormat::kJson) {
    return json_text({{"output", options.output},
                      {"motion", motion},
                      {"fps", options.recording.fps},
                      {"frames", recording.frames.size()},
                      {"bones", asset.bones().size()},
                      {"stretch_max_pct", 100 * recording.stretch_max},
                      {"penetration_max_pct", 100 * recording.penetration_max}});
  }
  return fmt::format(
      "{}: motion {}, {} of {} at {} per second\n"
      "  worst stretch {:.2f} % of a bone's length, worst penetration {:.2f} % of the head's radius\n",
      options.output, motion, counted(recording.frames.size(), "frame", "frames"),
      counted(asset.bones().size(), "bone", "bones"), options.recording.fps, 100 * recording.stretch_max,
      100 * recording.penetration_max);
}

tl::expected<Exit, ToolError> run_simulate(const SimulateOptions& options, const Messages& messages) {
  const auto suffix = choose_suffix(options.output, {".csv", ".glb"});
  if (!suffix) return tl::unexpected(suffix.error());
  const auto file = AssetFile::open(options.file);
  if (!file) return tl::unexpected(file.error());
  const Asset& asset = file->asset();
  if (auto checked = check_output(options.output, {options.file}); !checked) return tl::unexpected(checked.error());

  RecordingSettings settings = options.recording;
  const auto motion = choose_motion(options.motion, settings, messages);
  if (!motion) return tl::unexpected(motion.error());
  const auto recording = record(asset, settings);
  if (!recording) {
    return tl::unexpected(ToolError{recording.error().kind, options.file + ": " + recording.error().message});
  }
  const auto bytes = encode(options, *suffix, asset, *recording);
  if (!bytes) return tl::unexpected(bytes.error());
  if (auto written = write_output(options.output, *bytes); !written) return tl::unexpected(written.error());
  print_result(result_text(options, *motion, asset, *recording));
  return Exit::kOk;
}

}  // namespace

Command add_simulate(CLI::App& program) {
  CLI::App* app = program.add_subcommand("simulate", "Run an asset through a head motion and write every frame");
  const auto options = std::make_shared<SimulateOptions>();
  RecordingSettings& recording = options->recording;
  app->footer(motion_help());
  app->add_option("FILE", options->file, "A cooked asset")->required();
  app->add_option("-o,--output", options->output, "CSV: bone ends; GLB: skinned animation for any glTF viewer")
      ->required()
      ->type_name("OUT.csv|OUT.glb");
  add_motion(*app, options->motion, "How the head moves")->required();
  add_recording(*app, recording, "the recording");
  add_number(*app, "--settle", recording.settle_seconds, 0.0, 60.0,
             "Seconds of rest before it, so that gravity has sagged the hair");
  add_solver(*app, recording.solver);
  add_number(*app, "--substeps", recording.step.substeps, 0u, 64u, "coif: parts of a step; 0: as the asset was tuned");
  add_number(*app, "--iterations", recording.step.iterations, 1u, 64u,
             "thesis: passes over the length and head constraints");
  add_format(*app, options->format);
  return {app, [options](const Messages& messages) { return run_simulate(*options, messages); }};
}

}  // namespace coif
