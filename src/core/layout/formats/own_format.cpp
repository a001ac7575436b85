// The project's own format as a row of the table.
#include "core/layout/file/layout_json.h"
#include "core/layout/formats/layout_format.h"

namespace taxel {
namespace {

std::vector<ImportedLayout> parse_own(const std::string& text, const std::string& file) {
  ImportedLayout imported;
  LayoutOfFile read = parse_layout_of_file(text, file);
  imported.layout = std::move(read.layout);
  imported.notes = std::move(read.notes);
  imported.has_frame = read.has_frame;
  return {std::move(imported)};
}

/// Notes the values that the layout needs before it can be used.
std::vector<std::string> notes_on_gaps(const ImportedLayout& one) {
  std::vector<std::string> notes;
  if (one.layout.mesh.file.empty())
    notes.emplace_back("the layout has no mesh yet: name it with --mesh FILE, or as mesh.file in the layout");
  if (!one.has_frame) notes.emplace_back("the directions of the sensor are the defaults: distal +z, pad -y");
  if (!one.has_material) notes.emplace_back("the material is the default of a layout");
  return notes;
}

WrittenLayouts write_own(const std::vector<ImportedLayout>& layouts) {
  if (layouts.front().cell > 0) check_taxels_to_write(layouts);
  if (!layouts.front().has_normals) require_normals(layouts, "a layout");
  return {layout_to_json(layouts.front().layout), notes_on_gaps(layouts.front())};
}

}  // namespace

LayoutFormat own_format() {
  LayoutFormat format{"taxels", "Taxel layout", {".taxels.json", ".json"}};
  format.holds = {true, true, true, true, true, true, true, false};
  format.parse = parse_own;
  format.write = write_own;
  return format;
}

}  // namespace taxel
