// Tables of taxels as a row of the table of formats.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "core/layout/file/taxels_csv.h"
#include "core/layout/formats/layout_format.h"

namespace taxel {
namespace {

constexpr HeldValues kHeldByTables{true, true, true, true, true, false, false, true};

ImportedLayout layout_of_table(CsvTaxels table) {
  ImportedLayout imported;
  imported.layout.taxels = std::move(table.taxels);
  imported.has_units = table.has_units;
  imported.has_density = imported.has_material = imported.has_frame = false;
  imported.notes = {"a table holds taxels only: mesh and settings are to be chosen"};
  if (!table.unread.empty())
    imported.notes.push_back(fmt::format("columns that are not read: {}", fmt::join(table.unread, ", ")));
  if (!table.normals) imported.set_all_normals_missing();
  if (!table.normals) imported.notes.emplace_back("the table has no normals: those of the mesh are taken");
  if (table.radii) return imported;
  imported.set_all_radii_missing();
  imported.notes.push_back(fmt::format("the table has no radii: they are {} m", Taxel().radius));
  return imported;
}

/// Returns "finger" for "/World/finger".
std::string last_name(const std::string& prim) {
  return prim.substr(prim.find_last_of('/') + 1);
}

/// Reads a table as one layout for each USD prim: positions below different prims have different frames.
std::vector<ImportedLayout> parse_table(const std::string& text, const std::string& file) {
  CsvTaxels table = parse_taxels_csv(text, file);
  std::map<std::string, CsvTaxels> by_prim;
  std::vector<std::string> order;
  for (std::size_t i = 0; i < table.taxels.size(); ++i) {
    const std::string& prim = table.prims[i];
    if (!by_prim.contains(prim)) order.push_back(prim);
    CsvTaxels& group = by_prim[prim];
    group.taxels.push_back(std::move(table.taxels[i]));
  }
  std::vector<ImportedLayout> layouts;
  for (const std::string& prim : order) {
    CsvTaxels& group = by_prim[prim];
    group.normals = table.normals;
    group.radii = table.radii;
    group.unread = table.unread;
    group.has_units = table.has_units;
    ImportedLayout imported = layout_of_table(std::move(group));
    imported.geom = prim;
    if (order.size() > 1) imported.layout.name = last_name(prim);
    if (!prim.empty())
      imported.notes.push_back(fmt::format("positions are taken to be in the frame of the mesh of \"{}\"", prim));
    layouts.push_back(std::move(imported));
  }
  return layouts;
}

WrittenLayouts write_table(const std::vector<ImportedLayout>& layouts) {
  check_taxels_to_write(layouts);
  const ImportedLayout& one = layouts.front();
  HeldValues holds = kHeldByTables;
  holds.geom = one.geom.starts_with('/');
  const CsvStyle style{one.has_normals, holds.geom ? one.geom : "-1"};
  return {taxels_to_csv(one.layout.taxels, style), losses_in(layouts, holds, "a table")};
}

}  // namespace

LayoutFormat csv_format() {
  LayoutFormat format{"csv", "Table of taxels", {".csv"}};
  format.holds = kHeldByTables;
  format.reads_several = true;
  format.parse = parse_table;
  format.write = write_table;
  return format;
}

}  // namespace taxel
