#include "cli/picture_options.h"

#include "cli/options.h"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace coif {
namespace {

constexpr Choice<LightRig> kLights[] = {
    {"studio", LightRig::kStudio}, {"sun", LightRig::kSun}, {"rim", LightRig::kRim}, {"plain", LightRig::kMeasured}};

void add_shadows(CLI::App& app, const ShadowTechnique*& choice) {
  static const auto choices = [] {
    std::vector<Choice<const ShadowTechnique*>> all{{"none", nullptr}};
    for (const ShadowTechnique* technique : shadow_techniques()) all.push_back({name_of(*technique), technique});
    return all;
  }();
  add_choice<const ShadowTechnique*>(app, "--shadows", choice, choices,
                                     "How the key light's shadows are drawn (default: deep-shadow)");
}

void add_transparency(CLI::App& app, const TransparencyMode*& choice) {
  static const auto choices = [] {
    std::vector<Choice<const TransparencyMode*>> all;
    for (const TransparencyMode* mode : transparency_modes()) all.push_back({name_of(*mode), mode});
    return all;
  }();
  add_choice<const TransparencyMode*>(app, "--transparency", choice, choices, "How soft edges are drawn");
}

void add_order(CLI::App& app, OrderChoice& choice) {
  static constexpr Choice<OrderChoice> kChoices[] = {{"cooked", OrderChoice::kCooked}, {"bones", OrderChoice::kBones}};
  add_choice<OrderChoice>(app, "--order", choice, kChoices,
                          "In which order triangles are blended, as cooked or with the bones sorted in each frame");
}

void add_stage(CLI::App& app, PictureSettings& picture) {
  static constexpr Choice<bool> kHeads[] = {{"face", true}, {"ball", false}};
  add_choice<bool>(
      app, "--head", picture.bust, kHeads,
      "What is under hair that comes without a body: a head with a face (default), or the asset's own collider");
  add_choice<LightRig>(app, "--lights", picture.lights, kLights, "From where light comes (default: studio)");
  const auto parse = [&picture](const std::string& word) {
    const auto backdrop = find_backdrop(word);
    if (!backdrop) {
      throw CLI::ValidationError("--backdrop",
                                 fmt::format("'{}' is not dark, light, clear or a colour as #rrggbb", word));
    }
    picture.backdrop = *backdrop;
  };
  app.add_option_function<std::string>(
         "--backdrop", parse, "What is behind: dark (default), light, clear (transparent), or a colour #rrggbb")
      ->type_name("NAME|COLOUR");
  static constexpr Choice<GroundChoice> kGrounds[] = {
      {"auto", GroundChoice::kWhereSeen}, {"shown", GroundChoice::kAlways}, {"none", GroundChoice::kNever}};
  add_choice<GroundChoice>(
      app, "--ground", picture.ground, kGrounds,
      "Whether what is under hair casts a soft shade on the ground it stands on (default: auto, where the "
      "picture shows the feet of a whole body)");
  add_number(app, "--margin", picture.margin, 1.0, 10.0,
             "How far away the camera is, of the distance from which hair and head fill the picture");
}

}  // namespace

void add_picture_options(CLI::App& app, PictureSettings& picture) {
  picture.shadows = &kDeepShadow;
  picture.lights = LightRig::kStudio;
  picture.bust = true;
  picture.ground = GroundChoice::kWhereSeen;
  picture.backdrop = find_backdrop("dark").value_or(Backdrop{});
  add_transparency(app, picture.transparency);
  add_order(app, picture.order);
  add_shadows(app, picture.shadows);
  add_stage(app, picture);
}

}  // namespace coif
