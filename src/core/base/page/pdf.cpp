// Portable Document Format 1.4 (Adobe, PDF Reference, third edition): one page, one stream of drawing operators, one of
// the 14 standard fonts, and a table of the places of all objects.
#include <fmt/format.h>

#include <cmath>

#include "core/base/page/page.h"
#include "core/base/page/page_text.h"

namespace taxel {
namespace {

/// Returns a text as a string of PDF in the encoding WinAnsi.
std::string pdf_string(const std::string& text) {
  std::string out = "(";
  for (const char32_t point : code_points(text)) {
    if (point == U'(' || point == U')' || point == U'\\') out += '\\';
    if (point < 0x7F) {
      out += static_cast<char>(point);
    } else {
      const unsigned byte = point >= 0xA0 && point <= 0xFF ? static_cast<unsigned>(point)
                            : point == 0x2013              ? 0x96u
                                                           : 0x3Fu;
      out += fmt::format("\\{:03o}", byte);
    }
  }
  return out + ")";
}

std::string pdf_color(const PageColor& color, const char* set) {
  return fmt::format("{} {} {} {}\n", page_number(color[0]), page_number(color[1]), page_number(color[2]), set);
}

/// Writes the drawing operators of items. The y axis of PDF points up.
struct Operators {
  double height;

  [[nodiscard]] std::string place(const PagePoint& p) const {
    return page_number(p.x) + " " + page_number(height - p.y);
  }
  std::string operator()(const PageLine& line) const {
    std::string path;
    bool begins = true;
    for (const PagePoint& p : line.points) {
      const bool finite = std::isfinite(p.x) && std::isfinite(p.y);
      if (finite) path += place(p) + (begins ? " m\n" : " l\n");
      begins = !finite;
    }
    if (path.empty()) return "";
    const std::string dashes = joined_lengths(line.dashes);
    return pdf_color(line.color, "RG") + fmt::format("{} w\n[{}] {} d\n{}S\n", page_number(line.width), dashes,
                                                     page_number(dashes.empty() ? 0 : line.dash_start), path);
  }
  std::string operator()(const PageRect& rect) const {
    return pdf_color(rect.color, "rg") + fmt::format("{} {} {} re f\n", place(rect.a), page_number(rect.b.x - rect.a.x),
                                                     page_number(rect.a.y - rect.b.y));
  }
  std::string operator()(const PageText& text) const {
    const double width = text.size * helvetica_width(text.text);
    const double before = text.anchor == TextAnchor::start    ? 0
                          : text.anchor == TextAnchor::middle ? 0.5 * width
                                                              : width;
    const PagePoint at =
        text.upward ? PagePoint{text.at.x, text.at.y + before} : PagePoint{text.at.x - before, text.at.y};
    return pdf_color(text.color, "rg") + fmt::format("BT /F1 {} Tf {} {} Tm {} Tj ET\n", page_number(text.size),
                                                     text.upward ? "0 1 -1 0" : "1 0 0 1", place(at),
                                                     pdf_string(text.text));
  }
};

}  // namespace

std::string page_to_pdf(const Page& page) {
  std::string drawing = "1 j\n";
  for (const PageItem& item : page.items) drawing += std::visit(Operators{page.height}, item);
  const std::vector<std::string> objects = {
      "<< /Type /Catalog /Pages 2 0 R >>",
      "<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
      fmt::format("<< /Type /Page /Parent 2 0 R /MediaBox [0 0 {} {}] /Resources << /Font << /F1 5 0 R >> >> "
                  "/Contents 4 0 R >>",
                  page_number(page.width), page_number(page.height)),
      fmt::format("<< /Length {} >>\nstream\n{}endstream", drawing.size(), drawing),
      "<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding >>",
      fmt::format("<< /Title {} /Producer (Taxel Studio) >>", pdf_string(page.title))};
  std::string pdf = "%PDF-1.4\n%\xE2\xE3\xCF\xD3\n";  // bytes above 127 say that the file is not text
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    places.push_back(pdf.size());
    pdf += fmt::format("{} 0 obj\n{}\nendobj\n", i + 1, objects[i]);
  }
  const std::size_t table = pdf.size();
  pdf += fmt::format("xref\n0 {}\n0000000000 65535 f \n", objects.size() + 1);
  for (const std::size_t place : places) pdf += fmt::format("{:010} 00000 n \n", place);
  pdf +=
      fmt::format("trailer\n<< /Size {} /Root 1 0 R /Info 6 0 R >>\nstartxref\n{}\n%%EOF\n", objects.size() + 1, table);
  return pdf;
}

}  // namespace taxel
