// A game that draws hair and simulates elsewhere. Without a context all of it is refused.
#include <coif/renderer.h>

int main() {
  coif::HairRenderer renderer;
  coif::HairModel model;
  const coif::Asset asset;
  const bool refused = renderer.create({}) == coif::Status::kBadArgument &&
                       model.upload(renderer, asset) == coif::Status::kNotCreated &&
                       renderer.draw(model, {}, {}) == coif::Status::kNotCreated;
  return refused ? 0 : 1;
}
