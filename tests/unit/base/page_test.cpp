// Pages of lines and texts as SVG and PDF: both are parsed back.
#include "core/base/page/page.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>
#include <regex>

namespace taxel {
namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

Page sample_page() {
  Page page{200, 100, "Readings (a\\b) & <c>", {}};
  page.items.push_back(PageRect{{0, 0}, {200, 100}, {1, 1, 1}});
  page.items.push_back(
      PageLine{{{10, 20}, {30, 40}, {kMissing, kMissing}, {50, 60}, {70.25, 80}}, {1, 0, 0}, 1.5, {5, 10}, 2});
  page.items.push_back(PageText{{100, 90}, "50 µm", 10, {0, 0, 0}, TextAnchor::middle, false});
  return page;
}

/// Returns the object at each place of the table at the end of a PDF file. Fails if the table is wrong.
std::vector<std::string> objects_of(const std::string& pdf) {
  std::smatch end;
  EXPECT_TRUE(std::regex_search(pdf, end, std::regex("startxref\n(\\d+)\n%%EOF\n$")));
  const std::size_t table = std::stoul(end[1]);
  EXPECT_EQ(pdf.compare(table, 5, "xref\n"), 0);
  std::size_t at = pdf.find('\n', table + 5);
  const int count = std::stoi(pdf.substr(table + 7, at - table - 7));
  std::vector<std::string> objects;
  for (int i = 0; i < count; ++i) {
    const std::string row = pdf.substr(at + 1 + 20 * static_cast<std::size_t>(i), 20);
    EXPECT_EQ(row[18], ' ');
    EXPECT_EQ(row[19], '\n');
    EXPECT_EQ(row[17], i == 0 ? 'f' : 'n');
    if (i == 0) continue;
    const std::size_t place = std::stoul(row.substr(0, 10));
    const std::string begin = fmt::format("{} 0 obj\n", i);
    EXPECT_EQ(pdf.compare(place, begin.size(), begin), 0) << "object " << i;
    const std::size_t last = pdf.find("\nendobj\n", place);
    objects.push_back(pdf.substr(place + begin.size(), last - place - begin.size()));
  }
  return objects;
}

TEST(PageToPdf, ListsThePlacesOfAllObjects) {
  const std::vector<std::string> objects = objects_of(page_to_pdf(sample_page()));
  ASSERT_EQ(objects.size(), 6U);
  EXPECT_NE(objects[0].find("/Type /Catalog"), std::string::npos);
  EXPECT_NE(objects[2].find("/MediaBox [0 0 200 100]"), std::string::npos);
  EXPECT_NE(objects[4].find("/BaseFont /Helvetica"), std::string::npos);
  EXPECT_EQ(objects[5], "<< /Title (Readings \\(a\\\\b\\) & <c>) /Producer (Taxel Studio) >>");
}

TEST(PageToPdf, GivesTheLengthOfTheStream) {
  const std::string stream = objects_of(page_to_pdf(sample_page()))[3];
  std::smatch found;
  ASSERT_TRUE(std::regex_search(stream, found, std::regex("^<< /Length (\\d+) >>\nstream\n")));
  const std::string content = found.suffix();
  ASSERT_TRUE(content.ends_with("endstream"));
  EXPECT_EQ(content.size() - std::string("endstream").size(), std::stoul(found[1]));
}

TEST(PageToPdf, DrawsFromTheLowerLeftCorner) {
  const std::string stream = objects_of(page_to_pdf(sample_page()))[3];
  EXPECT_NE(stream.find("1 0 0 RG\n1.5 w\n[5 10] 2 d\n10 80 m\n30 60 l\n50 40 m\n70.25 20 l\nS\n"), std::string::npos)
      << stream;
  const double start = 100 - 5 * helvetica_width("50 µm");
  EXPECT_NE(stream.find(fmt::format("BT /F1 10 Tf 1 0 0 1 {:.3f} 10 Tm (50 \\265m) Tj ET\n", start)), std::string::npos)
      << stream;
}

TEST(PageToPdf, WritesAQuestionMarkForAnUnknownCharacter) {
  Page page{10, 10, "t", {PageText{{0, 0}, "a\xE6\x8C\x87z\xFFq", 8, {}, TextAnchor::start, true}}};
  EXPECT_NE(page_to_pdf(page).find("0 1 -1 0 0 10 Tm (a\\077z?q) Tj"), std::string::npos) << page_to_pdf(page);
}

TEST(PageToSvg, WritesLinesRectanglesAndTexts) {
  const std::string svg = page_to_svg(sample_page());
  EXPECT_NE(svg.find(R"(width="200pt" height="100pt" viewBox="0 0 200 100")"), std::string::npos);
  EXPECT_NE(svg.find("<title>Readings (a\\b) &amp; &lt;c&gt;</title>"), std::string::npos);
  EXPECT_NE(svg.find(R"(<rect x="0" y="0" width="200" height="100" fill="#ffffff"/>)"), std::string::npos);
  EXPECT_NE(svg.find(R"(<path d="M10 20L30 40M50 60L70.25 80" fill="none" stroke="#ff0000" stroke-width="1.5" )"
                     R"(stroke-linejoin="round" stroke-dasharray="5 10" stroke-dashoffset="2"/>)"),
            std::string::npos)
      << svg;
  EXPECT_NE(svg.find(R"(text-anchor="middle">50 µm</text>)"), std::string::npos);
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
}

TEST(PageToSvg, KeepsValidCharactersOnly) {
  Page page{10,
            10,
            "a\x01\xC3q\xED\xA0\x80"
            "b",
            {}};
  EXPECT_NE(page_to_svg(page).find("<title>a ?q?b</title>"), std::string::npos) << page_to_svg(page);
}

TEST(PageToSvg, GivesTheSameBytesForTheSamePage) {
  EXPECT_EQ(page_to_svg(sample_page()), page_to_svg(sample_page()));
  EXPECT_EQ(page_to_pdf(sample_page()), page_to_pdf(sample_page()));
}

TEST(HelveticaWidth, SumsTheWidthsOfTheCharacters) {
  EXPECT_DOUBLE_EQ(helvetica_width("0.1"), 0.556 + 0.278 + 0.556);
  EXPECT_DOUBLE_EQ(helvetica_width("iW"), 0.222 + 0.944);
}

}  // namespace
}  // namespace taxel
