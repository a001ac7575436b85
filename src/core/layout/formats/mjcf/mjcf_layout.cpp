// MuJoCo scenes: layouts of the plugin taxel.sensor, and touch sensors. A written scene has the mesh, a geom of it and
// the plugin with the whole layout as text. Here the text of one file is read; read_scene_layouts() (core/sim) also
// reads what only the compiled scene has.
#include <fmt/format.h>

#include <filesystem>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/layout/file/layout_json.h"
#include "core/layout/formats/format_rows.h"
#include "core/layout/formats/losses.h"
#include "core/layout/formats/mjcf/mjcf_plugin.h"
#include "core/layout/formats/mjcf/mjcf_sites.h"
#include "core/layout/formats/text/number_words.h"
#include "core/layout/formats/text/xml_node.h"

namespace taxel {
namespace {

std::vector<ImportedLayout> parse_mjcf(const std::string& text, const std::string& file) {
  const XmlFile xml(text, file);
  const XmlNode mujoco = xml.root();
  if (mujoco.name() != "mujoco") mujoco.fail("must be <mujoco>: the file is no MuJoCo scene");
  std::vector<ImportedLayout> layouts = plugin_layouts({mujoco}, file);
  for (ImportedLayout& one : touch_sites(mujoco)) layouts.push_back(std::move(one));
  if (layouts.empty()) throw Error(file, "holds no layout: no plugin taxel.sensor and no <touch> sensor");
  return layouts;
}

/// Returns the layout as text for a scene: the plugin searches its mesh in the folder of the geom's mesh.
std::string text_in_scene(Layout layout) {
  const std::filesystem::path mesh(layout.mesh.file);
  if (mesh.is_relative()) layout.mesh.file = mesh.filename().string();
  return xml_attribute(layout_to_json(layout));
}

WrittenLayouts write_mjcf(const std::vector<ImportedLayout>& layouts) {
  check_taxels_to_write(layouts);
  require_normals(layouts, "a layout");
  std::string assets, instances, geoms, sensors;
  WrittenLayouts written;
  for (std::size_t i = 0; i < layouts.size(); ++i) {
    const ImportedLayout& one = layouts[i];
    const Layout& layout = one.layout;
    if (layout.mesh.file.empty())
      throw Error("", layout.name, "has no mesh, which a scene needs: name it with --mesh FILE");
    const std::string number = layouts.size() > 1 ? fmt::format(" {}", i + 1) : "";
    const std::string geom = xml_attribute(one.geom.empty() ? "skin" + number : one.geom);
    assets +=
        fmt::format("    <mesh name=\"skin{}\" file=\"{}\" scale=\"{}\"/>\n", number, xml_attribute(layout.mesh.file),
                    words_of_numbers({layout.mesh.scale.x, layout.mesh.scale.y, layout.mesh.scale.z}));
    instances += fmt::format(
        "      <instance name=\"taxels{}\">\n        <config key=\"layout\" value=\"{}\"/>\n        <config "
        "key=\"geom\" "
        "value=\"{}\"/>\n      </instance>\n",
        number, text_in_scene(layout), geom);
    geoms += fmt::format(
        "    <body name=\"body of {}\">\n      <geom name=\"{}\" type=\"mesh\" mesh=\"skin{}\" contype=\"0\" "
        "conaffinity=\"0\"/>\n    </body>\n",
        geom, geom, number);
    sensors +=
        fmt::format("    <plugin name=\"taxels{}\" plugin=\"taxel.sensor\" instance=\"taxels{}\"/>\n", number, number);
    if (one.geom.empty()) written.notes.push_back(fmt::format("the geom of the sensor is named \"{}\"", geom));
  }
  written.bytes = "<mujoco>\n  <extension>\n    <plugin plugin=\"taxel.sensor\">\n" + instances +
                  "    </plugin>\n  </extension>\n  <asset>\n" + assets + "  </asset>\n  <worldbody>\n" + geoms +
                  "  </worldbody>\n  <sensor>\n" + sensors + "  </sensor>\n</mujoco>\n";
  return written;
}

bool is_mujoco(std::string_view bytes) {
  return first_element(bytes) == "mujoco";
}

}  // namespace

LayoutFormat mjcf_format() {
  LayoutFormat format{"mjcf", "MuJoCo scene with taxels", {".xml", ".mjcf"}};
  format.holds = {true, true, true, true, true, true, true, true};
  format.reads_several = format.writes_several = format.is_scene = true;
  format.is_start = is_mujoco;
  format.parse = parse_mjcf;
  format.write = write_mjcf;
  return format;
}

}  // namespace taxel
