#include "report/page/report_columns.h"

#include "report/made_up_report.h"

#include <gtest/gtest.h>

#include <optional>

namespace coif::report_columns_test {

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
          {"error_pct", &Record::error_pct, {"error", percent_text}, {"error %", 9}},
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

TEST(ReportColumns, PageTablesStandByTheirPlacesAndAlignNumbers) {
  const Table table = page_table(columns(), kRecords);
  std::vector<std::string> titles;
  for (const Column& column : table.columns) titles.push_back(column.title);
  EXPECT_EQ(titles, (std::vector<std::string>{"name", "error", "good", "how many", "time"}));
  EXPECT_EQ(table.columns[0].kind, Column::Kind::kWords);
  EXPECT_EQ(table.columns[2].kind, Column::Kind::kWords);
  for (const std::size_t numbers : {1u, 3u, 4u}) EXPECT_EQ(table.columns[numbers].kind, Column::Kind::kNumbers);
  ASSERT_EQ(table.rows.size(), 2u);
  const char* const cells[2][5] = {{"a", "12.3 %", "yes", "3", "1.2 s"}, {"longer than it", "-", "no", "4", "none"}};
  for (std::size_t row = 0; row < 2; ++row) {
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(table.rows[row][i].text, cells[row][i]) << row << " " << i;
  }
}

TEST(ReportColumns, TextIsAlignedAndNeverCut) {
  EXPECT_EQ(text_heading(columns()), "  name    count  error %  twice\n");
  const std::vector<Record> first = {kRecords[0]}, second = {kRecords[1]};
  EXPECT_EQ(text_lines(columns(), first), "  a           3     12.3  24.68\n");
  EXPECT_EQ(text_lines(columns(), second), "  longer than it      4        -    nan\n");
  EXPECT_EQ(text_table(columns(), std::vector<Record>{}), "");
}

TEST(ReportColumns, CanBeLeftOutByTheirKeys) {
  EXPECT_EQ(keys_of(json_of(columns().without({"name", "time"}), kRecords[0])),
            (Keys{"count", "error_pct", "is_good"}));
}

TEST(ReportColumns, CellsKeepTheirColours) {
  const Columns<Record> one{{"name", [](const Record& record) { return Cell{record.name, CellLook::kBad}; }, {"name"}}};
  EXPECT_EQ(page_table(one, kRecords).rows[0][0].look, CellLook::kBad);
  EXPECT_EQ(json_of(one, kRecords[0])["name"], "a");
}

}  // namespace coif::report_columns_test
