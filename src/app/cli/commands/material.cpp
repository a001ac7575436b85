// taxel material: the modulus of a pad from a data sheet.
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "app/cli/command_line.h"
#include "app/cli/report_writer.h"
#include "core/base/error.h"
#include "core/hydro/material/elastomers.h"
#include "core/hydro/material/pad_modulus.h"
#include "core/layout/file/layout_json.h"

namespace taxel::cli {
namespace {
namespace fs = std::filesystem;

struct MaterialOptions {
  std::optional<double> youngs, poisson, thickness, contact_radius, shore_a, shore_00;
  std::string preset, layout, out;
  bool is_bonded = false, is_cylinder = false, is_list = false;
};

struct ElastomerList {
  void visit(ReportWriter& w) const {
    w.list("presets", elastomers(), [](ReportWriter& one, const Elastomer& e) {
      one("name", e.word);
      one("title", e.title);
      one("youngs", e.youngs);
      one("poisson", e.poisson);
      one("density", e.density);
      one("stress_100", e.stress_100);
      one("shore_a", e.shore_a);
      one("shore_00", e.shore_00);
      one("source", e.source);
      one("unverified", e.unverified);
    });
  }
  [[nodiscard]] std::string text() const {
    std::string text;
    for (const Elastomer& e : elastomers())
      text += fmt::format("{:<17} E {:.4g} Pa, nu {:.4f}, {} kg/m^3: {}\n  source: {}\n  unverified: {}\n", e.word,
                          e.youngs, e.poisson, e.density, e.title, e.source, e.unverified);
    return text;
  }
};

struct MaterialReport {
  ElasticLayer layer;
  PressedBody body = PressedBody::ball;
  std::optional<double> contact_radius;
  std::optional<YoungsEstimate> hardness;  ///< if Young's modulus is from a hardness
  std::string source;                      ///< origin of Young's modulus; empty if the modulus was given
  std::string unverified;
  PadModulus result;
  std::string written;  ///< name of the written layout

  void visit(ReportWriter& w) const {
    w("modulus", result.modulus);
    w("thickness", layer.thickness);
    w("youngs", layer.youngs);
    w("poisson", layer.poisson);
    w("bonded", layer.base == LayerBase::bonded);
    w("body", body == PressedBody::ball ? "ball" : "cylinder");
    w("contact_radius", contact_radius);
    w("thin_layer_modulus", result.thin_layer);
    const auto& holds = result.holds;
    w("holds_from", holds ? std::optional(holds->low) : std::nullopt);
    w("holds_to", holds ? std::optional(holds->high) : std::nullopt);
    w("poisson_limit", result.poisson_limit);
    w("poisson_limit_radius", result.poisson_limit_radius);
    w.list("errors", result.errors, [](ReportWriter& one, const ModulusError& e) {
      one("contact_radius", e.contact_radius);
      one("right_modulus", e.right_modulus);
      one("force_error", e.force_error);
    });
    w("youngs_low", hardness ? std::optional(hardness->low) : std::nullopt);
    w("youngs_high", hardness ? std::optional(hardness->high) : std::nullopt);
    w("source", source);
    w("unverified", unverified);
  }
  [[nodiscard]] std::string text() const {
    std::string text = fmt::format("modulus {:.6g} Pa of a pad of {:.6g} m\n", result.modulus, layer.thickness);
    text += fmt::format(
        "  E {:.6g} Pa, nu {:.6g}, {} base{}\n", layer.youngs, layer.poisson,
        layer.base == LayerBase::bonded ? "bonded" : "sliding",
        contact_radius ? fmt::format(", contact radius {:.6g} m", *contact_radius) : ", wide contact (thin layer)");
    if (hardness)
      text += fmt::format("  E from the hardness: {:.3g} to {:.3g} Pa ({})\n", hardness->low, hardness->high, source);
    if (!hardness && !source.empty()) text += fmt::format("  source: {}\n", source);
    if (!unverified.empty()) text += fmt::format("  unverified: {}\n", unverified);
    return text + advice() + (written.empty() ? "" : fmt::format("{}: modulus and thickness written\n", written));
  }
  /// Lines on the contacts for which the modulus is right.
  [[nodiscard]] std::string advice() const {
    const double percent = 100.0 * kModulusTolerance;
    std::string text =
        result.holds
            ? fmt::format("force within {:.0f} % of linear elasticity for contact radii from {:.3g} to {:.3g} m\n",
                          percent, result.holds->low, result.holds->high)
            : fmt::format(
                  "force off by more than {:.0f} % up to a contact radius of {:.3g} m ({:.0f} "
                  "thicknesses): give --contact-radius\n",
                  percent, kLargestRadius * layer.thickness, kLargestRadius);
    if (result.poisson_limit)
      text += fmt::format(
          "  a thin layer's modulus ({:.4g} Pa) is too large by more than {:.0f} % at a contact radius of "
          "{:.3g} m from nu = {:.3f} on\n",
          result.thin_layer, percent, result.poisson_limit_radius, *result.poisson_limit);
    text += "  contact radius [m]  right modulus [Pa]  force by this modulus\n";
    for (const ModulusError& e : result.errors)
      text +=
          fmt::format("  {:<18.4g}  {:<18.5g}  {:+.0f} %\n", e.contact_radius, e.right_modulus, 100.0 * e.force_error);
    return text;
  }
};

/// Takes Young's modulus and Poisson's ratio from the options, a preset or a hardness.
void choose_solid(const MaterialOptions& options, MaterialReport& report) {
  if (!options.preset.empty()) {
    const Elastomer& preset = find_elastomer(options.preset);
    report.layer.youngs = preset.youngs;
    report.layer.poisson = preset.poisson;
    report.source = preset.title + ": " + preset.source;
    report.unverified = preset.unverified;
  } else if (options.shore_a || options.shore_00) {
    report.hardness = options.shore_a ? youngs_from_shore_a(*options.shore_a) : youngs_from_shore_00(*options.shore_00);
    report.layer.youngs = report.hardness->youngs;
    report.layer.poisson = rubber_poisson(report.layer.youngs);
    report.source = report.hardness->source;
  } else if (options.youngs) {
    report.layer.youngs = *options.youngs;
    if (!options.poisson) throw Error("", "poisson", "is missing: it goes with --youngs (rubber: 0.49 to 0.4999)");
  } else {
    throw Error("", "youngs", "is missing: give --youngs and --poisson, --preset, --shore-a or --shore-00");
  }
  if (options.poisson) report.layer.poisson = *options.poisson;
}

/// Writes the layout with modulus and thickness. The mesh is named relative to the new file.
void write_into(Layout layout, const MaterialOptions& options, const MaterialReport& report) {
  if (layout.material.field != FieldKind::pad)
    throw Error(options.layout, "/material/field", "must be \"pad\": a thickness and this modulus are those of a pad");
  layout.material.modulus = report.result.modulus;
  layout.material.thickness = report.layer.thickness;
  const fs::path mesh = fs::absolute(mesh_path(layout, options.layout)).lexically_normal();
  const fs::path folder = fs::absolute(options.out).parent_path().lexically_normal();
  if (folder != fs::absolute(options.layout).parent_path().lexically_normal() && !layout.mesh.file.empty())
    layout.mesh.file = mesh.lexically_relative(folder).string();
  write_layout(options.out, layout);
}

MaterialReport make_report(const MaterialOptions& options) {
  MaterialReport report;
  std::optional<Layout> layout;
  if (!options.layout.empty()) layout = read_layout(options.layout);
  choose_solid(options, report);
  report.layer.base = options.is_bonded ? LayerBase::bonded : LayerBase::sliding;
  report.layer.thickness = options.thickness.value_or(layout ? layout->material.thickness : 0.0);
  if (!options.thickness && report.layer.thickness <= 0.0)
    throw Error("", "thickness", "is missing: give the thickness of the layer in metres");
  report.body = options.is_cylinder ? PressedBody::cylinder : PressedBody::ball;
  report.contact_radius = options.contact_radius;
  report.result = pad_modulus(report.layer, options.contact_radius, report.body);
  if (layout) {
    write_into(*std::move(layout), options, report);
    report.written = options.out;
  }
  return report;
}

/// Returns the option of a field of the core's messages: "--contact-radius" for "contact_radius".
std::string option_of(std::string field) {
  for (char& c : field)
    if (c == '_') c = '-';
  return "--" + field;
}

int run_material_command(const MaterialOptions& options, Console& console) {
  if (!options.out.empty() && options.layout.empty())
    throw Error("material", "--out", "goes with --layout, the layout that receives the modulus");
  if (options.is_list) {
    print_report(console, ElastomerList());
    return kDone;
  }
  try {
    print_report(console, make_report(options));
  } catch (const Error& e) {
    if (!e.file().empty()) throw;
    throw Error("material", option_of(e.where()), e.message());
  }
  return kDone;
}

}  // namespace

Run add_material(OptionList& list) {
  const auto options = std::make_shared<MaterialOptions>();
  list.add("--youngs", &options->youngs, "Young's modulus E [Pa]", {.unit = "PA"});
  list.add("--poisson", &options->poisson, "Poisson's ratio (default: that of the preset, or of a rubber of 1 GPa)",
           {.unit = "NU"});
  list.add("--thickness", &options->thickness, "Thickness H of the layer [m] (default: that of --layout)",
           {.unit = "M"});
  list.add("--bonded", &options->is_bonded, "The layer is glued to its base (default: it slides)");
  list.add("--contact-radius", &options->contact_radius,
           "Radius of the contact for which the force is to be right [m]: sqrt(2 R depth) for a ball of radius R "
           "(default: much wider than the layer is thick)",
           {.unit = "M"});
  list.add("--cylinder", &options->is_cylinder, "A long cylinder touches; the contact radius is half its width");
  list.add("--preset", &options->preset, "E and Poisson's ratio of a known elastomer",
           {.unit = "WORD", .excludes = {"--youngs"}});
  list.add("--shore-a", &options->shore_a, "E from a Shore A hardness (Gent 1958)",
           {.unit = "S", .excludes = {"--youngs", "--preset"}});
  list.add("--shore-00", &options->shore_00, "E from a Shore 00 hardness (Hertz and ASTM D2240)",
           {.unit = "S", .excludes = {"--youngs", "--preset", "--shore-a"}});
  list.add("--out", &options->out, "Write the layout of --layout with modulus and thickness to this file",
           {.unit = "FILE"});
  list.add("--layout", &options->layout, "Layout that receives modulus and thickness",
           {.unit = "FILE", .needs = {"--out"}});
  list.add("--list", &options->is_list, "List the known elastomers with the sources of their numbers");
  return [options](Console& console) { return run_material_command(*options, console); };
}

}  // namespace taxel::cli
