#include "report/page/html_page.h"

#include "report/page/number_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <regex>
#include <set>

namespace coif {
namespace {

constexpr const char* kHostile = "</title><script>alert(\"1\" & '2')</script>\x1b\xff";

std::size_t count_of(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

TEST(HtmlPage, EscapesEveryTextThatComesIn) {
  HtmlPage page(kHostile);
  page.heading(kHostile);
  page.summary(kHostile);
  page.paragraph(kHostile);
  page.table({{{kHostile}}, {{{kHostile}}}});
  page.figure("<svg></svg>", kHostile);
  const std::string html = page.text();
  EXPECT_EQ(html.find("<script"), std::string::npos);
  EXPECT_EQ(html.find('\x1b'), std::string::npos);
  EXPECT_EQ(html.find('\xff'), std::string::npos);
  // Twice for the title, which is also the first heading.
  EXPECT_EQ(count_of(html, "&lt;script&gt;alert(&quot;1&quot; &amp; &#39;2&#39;)&lt;/script&gt; \xEF\xBF\xBD"), 8u);
}

TEST(HtmlPage, NeedsNothingBesideItself) {
  HtmlPage page("title");
  page.table({{{"a"}}, {{{"b"}}}});
  const std::string html = page.text();
  for (const char* word : {"src=", "href=", "@import", "url(", "<script", "<link"}) {
    EXPECT_EQ(html.find(word), std::string::npos) << word;
  }
  EXPECT_NE(html.find("default-src 'none'"), std::string::npos);
}

TEST(HtmlPage, NumbersAreRightAlignedAndLooksAreClasses) {
  HtmlPage page("title");
  page.table({{{"name"}, {"value", Column::Kind::kNumbers}},
              {{{"a", CellLook::kGood}, {"1.5", CellLook::kBad}}, {{"b"}, {"2"}}}});
  const std::string html = page.text();
  EXPECT_NE(html.find("<th scope=\"col\" class=\"number\">value</th>"), std::string::npos);
  EXPECT_NE(html.find("<td class=\"good\">a</td><td class=\"number bad\">1.5</td>"), std::string::npos);
  EXPECT_NE(html.find("<td>b</td><td class=\"number\">2</td>"), std::string::npos);
}

TEST(HtmlPage, LineFeedsInCellsAreLines) {
  HtmlPage page("title");
  page.table({{{"a", Column::Kind::kProse}}, {{{"one\n<two>\n"}}}});
  EXPECT_NE(page.text().find("<td class=\"prose\">one<br>&lt;two&gt;<br></td>"), std::string::npos);
}

TEST(HtmlPage, CellsShowPicturesThatLieInThePage) {
  const std::uint8_t bytes[] = {0x89, 'P', 'N', 'G'};
  HtmlPage page("title");
  page.table({{{"a"}}, {{{"bob", CellLook::kPlain, bytes}}, {{"none"}}}});
  EXPECT_NE(page.text().find("<td><img alt=\"\" src=\"data:image/png;base64,iVBORw==\">bob</td>"), std::string::npos);
  EXPECT_NE(page.text().find("<td>none</td>"), std::string::npos);
}

TEST(HtmlPage, ShortRowsAreFilledUp) {
  HtmlPage page("title");
  page.table({{{"a"}, {"b"}, {"c"}}, {{{"1"}}}});
  EXPECT_NE(page.text().find("<td>1</td><td></td><td></td></tr>"), std::string::npos);
}

TEST(HtmlPage, IdsOfFiguresDoNotClash) {
  const char* svg =
      "<svg><defs><path id='dot' d=''/><filter id=\"blur\"/></defs><use xlink:href='#dot'/><use href=\"#dot\"/>"
      "<g filter=\"url(#blur)\"><text>say id='dot' or url(#dot)</text></g></svg>";
  HtmlPage page("title");
  page.figure(svg, "first");
  page.figure(svg, "second");
  const std::string html = page.text();

  std::set<std::string> ids;
  std::size_t definitions = 0;
  const std::regex id("<[^>]* id=['\"]([^'\"]*)['\"]");
  for (std::sregex_iterator it(html.begin(), html.end(), id), end; it != end; ++it, ++definitions) {
    ids.insert((*it)[1]);
  }
  EXPECT_EQ(definitions, 4u);
  EXPECT_EQ(ids.size(), 4u);
  const std::regex reference("(?:href=['\"]|filter=\"url\\()#([^'\")]*)");
  std::size_t references = 0;
  for (std::sregex_iterator it(html.begin(), html.end(), reference), end; it != end; ++it, ++references) {
    EXPECT_TRUE(ids.contains((*it)[1])) << (*it)[1];
  }
  EXPECT_EQ(references, 6u);
  EXPECT_EQ(count_of(html, "say id='dot' or url(#dot)"), 2u) << "text between tags must stay as it is";
}

TEST(NumberText, IsADashWhereThereIsNoNumber) {
  for (const double none : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    EXPECT_EQ(number_text(none), "-");
    EXPECT_EQ(percent_text(none), "-");
    EXPECT_TRUE(number_json(none).is_null());
  }
  EXPECT_EQ(percent_text(12.34), "12.3 %");
  EXPECT_EQ(number_json(0.5), 0.5);
}

TEST(NumberText, IsNearTheNumberAtEverySize) {
  for (double number = 1.3e-4; number < 1.0e12; number *= 7.7) {
    for (const double signed_number : {number, -number}) {
      EXPECT_NEAR(std::stod(number_text(signed_number)), signed_number, 0.04 * number) << number_text(signed_number);
    }
    if (number > 1.0e-3 && number < 1.0e6) {
      EXPECT_EQ(number_text(number).find('e'), std::string::npos) << number_text(number);
    }
  }
  EXPECT_EQ(number_text(0), "0");
  EXPECT_EQ(number_text(1.0e-14), "<0.0001");
}

}  // namespace
}  // namespace coif
