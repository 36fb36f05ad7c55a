// A game that skins on the processor and simulates elsewhere.
#include <coif/skinning.h>

int main() {
  const coif::Asset asset;
  coif::SkinnedVertex out[1];
  return coif::skin_vertices(asset, {}, 0, out) == coif::Status::kAssetLacksData ? 0 : 1;
}
