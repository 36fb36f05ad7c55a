#include "base/files.h"
#include "base/hair_runtime.h"
#include "base/json.h"
#include "base/parallel_for.h"
#include "base/text.h"
#include "cli/body.h"
#include "cli/command.h"
#include "cli/input_files.h"
#include "cli/messages.h"
#include "cli/options.h"
#include "cli/source_limits.h"
#include "cli/verb_options.h"
#include "render/camera_file.h"
#include "render/picture.h"
#include "render/presentation.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace coif::cli {
namespace {

struct Shown {
  Component component = Component::kAll;
  bool patches = false;
  bool colliders = false;
};

constexpr Choice<Shown> kShown[] = {{"all", {Component::kAll, false}},
                                    {"ambient", {Component::kAmbient, false}},
                                    {"diffuse", {Component::kDiffuse, false}},
                                    {"specular", {Component::kSpecular, false}},
                                    {"primary", {Component::kPrimary, false}},
                                    {"secondary", {Component::kSecondary, false}},
                                    {"direction", {Component::kDirection, false}},
                                    {"patches", {Component::kAll, true}},
                                    {"colliders", {Component::kAll, false, true}}};

using DebugPart = bool render::DebugView::*;

constexpr Choice<DebugPart> kDebugParts[] = {{"bones", &render::DebugView::bones},
                                             {"colliders", &render::DebugView::colliders},
                                             {"contacts", &render::DebugView::contacts},
                                             {"limits", &render::DebugView::limits},
                                             {"motion", &render::DebugView::motion}};

constexpr const char* kLightSuffix = ".exr";  ///< A picture before the tone curve.

struct RenderOptions {
  std::string file;
  std::string output;
  PixelSize size{1024, 768};
  ViewAngles view{30, 5};
  std::string camera;  ///< Its file; empty: the view.
  Shown shown;
  HeadMotion motion;
  GustOptions gusts;
  bool moves = false;
  std::string body;
  std::string body_mesh;
  std::vector<std::filesystem::path> roots;
  SourceLimits limits;
  std::optional<std::string> recipe;
  std::optional<ShadingModel> shading;
  std::uint32_t samples = 8;
  render::PictureSettings picture;
  OutputFormat format = OutputFormat::kText;
};

/// Splits the limit of shaded samples: as many as possible are oversampling, the rest multisampling by the driver.
void share_samples(const RenderOptions& options, render::PictureSettings& settings) {
  constexpr std::uint32_t kMostSamplesAcross = 8192;
  settings.oversampling = 1;
  for (const std::uint32_t finer : {2u, 4u}) {
    const bool fits = std::max(settings.width, settings.height) * finer <= kMostSamplesAcross;
    if (fits && finer * finer <= options.samples) settings.oversampling = finer;
  }
  settings.edge_samples = options.samples / (settings.oversampling * settings.oversampling);
}

render::PictureSettings picture_settings(const RenderOptions& options) {
  render::PictureSettings settings = options.picture;
  settings.width = options.size.width;
  settings.height = options.size.height;
  share_samples(options, settings);
  settings.yaw_degrees = options.view.yaw_degrees;
  settings.pitch_degrees = options.view.pitch_degrees;
  settings.component = options.shown.component;
  settings.patches = options.shown.patches;
  settings.colliders = options.shown.colliders;
  if (options.moves) settings.motion = options.motion.motion;
  if (options.gusts.amplitude > 0) {
    motion::HairCompany company;
    company.gusts = gusts_in(settings.step.environment.wind, options.gusts);
    settings.company = std::make_shared<motion::HairCompany>(company);
  }
  return settings;
}

std::string result_text(const RenderOptions& options, const render::PictureSettings& settings, const Asset& asset,
                        const render::Picture& picture) {
  const std::size_t triangles = asset.lod_indices(options.picture.lod).size() / 3;
  const std::uint32_t heads = options.picture.heads;
  const Eigen::Vector3d joint = render::joint_of(asset);
  if (options.format == OutputFormat::kJson) {
    return json_text({{"output", options.output},
                      {"width", picture.width},
                      {"height", picture.height},
                      {"samples", settings.oversampling * settings.oversampling * picture.edge_samples},
                      {"heads", heads},
                      {"triangles", triangles * heads},
                      {"draw_ms", picture.draw_ms},
                      {"device", picture.device},
                      {"camera", render::camera_json(picture.camera, joint)},
                      {"lights", render::lights_json(picture.lights)}});
  }
  const std::uint32_t finer = settings.oversampling;
  return fmt::format("{}: {}x{}, {} with {} of hair each, drawn in {:.1f} ms as {}x{} with {}\n  device: {}\n",
                     options.output, picture.width, picture.height, counted(heads, "head", "heads"),
                     counted(triangles, "triangle", "triangles"), picture.draw_ms, finer * picture.width,
                     finer * picture.height, counted(picture.edge_samples, "sample of edges", "samples of edges"),
                     picture.device);
}

tl::expected<void, ToolError> write_light(const std::string& path, const LinearPicture& light) {
  const auto bytes = encode_exr(light);
  if (!bytes) return file_failure(ToolError::Kind::kInternal, path, "it cannot be encoded: {}", bytes.error());
  return write_output(path, *bytes);
}

tl::expected<Exit, ToolError> run_render(const RenderOptions& options, const Messages& messages) {
  const auto suffix = choose_suffix(options.output, {".png", kLightSuffix});
  if (!suffix) return tl::unexpected(suffix.error());
  if (options.gusts.amplitude > 0 && options.picture.solver != &kCoifSolver) {
    return tl::unexpected(ToolError{ToolError::Kind::kUsage, "--gusts: hair feels gusts with --solver coif alone"});
  }
  const auto file = AssetFile::open(options.file);
  if (!file) return tl::unexpected(file.error());
  if (auto checked = check_output(options.output, {options.file, options.camera, clip_file(options.motion)}); !checked)
    return tl::unexpected(checked.error());

  render::PictureSettings settings = picture_settings(options);
  settings.keeps_light = *suffix == kLightSuffix;
  if (!options.camera.empty()) {
    const auto camera = render::read_camera(options.camera, render::joint_of(file->asset()));
    if (!camera) return tl::unexpected(camera.error());
    settings.camera = *camera;
  }
  if (options.shading) settings.material = render::shaded_material(file->asset(), *options.shading);
  if (options.motion.clip) {
    auto clip = open_clip(*options.motion.clip, messages);
    if (!clip) return tl::unexpected(clip.error());
    settings.clip = std::move(clip->path);
  }
  tl::expected<Body, ToolError> body;
  if (!options.body.empty()) {
    body = read_body({options.body, options.body_mesh, options.recipe, options.roots, options.limits}, file->asset(),
                     messages);
    if (!body) return tl::unexpected(body.error());
    if (auto checked = check_output(options.output, body->files); !checked) return tl::unexpected(checked.error());
    if (body->model.meshes.empty()) {
      messages.warning(options.body + ": has nothing but the hair; drawn as without --body");
    } else {
      settings.body = &body->model;
    }
    settings.body_textures = render::read_body_textures(body->model, body->findings);
    messages.tell(body->findings.warnings, options.body);
  }
  const auto picture = render::render_picture(file->asset(), settings);
  if (!picture) {
    return tl::unexpected(ToolError{picture.error().kind, options.file + ": " + picture.error().message});
  }
  if (picture->edge_samples < settings.edge_samples) {
    messages.warning(fmt::format("--samples {}: the device has at most {} of edges; drawn with {} in each pixel",
                                 options.samples, picture->edge_samples,
                                 settings.oversampling * settings.oversampling * picture->edge_samples));
  }
  const auto written = *suffix == kLightSuffix ? write_light(options.output, picture->light)
                                               : render::write_png(options.output, *picture);
  if (!written) return tl::unexpected(written.error());
  print_result(result_text(options, settings, file->asset(), *picture));
  return Exit::kOk;
}

void add_content_options(CLI::App& app, RenderOptions& options) {
  CLI::Option* motion = add_motion(app, options.motion, "How the head moves (default: at rest)");
  motion->each([&options](const std::string&) { options.moves = true; });
  add_solver(app, options.picture.solver);
  add_wind(app, options.picture.step.environment.wind);
  add_gusts(app, options.gusts);
  app.add_option("--time", options.picture.time, "Seconds into the motion")
      ->check(CLI::Range(0.0, 3600.0))
      ->needs(motion);
  add_number(app, "--heads", options.picture.heads, 1u, 10000u, "Heads in a grid");
  CLI::Option* body = app.add_option("--body", options.body, "Draw this model's other meshes with the hair");
  body->type_name("SOURCE");
  app.add_option("--body-mesh", options.body_mesh, "Which meshes, with * and ? (default: all that are not hair)")
      ->type_name("PATTERN")
      ->needs(body);
  app.add_option("--recipe", options.recipe, "The recipe of the cook, for the body's units and which meshes are hair")
      ->type_name("R.json")
      ->needs(body);
  add_roots(app, options.roots)->needs(body);
  add_source_limits(app, options.limits);
}

void add_debug(CLI::App& app, render::DebugView& debug) {
  std::vector<std::string> names;
  for (const auto& part : kDebugParts) names.emplace_back(part.name);
  const std::string list = fmt::format("{}", fmt::join(names, ", "));
  const auto parse = [&debug, list](const std::vector<std::string>& words) {
    for (const std::string& word : words) {
      const auto part = std::ranges::find_if(kDebugParts, [&](const auto& known) { return word == known.name; });
      if (part == std::end(kDebugParts)) {
        throw CLI::ValidationError("--debug", fmt::format("'{}' is not one of {}", word, list));
      }
      debug.*part->value = true;
    }
  };
  app.add_option_function<std::vector<std::string>>("--debug", parse,
                                                    "Show over the hair, several separated by commas: " + list +
                                                        " (colours of how far hair moved in the last frame)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("NAME,...");
}

void add_samples(CLI::App& app, std::uint32_t& samples) {
  const auto is_power_of_two = [](const std::string& word) {
    const auto number = parse_number<std::uint32_t>(word);
    const bool fits = number && *number >= 1 && *number <= 64 && (*number & (*number - 1)) == 0;
    return fits ? std::string() : fmt::format("'{}' is not 1, 2, 4, 8, 16, 32 or 64", word);
  };
  app.add_option("--samples", samples,
                 "Samples of each pixel: as many as fit are shaded, the others are of edges alone")
      ->check(is_power_of_two)
      ->capture_default_str()
      ->type_name("N");
}

}  // namespace

Command add_render(CLI::App& program) {
  CLI::App* app = program.add_subcommand("render", "Draw a picture of an asset, without a window");
  const auto options = std::make_shared<RenderOptions>();
  app->add_option("FILE", options->file, "A cooked asset")->required();
  app->add_option("-o,--output", options->output, "The picture to write; an EXR has linear light and coverage")
      ->required()
      ->type_name("OUT.png|OUT.exr");
  add_size(*app, options->size);
  CLI::Option* view = add_view(*app, options->view);
  app->add_option("--camera", options->camera,
                  "Where the camera stands, as --format json prints it: metres of the source, Y up (default: where all "
                  "is seen)")
      ->type_name("CAMERA.json")
      ->excludes(view);
  add_content_options(*app, *options);
  add_choice<Shown>(
      *app, "--component", options->shown, kShown,
      "Which part of the shading; or, to check the cook, the strands' direction, the patches, or the colliders");
  add_debug(*app, options->picture.debug);
  app->add_option("--lod", options->picture.lod, "Level of detail, 0 is the finest")->capture_default_str();
  add_picture_options(*app, options->picture);
  add_shading(*app, options->shading);
  add_samples(*app, options->samples);
  add_format(*app, options->format);
  return {app, [options](const Messages& messages) { return run_render(*options, messages); }};
}

}  // namespace coif::cli
