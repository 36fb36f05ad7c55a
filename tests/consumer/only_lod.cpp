// A game that chooses levels of detail and simulates elsewhere.
#include <coif/lod.h>

int main() {
  constexpr coif::LodRecord kLods[] = {{0, 1, 0.5f, 0.0f}, {1, 1, 0.0f, 0.01f}};
  const float far_away = coif::screen_share(0.25f, 10.0f, 1.0f);
  return coif::choose_lod(kLods, far_away, 0) == 1 ? 0 : 1;
}
