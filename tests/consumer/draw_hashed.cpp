// A program that draws soft hair in one way and holds no other.
#include <coif/renderer.h>

int main() {
  coif::HairRenderer renderer;
  coif::HairModel model;
  const coif::Asset asset;
  // Named at once: a DrawDesc without it names the default.
  const coif::DrawDesc desc{.clip_from_world = {}, .eye = {}, .lights = {}, .transparency = &coif::kHashedMode};
  const bool refused = renderer.create({}) == coif::Status::kBadArgument &&
                       model.upload(renderer, asset, coif::kHashedMode) == coif::Status::kNotCreated &&
                       renderer.draw(model, {}, desc) == coif::Status::kNotCreated;
  return refused ? 0 : 1;
}
