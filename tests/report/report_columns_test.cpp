#include "report/page/report_columns.h"

#include "report/made_up_report.h"

#include <gtest/gtest.h>

#include <optional>

namespace coif::report::report_columns_test {

struct Record {
  std::string name;
  std::uint32_t count = 0;
  double error_pct = kNoNumber;
  bool is_good = false;
  std::optional<double> time{};
};

Columns<Record> columns() {
  return {{"count", &Record::count, {"how many", {}, 1}, {"count", 7}},
          {"name", &Record::name, {"name"}, {"name", -6, {}, -1}},
          {"error_pct", &Record::error_pct, {"error", "{percent}"}, {"error %", 9}},
          {"is_good", &Record::is_good, {"good"}},
          {"time", &Record::time, {"time", {"{:.1f} s", "none"}, 2}},
          {kNoKey, [](const Record& record) { return 2 * record.error_pct; }, {}, {"twice", 7, "{:.2f}"}}};
}

const std::vector<Record> kRecords = {{"a", 3, 12.34, true, 1.25}, {"longer than it", 4, kNoNumber, false, {}}};

TEST(ReportColumns, JsonHasTheKeysInTheListsOrderAndNullForWhatIsMissing) {
  EXPECT_EQ(json_list(columns(), kRecords).dump(),
            "[{\"count\":3,\"name\":\"a\",\"error_pct\":12.34,\"is_good\":true,\"time\":1.25},"
            "{\"count\":4,\"name\":\"longer than it\",\"error_pct\":null,\"is_good\":false,\"time\":null}]");
  EXPECT_EQ(json_list(columns(), std::vector<Record>{}).dump(), "[]");
}

TEST(ReportColumns, PageColumnsStandByTheirPlacesAndSayHowToShowValues) {
  EXPECT_EQ(page_columns(columns().forms()).dump(),
            R"([{"key":"name","title":"name","kind":"words"},)"
            R"({"key":"error_pct","title":"error","kind":"number","pattern":"{percent}"},)"
            R"({"key":"is_good","title":"good","kind":"words"},)"
            R"({"key":"count","title":"how many","kind":"number","pattern":"{}"},)"
            R"({"key":"time","title":"time","kind":"number","pattern":"{:.1f} s","missing":"none"}])");
}

TEST(ReportColumns, ListsBringTheirColumnsAlong) {
  nlohmann::ordered_json report;
  add_list(report, "records", columns(), kRecords);
  EXPECT_EQ(report["records"].size(), 2u);
  EXPECT_EQ(report["columns"]["records"], page_columns(columns().forms()));
}

TEST(Format, ShowsEachKindOfValue) {
  EXPECT_EQ(Format("{percent}").text(12.34), "12.3 %");
  EXPECT_EQ(Format("{time}", "-", 1e3).text(2.5), "2.50 us");
  EXPECT_EQ(Format("{bytes}").text(std::uint64_t{1500000}), "1.50 MB");
  EXPECT_EQ(Format("{:+.0f} %").text(25.0), "+25 %");
  EXPECT_EQ(Format("").text(std::uint64_t{123456}), "123456") << "counts with all their digits";
  EXPECT_EQ(Format("").text(0.0123456), "0.0123");
  EXPECT_EQ(Format("{}").text(60.0), "60");
  EXPECT_EQ(Format("front|").text(true), "front");
  EXPECT_EQ(Format("").text(false), "no");
  EXPECT_EQ(Format("{:.1f} dB", "none").text(nullptr), "none");
  EXPECT_EQ(Format("{:.2f}").text({0.5, -1.0, 0.0}), "0.50 -1.00 0.00");
}

TEST(Format, HalfTheSpreadIsColouredWhereTheMachineWasNotSteady) {
  EXPECT_EQ(half_spread().text(60.0), "\u00b130.0 %");
  EXPECT_EQ(half_spread().looks.dump(), R"([{"least":25.0,"look":"warning"}])");
}

TEST(ReportColumns, TextIsAlignedAndNeverCut) {
  EXPECT_EQ(text_heading(columns().forms()), "  name    count  error %  twice\n");
  const std::vector<Record> first = {kRecords[0]}, second = {kRecords[1]};
  EXPECT_EQ(text_lines(columns(), first), "  a           3     12.3  24.68\n");
  EXPECT_EQ(text_lines(columns(), second), "  longer than it      4        -      -\n");
  EXPECT_EQ(text_table(columns(), std::vector<Record>{}), "");
}

TEST(ReportColumns, CanBeLeftOutByTheirKeys) {
  EXPECT_EQ(keys_of(json_of(columns().without({"name", "time"}), kRecords[0])),
            (Keys{"count", "error_pct", "is_good"}));
}

}  // namespace coif::report::report_columns_test
