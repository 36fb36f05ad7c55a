#pragma once
// What passes have to say, for tests that ask for it and for those that do not.

#include "cook/recipe/findings.h"

#include <utility>

namespace coif::cook {

/// What a pass returned, beside what it said.
template <typename Result>
struct Told : Findings {
  Result made;
};

/// Runs `pass`, a function of the findings to fill.
template <typename Pass>
[[nodiscard]] auto told(const Pass& pass) {
  Findings findings;
  auto made = pass(findings);
  return Told<decltype(made)>{std::move(findings), std::move(made)};
}

/// For passes whose words do not matter here.
[[nodiscard]] inline Findings& unheard() {
  thread_local Findings findings;
  return findings = {};
}

}  // namespace coif::cook
