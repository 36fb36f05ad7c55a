#include "base/diagnostic.h"

#include "base/json.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace coif::diagnostic_test {

TEST(Diagnostic, NamesFileAndPlaceOnce) {
  const Diagnostic here("S203", "no texture coordinates", Severity::kInfo, "mesh 'a'");
  EXPECT_EQ(here.text("a.glb"), "a.glb: mesh 'a': no texture coordinates [S203]");
  EXPECT_EQ(Diagnostic("S203", "a.glb: mesh 'a': none", Severity::kInfo).text("a.glb"), "a.glb: mesh 'a': none [S203]");
  EXPECT_EQ(Diagnostic("S203", "mesh 'a': none", Severity::kInfo, "mesh 'a'").text("a.glb"),
            "a.glb: mesh 'a': none [S203]");
  EXPECT_EQ(Diagnostic("S203", "none").text(""), "none [S203]");
}

TEST(Diagnostic, IsReadFromTheJsonThatItIsWrittenAs) {
  for (const Severity severity : {Severity::kInfo, Severity::kWarning, Severity::kError}) {
    for (const bool has_patch : {false, true}) {
      Diagnostic told("A201", "name \xFF of no encoding", severity, "patch 7");
      if (has_patch) told.patch = 7;
      // As processes hand it to each other.
      const auto packed = nlohmann::json::to_msgpack(nlohmann::json(told));
      EXPECT_EQ(nlohmann::json::from_msgpack(packed).get<Diagnostic>(), told);
      EXPECT_EQ(nlohmann::ordered_json(told).contains("patch"), has_patch);
    }
  }
}

TEST(Diagnostic, IsNotReadFromAnythingElse) {
  const nlohmann::json whole = Diagnostic("A201", "dark");
  for (const char* key : {"code", "message", "where", "severity"}) {
    nlohmann::json without = whole;
    without.erase(key);
    EXPECT_THROW((void)without.get<Diagnostic>(), nlohmann::json::exception) << key;
    without[key] = 3;
    EXPECT_THROW((void)without.get<Diagnostic>(), nlohmann::json::exception) << key;
  }
}

}  // namespace coif::diagnostic_test
