#include "animation/recording.h"
#include "base/color_texels.h"
#include "base/files.h"
#include "base/json.h"
#include "base/text.h"
#include "cli/command.h"
#include "cli/input_files.h"
#include "cli/messages.h"
#include "cli/options.h"
#include "cli/verb_options.h"
#include "import/clip_file.h"
#include "render/picture.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

namespace coif::cli {
namespace {

/// An animation for the hair's bones to follow.
struct PoseChoice {
  std::filesystem::path file;
  float weight = 1;
};

struct SimulateOptions {
  std::string file;
  std::string output;
  HeadMotion motion;
  std::optional<Eigen::Vector3d> attitude;  ///< Instead of the motion.
  bool true_gravity = false;
  GustOptions gusts;
  std::optional<PoseChoice> pose;
  animation::RecordingSettings recording;  ///< Without the motion.
  OutputFormat format = OutputFormat::kText;
};

std::vector<std::uint8_t> base_color_png(const Asset& asset) {
  const TextureRecord* texture = asset.texture(TextureRole::kBaseColor);
  if (!texture) return {};
  const auto texels = color_texels(asset, *texture, 0);
  render::Picture picture;
  picture.width = texture->width;
  picture.height = texture->height;
  const auto* first = reinterpret_cast<const std::uint8_t*>(texels.data());
  picture.rgba.assign(first, first + texels.size());
  return render::encode_png(picture);
}

tl::expected<std::vector<std::byte>, ToolError> encode(const SimulateOptions& options, const std::string& suffix,
                                                       const Asset& asset, const animation::Recording& recording) {
  if (suffix == ".csv") {
    const std::string csv = animation::to_csv(asset, recording);
    const auto bytes = std::as_bytes(std::span(csv));
    return std::vector<std::byte>(bytes.begin(), bytes.end());
  }
  std::vector<std::byte> glb = animation::to_glb(asset, recording, base_color_png(asset));
  if (!glb.empty()) return glb;
  return tl::unexpected(
      ToolError{ToolError::Kind::kUsage, fmt::format("{}: more than 4 GiB; record fewer seconds", options.output)});
}

/// The movement of the head in `recording`; returns its name.
tl::expected<std::string, ToolError> choose_motion(const SimulateOptions& options,
                                                   animation::RecordingSettings& recording, const Messages& messages) {
  if (options.attitude) {
    recording.clip = motion::held_attitude(*options.attitude);
    const Eigen::Vector3d& up = *options.attitude;
    return fmt::format("attitude {:g},{:g},{:g}", up.x(), up.y(), up.z());
  }
  const HeadMotion& chosen = options.motion;
  recording.motion = chosen.motion;
  if (!chosen.clip) return motion::all_motions()[std::size_t(chosen.motion)].name;
  auto clip = open_clip(*chosen.clip, messages);
  if (!clip) return tl::unexpected(clip.error());
  recording.clip = std::move(clip->path);
  return std::move(clip->name);
}

tl::expected<void, ToolError> choose_gusts(const GustOptions& chosen, animation::RecordingSettings& recording) {
  if (chosen.amplitude <= 0) return {};
  if (recording.solver != &kCoifSolver) return usage("--gusts: hair feels gusts with --solver coif alone");
  recording.company.gusts = gusts_in(recording.step.environment.wind, chosen);
  return {};
}

std::vector<Quat> to_quats(const std::vector<Eigen::Quaterniond>& rotations) {
  std::vector<Quat> quats;
  quats.reserve(rotations.size());
  for (const Eigen::Quaterniond& each : rotations) {
    const Eigen::Quaternionf q = each.cast<float>();
    quats.push_back({q.x(), q.y(), q.z(), q.w()});
  }
  return quats;
}

/// Has `recording` follow the clip; returns how many bones it has of the asset's.
tl::expected<std::size_t, ToolError> choose_pose(const PoseChoice& chosen, const Asset& asset,
                                                 animation::RecordingSettings& recording, const Messages& messages) {
  if (recording.solver != &kCoifSolver) return usage("--pose is for the solver coif only; leave --solver out");
  std::vector<importer::PosedBone> bones;
  for (std::uint32_t i = 0; i < asset.bones().size(); ++i) {
    const std::uint32_t parent = asset.bones()[i].parent;
    const char* const name = asset.bone_name(i);
    bones.push_back({name != nullptr ? name : "", parent == kNone ? -1 : int(parent)});
  }
  const auto clip = importer::read_pose_clip(chosen.file, bones);
  if (!clip) return tl::unexpected(clip.error());
  for (const std::string& note : (*clip)->notes()) messages.note(chosen.file.string() + ": " + note);
  recording.company.pose = [clip = *clip](double seconds) { return to_quats(clip->at(seconds)); };
  recording.company.pose_weight = chosen.weight;
  return (*clip)->found();
}

CLI::Option* add_pose(CLI::App& app, std::optional<PoseChoice>& pose) {
  const auto parse = [&pose](const std::string& word) {
    const std::size_t colon = word.rfind(':');
    pose = {word.substr(0, colon)};
    if (colon == std::string::npos) return;
    const auto weight = parse_number<float>(std::string_view(word).substr(colon + 1));
    if (!weight || !(*weight >= 0 && *weight <= 1)) {
      throw CLI::ValidationError("--pose", fmt::format("'{}': behind the colon stands a weight, 0 to 1", word));
    }
    pose->weight = *weight;
  };
  return app
      .add_option_function<std::string>(
          "--pose", parse,
          "An animation of bones with the names of the hair's, in a glTF, that the hair "
          "follows in place of its rest pose; at weight 0 it is the animation, at 1 (default) "
          "that only pulls")
      ->type_name("CLIP[:WEIGHT]");
}

struct Played {
  std::string motion;
  std::size_t posed_bones = 0;
};

std::string result_text(const SimulateOptions& options, const Played& played, const Asset& asset,
                        const animation::Recording& recording) {
  const std::string& motion = played.motion;
  if (options.format == OutputFormat::kJson) {
    nlohmann::ordered_json json = {{"output", options.output},
                                   {"motion", motion},
                                   {"fps", options.recording.fps},
                                   {"frames", recording.frames.size()},
                                   {"bones", asset.bones().size()},
                                   {"scale", options.recording.company.scale},
                                   {"stretch_max_pct", 100 * recording.stretch_max},
                                   {"penetration_max_pct", 100 * recording.penetration_max},
                                   {"from_rest_pct", 100 * recording.from_rest},
                                   {"last_speed_m_s", recording.last_speed}};
    if (!options.recording.lengths.is_even()) json["pace"] = pace_text(options.recording);
    if (options.pose) {
      json["pose"] = printable_text(options.pose->file.string());
      json["pose_weight"] = options.pose->weight;
      json["posed_bones"] = played.posed_bones;
    }
    return json_text(json);
  }
  const std::string pose =
      !options.pose ? ""
                    : fmt::format("  {} of the bones follow {} at weight {:g}\n", played.posed_bones,
                                  printable_text(options.pose->file.filename().string()), options.pose->weight);
  return fmt::format(
      "{}: motion {}, {} of {} at {}\n{}"
      "  worst stretch {:.2f} % of a bone's length, worst penetration {:.2f} % of the head's radius\n"
      "  at the end no bone is further than {:.4f} % of the longest chain from its rest pose; in the last second the "
      "fastest moved at {:.4f} m/s\n",
      options.output, motion, counted(recording.frames.size(), "frame", "frames"),
      counted(asset.bones().size(), "bone", "bones"), pace_text(options.recording), pose, 100 * recording.stretch_max,
      100 * recording.penetration_max, 100 * recording.from_rest, recording.last_speed);
}

tl::expected<Exit, ToolError> run_simulate(const SimulateOptions& options, const Messages& messages) {
  const auto suffix = choose_suffix(options.output, {".csv", ".glb"});
  if (!suffix) return tl::unexpected(suffix.error());
  const auto file = AssetFile::open(options.file);
  if (!file) return tl::unexpected(file.error());
  const Asset& asset = file->asset();
  if (auto checked = check_output(options.output, {options.file, clip_file(options.motion),
                                                   options.pose ? options.pose->file : std::filesystem::path()});
      !checked) {
    return tl::unexpected(checked.error());
  }

  animation::RecordingSettings settings = options.recording;
  settings.step.environment.true_gravity = options.true_gravity ? 1 : 0;
  const auto motion = choose_motion(options, settings, messages);
  if (!motion) return tl::unexpected(motion.error());
  if (const auto gusts = choose_gusts(options.gusts, settings); !gusts) return tl::unexpected(gusts.error());
  Played played{*motion};
  if (options.pose) {
    const auto posed = choose_pose(*options.pose, asset, settings, messages);
    if (!posed) return tl::unexpected(posed.error());
    played.posed_bones = *posed;
  }
  const auto recording = animation::record(asset, settings);
  if (!recording) {
    return tl::unexpected(ToolError{recording.error().kind, options.file + ": " + recording.error().message});
  }
  const auto bytes = encode(options, *suffix, asset, *recording);
  if (!bytes) return tl::unexpected(bytes.error());
  if (auto written = write_output(options.output, *bytes); !written) return tl::unexpected(written.error());
  print_result(result_text(options, played, asset, *recording));
  return Exit::kOk;
}

}  // namespace

Command add_simulate(CLI::App& program) {
  CLI::App* app = program.add_subcommand("simulate", "Run an asset through a head motion and write every frame");
  const auto options = std::make_shared<SimulateOptions>();
  animation::RecordingSettings& recording = options->recording;
  app->footer(motion_help());
  app->add_option("FILE", options->file, "A cooked asset")->required();
  app->add_option("-o,--output", options->output, "CSV: bone ends; GLB: skinned animation for any glTF viewer")
      ->required()
      ->type_name("OUT.csv|OUT.glb");
  CLI::Option* const motion = add_motion(*app, options->motion, "How the head moves");
  CLI::Option* const attitude = add_attitude(*app, options->attitude)->excludes(motion);
  add_scale(*app, recording.company.scale);
  app->add_flag(
      "--true-gravity", options->true_gravity,
      "Gravity is that of the world at every scale, instead of going with the head's so that hair hangs as it was "
      "modelled");
  add_wind(*app, recording.step.environment.wind);
  add_gusts(*app, options->gusts);
  add_pose(*app, options->pose);
  add_recording(*app, recording, "the recording");
  add_frame_lengths(*app, recording.lengths);
  add_number(*app, "--settle", recording.settle_seconds, 0.0, 60.0,
             "Seconds of rest before it, so that gravity has sagged the hair");
  add_solver(*app, recording.solver);
  add_number(*app, "--substeps", recording.step.substeps, 0u, 64u, "coif: parts of a step; 0: as the asset was tuned");
  add_number(*app, "--iterations", recording.step.iterations, 1u, 64u,
             "thesis: passes over the length and head constraints");
  add_format(*app, options->format);
  return {app, [options, motion, attitude](const Messages& messages) -> tl::expected<Exit, ToolError> {
            if (motion->count() + attitude->count() == 0) return usage("needs --motion NAME or --attitude X,Y,Z");
            return run_simulate(*options, messages);
          }};
}

}  // namespace coif::cli
