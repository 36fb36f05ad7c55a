// A game that names the thesis's solver and no other.
#include <coif/hair.h>

int main() {
  coif::Hair hair;
  const coif::Asset asset;
  const coif::HairDesc desc{.solver = &coif::kThesisSolver};
  return hair.create(asset, desc, {}) == coif::Status::kAssetLacksData && hair.step({}) != coif::Status::kOk ? 0 : 1;
}
