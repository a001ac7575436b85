#include "core/sensor/layout_sheet.h"

#include <fmt/format.h>

#include <filesystem>

#include "core/base/math.h"
#include "core/base/text/base64.h"
#include "core/layout/generators/place.h"
#include "core/layout/words.h"

namespace taxel {
namespace {

constexpr double kMillimetres = 1e3;

constexpr const char* kStyle = R"(
@page { size: A4; margin: 15mm }
body { font: 10pt sans-serif; color: #000; background: #fff; max-width: 180mm; margin: auto }
h1 { font-size: 16pt; margin: 0 0 1mm } h2 { font-size: 12pt; margin: 6mm 0 2mm }
p { margin: 0 0 2mm } .small { font-size: 8pt; color: #444 }
.pictures { display: flex; flex-wrap: wrap; gap: 4mm }
figure { margin: 0; width: 86mm; break-inside: avoid } figure.single { width: 100% }
.view { position: relative; border: 0.2mm solid #aaa } img { width: 100%; display: block }
.view span { position: absolute; transform: translate(-50%, -50%); font: bold 7pt sans-serif; padding: 0 0.5mm;
  background: rgba(255, 255, 255, 0.75) } .view span.faint { color: #888; font-weight: normal }
figcaption { font-size: 8pt }
table { border-collapse: collapse; width: 100%; font-size: 8pt; font-variant-numeric: tabular-nums }
thead { display: table-header-group } tr { break-inside: avoid }
th, td { border-bottom: 0.2mm solid #bbb; padding: 0.4mm 1.5mm; text-align: right; white-space: nowrap }
th.text, td.text { text-align: left; white-space: normal; overflow-wrap: anywhere }
tr.sub td { color: #444 }
)";

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

void append_heading(std::string& html, const SensorModel& model, const SheetContent& content) {
  const Layout& layout = model.layout;
  const std::string title = escaped(layout.name.empty() ? "Taxel layout" : layout.name);
  html += fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>{}</title>\n"
      "<style>{}</style>\n</head>\n<body>\n<h1>{}</h1>\n",
      title, kStyle, title);
  html += fmt::format("<p>{} taxels on {}</p>\n", layout.taxels.size(),
                      escaped(std::filesystem::path(layout.mesh.file).filename().string()));
  std::string small;
  for (const std::string& part : {content.file, content.date,
                                  layout.mesh.sha256.empty() ? "" : "mesh sha256 " + layout.mesh.sha256.substr(0, 16)})
    if (!part.empty()) small += (small.empty() ? "" : " &middot; ") + escaped(part);
  if (!small.empty()) html += fmt::format("<p class=\"small\">{}</p>\n", small);
}

std::string label_text(const SheetLabel& label) {
  return fmt::format("<span{} style=\"left:{:.2f}%;top:{:.2f}%\">{}</span>", label.faint ? " class=\"faint\"" : "",
                     100 * label.x, 100 * label.y, escaped(label.text));
}

void append_pictures(std::string& html, const std::vector<SheetPicture>& pictures) {
  if (pictures.empty()) return;
  const char* const single = pictures.size() == 1 ? " class=\"single\"" : "";
  html += "<div class=\"pictures\">\n";
  for (const SheetPicture& picture : pictures) {
    std::string labels;
    for (const SheetLabel& label : picture.labels) labels += label_text(label);
    html += fmt::format(
        "<figure{}><div class=\"view\"><img alt=\"{}\" src=\"data:image/png;base64,{}\">{}</div>"
        "<figcaption>{}</figcaption></figure>\n",
        single, escaped(picture.caption), base64(picture.png), labels, escaped(picture.caption));
  }
  html += "</div>\n";
}

/// Returns the cells from centre to angle, which taxels and subtaxels share. `samples` is empty for subtaxels.
template <class T>
void append_disc(std::string& html, const T& disc, const std::string& samples, const MeshIndex& skin) {
  const SurfacePoint at = skin.closest_point(disc.center);
  const dvec3 c = kMillimetres * disc.center, n = glm::normalize(disc.normal);
  html += fmt::format(
      "<td>{:.3f}</td><td>{:.3f}</td><td>{:.3f}</td><td>{:.3f}</td><td>{:.3f}</td><td>{:.3f}</td>"
      "<td>{:.3g}</td><td>{}</td><td>{:.3f}</td><td>{:.1f}</td></tr>\n",
      c.x, c.y, c.z, n.x, n.y, n.z, kMillimetres * disc.radius, samples, kMillimetres * at.distance,
      angle_deg(n, smooth_normal(skin.mesh(), at)));
}

void append_taxels(std::string& html, const SensorModel& model) {
  html +=
      "<h2>Taxels</h2>\n<table>\n<thead><tr><th>index</th><th>id</th><th class=\"text\">name</th><th>x [mm]</th>"
      "<th>y</th><th>z</th><th>n<sub>x</sub></th><th>n<sub>y</sub></th><th>n<sub>z</sub></th><th>radius [mm]</th>"
      "<th>samples</th><th>off skin [mm]</th><th>angle [&deg;]</th></tr></thead>\n<tbody>\n";
  for (std::size_t k = 0; k < model.layout.taxels.size(); ++k) {
    const Taxel& taxel = model.layout.taxels[k];
    html += fmt::format("<tr><td>{}</td><td>{}</td><td class=\"text\">{}</td>", k, taxel.id, escaped(taxel.name));
    append_disc(html, taxel, std::to_string(model.fields.first[k + 1] - model.fields.first[k]), *model.skin);
    for (std::size_t i = 0; i < taxel.subtaxels.size(); ++i) {
      html += fmt::format("<tr class=\"sub\"><td></td><td></td><td class=\"text\">subtaxel {}</td>", i);
      append_disc(html, taxel.subtaxels[i], "", *model.skin);
    }
  }
  html += "</tbody>\n</table>\n";
}

std::string fields_in_words(const ReceptiveFieldRule& rule) {
  std::string text = fmt::format("{} distance, {}normals within {:g}&deg;", to_word(rule.metric),
                                 rule.normals == FieldNormals::interpolated ? "interpolated " : "", rule.max_angle_deg);
  if (rule.angle_falloff_deg > 0) text += fmt::format(", roll-off {:g}&deg;", rule.angle_falloff_deg);
  return text;
}

void append_settings(std::string& html, const SensorModel& model) {
  const Layout& layout = model.layout;
  html += "<h2>Settings</h2>\n<table>\n<tbody>\n";
  const auto row = [&](const char* what, const std::string& value) {
    html += fmt::format("<tr><td class=\"text\">{}</td><td class=\"text\">{}</td></tr>\n", what, value);
  };
  row("samples", fmt::format("{} on {:.4g} mm&sup2;, {:g} per m&sup2;, seed {}, weights {}", model.samples.size(),
                             kMillimetres * kMillimetres * model.sampled_area, layout.sampling.density,
                             layout.sampling.seed, to_word(layout.sampling.weights)));
  row("receptive fields", fields_in_words(layout.receptive_field));
  row("readout",
      fmt::format("{} [{}]{}, misses {}, rays along the {}, at most {:.4g} mm deep", to_word(layout.readout.aggregate),
                  reading_unit(layout.readout.aggregate),
                  layout.readout.method == ReadingMethod::exact ? ", exact" : "", to_word(layout.readout.misses),
                  to_word(layout.readout.ray), kMillimetres * model.max_depth));
  const Material& m = layout.material;
  row("material",
      fmt::format("{}, modulus {:g} kPa, thickness {:g} mm, dissipation {:g} s/m, friction {:g}{}{}{}",
                  to_word(m.field), m.modulus / 1e3, kMillimetres * m.thickness, m.dissipation, m.friction,
                  m.law.is_linear() ? "" : ", " + to_text(m.law), m.faces == FaceRule::all ? ", all faces count" : "",
                  m.tangential_stiffness > 0
                      ? fmt::format(", sticks with {:g} Pa/m by {} bristles", m.tangential_stiffness, m.bristles)
                      : ""));
  row("frame", fmt::format("distal [{:.3g}, {:.3g}, {:.3g}], pad [{:.3g}, {:.3g}, {:.3g}]", layout.frame.distal.x,
                           layout.frame.distal.y, layout.frame.distal.z, layout.frame.pad.x, layout.frame.pad.y,
                           layout.frame.pad.z));
  html += "</tbody>\n</table>\n";
}

void append_problems(std::string& html, const Problems& problems) {
  if (problems.empty()) return;
  html += "<h2>To look at</h2>\n<table>\n<tbody>\n";
  for (const Problem& p : problems)
    html += fmt::format("<tr><td class=\"text\">{}</td><td class=\"text\">{}</td><td class=\"text\">{}</td></tr>\n",
                        to_string(p.severity), escaped(p.pointer), escaped(p.message));
  html += "</tbody>\n</table>\n";
}

}  // namespace

std::string layout_sheet(const SensorModel& model, const SheetContent& content) {
  std::string html;
  append_heading(html, model, content);
  append_pictures(html, content.pictures);
  append_taxels(html, model);
  append_settings(html, model);
  append_problems(html, model.problems);
  return html + "</body>\n</html>\n";
}

}  // namespace taxel
