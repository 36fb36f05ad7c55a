// A program whose hair casts shadows by depth maps alone.
#include <coif/shadow.h>

int main() {
  coif::HairRenderer renderer;
  coif::HairModel model;
  coif::HairShadow shadow;
  const coif::Asset asset;
  // Named at once: descriptions without them name the defaults.
  const coif::ShadowDesc plain{.technique = &coif::kPlainShadow};
  const bool refused = renderer.create({}) == coif::Status::kBadArgument &&
                       model.upload(renderer, asset, coif::kOpaqueMode) == coif::Status::kNotCreated &&
                       shadow.create(renderer, {}, plain) == coif::Status::kNotCreated &&
                       shadow.begin({}, {}) == coif::Status::kNotCreated &&
                       shadow.draw({}) == coif::Status::kNotCreated;
  return refused ? 0 : 1;
}
