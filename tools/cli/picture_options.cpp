#include "cli/verb_options.h"

#include "base/hair_runtime.h"
#include "cli/options.h"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace coif::cli {
namespace {

constexpr Choice<render::LightRig> kLights[] = {{"studio", render::LightRig::kStudio},
                                                {"sun", render::LightRig::kSun},
                                                {"rim", render::LightRig::kRim},
                                                {"plain", render::LightRig::kMeasured}};

void add_shadows(CLI::App& app, const ShadowTechnique*& choice) {
  static const auto choices = [] {
    std::vector<Choice<const ShadowTechnique*>> all{{"none", nullptr}};
    for (const ShadowTechnique* technique : render::shadow_techniques())
      all.push_back({name_of(*technique), technique});
    return all;
  }();
  add_choice<const ShadowTechnique*>(app, "--shadows", choice, choices,
                                     "How the key light's shadows are drawn (default: deep-shadow)");
}

void add_transparency(CLI::App& app, const TransparencyMode*& choice) {
  static const auto choices = [] {
    std::vector<Choice<const TransparencyMode*>> all;
    for (const TransparencyMode* mode : render::transparency_modes()) all.push_back({name_of(*mode), mode});
    return all;
  }();
  add_choice<const TransparencyMode*>(app, "--transparency", choice, choices, "How soft edges are drawn");
}

void add_order(CLI::App& app, render::OrderChoice& choice) {
  static constexpr Choice<render::OrderChoice> kChoices[] = {{"cooked", render::OrderChoice::kCooked},
                                                             {"bones", render::OrderChoice::kBones}};
  add_choice<render::OrderChoice>(
      app, "--order", choice, kChoices,
      "In which order triangles are blended, as cooked or with the bones sorted in each frame");
}

void add_stage(CLI::App& app, render::PictureSettings& picture) {
  static constexpr Choice<bool> kHeads[] = {{"face", true}, {"ball", false}};
  add_choice<bool>(
      app, "--head", picture.bust, kHeads,
      "What is under hair that comes without a body: a head with a face (default), or the asset's own collider");
  add_choice<render::LightRig>(app, "--lights", picture.lights, kLights, "From where light comes (default: studio)");
  const auto parse = [&picture](const std::string& word) {
    const auto backdrop = render::find_backdrop(word);
    if (!backdrop) {
      throw CLI::ValidationError("--backdrop",
                                 fmt::format("'{}' is not dark, light, clear or a colour as #rrggbb", word));
    }
    picture.backdrop = *backdrop;
  };
  app.add_option_function<std::string>(
         "--backdrop", parse, "What is behind: dark (default), light, clear (transparent), or a colour #rrggbb")
      ->type_name("NAME|COLOUR");
  static constexpr Choice<render::GroundChoice> kGrounds[] = {{"auto", render::GroundChoice::kWhereSeen},
                                                              {"shown", render::GroundChoice::kAlways},
                                                              {"none", render::GroundChoice::kNever}};
  add_choice<render::GroundChoice>(
      app, "--ground", picture.ground, kGrounds,
      "Whether what is under hair casts a soft shade on the ground it stands on (default: auto, where the "
      "picture shows the feet of a whole body)");
  add_number(app, "--margin", picture.margin, 1.0, 10.0,
             "How far away the camera is, of the distance from which hair and head fill the picture");
}

}  // namespace

void add_picture_options(CLI::App& app, render::PictureSettings& picture) {
  picture.shadows = &kDeepShadow;
  picture.lights = render::LightRig::kStudio;
  picture.bust = true;
  picture.ground = render::GroundChoice::kWhereSeen;
  picture.backdrop = render::find_backdrop("dark").value_or(render::Backdrop{});
  add_transparency(app, picture.transparency);
  add_order(app, picture.order);
  add_shadows(app, picture.shadows);
  add_stage(app, picture);
}

CLI::Option* add_shading(CLI::App& app, std::optional<ShadingModel>& choice) {
  static const auto choices = [] {
    std::vector<Choice<std::optional<ShadingModel>>> all;
    for (const ShadingTraits& model : kShadingModels) all.push_back({model.name, shading_model(model.name)});
    return all;
  }();
  return add_choice<std::optional<ShadingModel>>(app, "--shading", choice, choices,
                                                 "How strands reflect light (default: as cooked)");
}

}  // namespace coif::cli
