// The printed sheet: the numbers of every taxel, valid HTML, and names with special characters.
#include "core/sensor/layout_sheet.h"

#include <gtest/gtest.h>

#include "core/base/text/base64.h"
#include "core/mesh/make/primitives.h"

namespace taxel {
namespace {

SensorModelPtr model_of(const std::string& name) {
  Layout layout;
  layout.name = name;
  layout.mesh.file = "/a/b/plate.obj";
  layout.sampling.density = 2e6;
  layout.material.thickness = 0.001;
  layout.taxels = {
      {7, name, dvec3(0.001, 0, 0.0045), dvec3(0, 0, 2), 0.0015, {}},
      {2, "two", dvec3(-0.002, 0, 0.004), dvec3(0, 1, 1), 0.004, {{dvec3(-0.002, 0, 0.004), dvec3(0, 0, 1), 0.001}}}};
  return build_sensor_model(layout, std::make_shared<TriMesh>(make_box(dvec3(0.010, 0.010, 0.004))), "", "f");
}

/// Returns whether elements are closed in order, except elements without an end tag.
bool balanced(const std::string& html) {
  std::vector<std::string> open;
  for (std::size_t at = html.find('<'); at != std::string::npos; at = html.find('<', at + 1)) {
    const std::size_t end = html.find('>', at);
    if (end == std::string::npos) return false;
    std::string tag = html.substr(at + 1, html.find_first_of(" >", at) - at - 1);
    if (tag == "!DOCTYPE" || tag == "meta" || tag == "img") continue;
    if (tag[0] != '/') {
      open.push_back(tag);
      continue;
    }
    if (open.empty() || open.back() != tag.substr(1)) return false;
    open.pop_back();
  }
  return open.empty();
}

TEST(LayoutSheet, PlacesTheLabelsOfItsImages) {
  const SheetPicture picture{"Pad side", "png", {{0.25, 0.5, "7", false}, {1, 0, "<2>", true}}};
  const std::string html = layout_sheet(*model_of("tip"), {"", "", {picture}});
  EXPECT_NE(html.find("<span style=\"left:25.00%;top:50.00%\">7</span>"), std::string::npos);
  EXPECT_NE(html.find("<span class=\"faint\" style=\"left:100.00%;top:0.00%\">&lt;2&gt;</span>"), std::string::npos);
  EXPECT_TRUE(balanced(html));
}

TEST(LayoutSheet, ContainsEveryTaxelWithItsNumbers) {
  const SensorModelPtr model = model_of("tip");
  const std::string html = layout_sheet(*model, {"tip.taxels.json", "22 November 2026", {}});
  const auto has = [&](const std::string& part) { return html.find(part) != std::string::npos; };
  const auto samples = std::to_string(model->fields.first[1]);
  EXPECT_TRUE(
      has("<tr><td>0</td><td>7</td><td class=\"text\">tip</td><td>1.000</td><td>0.000</td><td>4.500</td>"
          "<td>0.000</td><td>0.000</td><td>1.000</td><td>1.5</td><td>" +
          samples + "</td><td>0.500</td>"))
      << html;
  EXPECT_TRUE(has("<td class=\"text\">subtaxel 0</td><td>-2.000</td>"));
  EXPECT_TRUE(has("2 taxels on plate.obj"));
  EXPECT_TRUE(has("tip.taxels.json &middot; 22 November 2026"));
  EXPECT_TRUE(has("modulus 50 kPa, thickness 1 mm"));
  EXPECT_TRUE(has("<td class=\"text\">warning</td>"))
      << html.substr(html.find("Settings"));  // the problems of the model
  EXPECT_TRUE(balanced(html));
  EXPECT_EQ(html, layout_sheet(*model_of("tip"), {"tip.taxels.json", "22 November 2026", {}}));
}

TEST(LayoutSheet, EscapesNames) {
  const std::string html = layout_sheet(
      *model_of("<script>\"&"), {"<b>", "", {{"\"view\" <1>", "png", {}}, {"2", std::string("\0\xff", 2), {}}}});
  EXPECT_EQ(html.find("<script>"), std::string::npos);
  EXPECT_EQ(html.find("<b>"), std::string::npos);
  EXPECT_NE(html.find("&lt;script&gt;&quot;&amp;"), std::string::npos);
  EXPECT_NE(html.find("alt=\"&quot;view&quot; &lt;1&gt;\" src=\"data:image/png;base64,cG5n\""), std::string::npos);
  EXPECT_NE(html.find("base64,AP8="), std::string::npos);
  EXPECT_TRUE(balanced(html));
}

TEST(Base64, EqualsTheVectorsOfRfc4648) {
  const char* const expected[] = {"", "Zg==", "Zm8=", "Zm9v", "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy"};
  for (std::size_t n = 0; n <= 6; ++n) EXPECT_EQ(base64(std::string("foobar").substr(0, n)), expected[n]);
}

}  // namespace
}  // namespace taxel
