// Edits of attributes in XML leave the rest of the text unchanged.
#include "core/sim/scene/mjcf_text.h"

#include <gtest/gtest.h>

namespace taxel {
namespace {

TEST(XmlAttributes, ChangeOnlyTheGivenAttributes) {
  const std::string xml = "<a>\n  <mesh name=\"m\" file=\"old.obj\"/>\n  <texture file=\"old.obj\"/><b/></a>\n";
  const std::string changed = change_attributes(xml, [](const XmlAttribute& a) -> std::optional<std::string> {
    if (a.tag == "mesh" && a.name == "file" && a.value == "old.obj") return "new & \"better\".obj";
    return std::nullopt;
  });
  EXPECT_EQ(
      changed,
      "<a>\n  <mesh name=\"m\" file=\"new &amp; &quot;better&quot;.obj\"/>\n  <texture file=\"old.obj\"/><b/></a>\n");
  EXPECT_EQ(change_attributes(xml, [](const XmlAttribute&) { return std::nullopt; }), xml);
}

TEST(XmlAttributes, ReportThePreviousAttribute) {
  std::vector<std::string> seen;
  change_attributes("<config key=\"layout\" value=\"a &lt;b&gt;\"/><config value=\"x\"/>",
                    [&](const XmlAttribute& a) -> std::optional<std::string> {
                      seen.push_back(a.tag + "." + a.name + "=" + a.value + " after " + a.previous);
                      return std::nullopt;
                    });
  EXPECT_EQ(seen, (std::vector<std::string>{"config.key=layout after ", "config.value=a <b> after layout",
                                            "config.value=x after "}));
}

TEST(XmlAttributes, RestoreEscapedText) {
  const std::string text = "{\"a\": [1, 2],\n\t'b' & <c>}";
  EXPECT_EQ(xml_unescaped(xml_escaped(text)), text);
  EXPECT_EQ(xml_escaped(text).find('"'), std::string::npos);
  EXPECT_EQ(xml_unescaped("&#xA;&#10;&unknown;&"), "\n\n&unknown;&");
}

}  // namespace
}  // namespace taxel
