// Texts of pages, and pages as SVG and PDF.

#include "core/base/page/page.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace taxel {
namespace {

/// Widths of the characters from space to tilde, in thousandths of the size: Adobe's font metrics of Helvetica.
constexpr std::array<int, 95> kHelveticaWidths = {
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333,  278, 278, 556, 556, 556,  //
    556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667,  //
    611, 778, 722, 278, 500, 667, 556, 833, 722, 778, 667, 778, 722, 667,  611, 722, 667, 944, 667,  //
    667, 611, 278, 278, 278, 469, 556, 333, 556, 556, 500, 556, 556, 278,  556, 556, 222, 222, 500,  //
    222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500,  500, 334, 260, 334, 584};
constexpr int kDigitWidth = 556;

/// Returns the number of bytes that follow the first byte of a character, or -1 if no character begins with the byte.
int following_bytes(unsigned char first) {
  if (first < 0x80) return 0;
  if (first >= 0xC2 && first < 0xE0) return 1;
  if (first >= 0xE0 && first < 0xF0) return 2;
  return first >= 0xF0 && first < 0xF5 ? 3 : -1;
}

}  // namespace

std::u32string code_points(const std::string& text) {
  std::u32string points;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto first = static_cast<unsigned char>(text[i]);
    const int following = following_bytes(first);
    char32_t point = following <= 0 ? first : first & (0x3Fu >> following);
    bool valid = following >= 0 && i + static_cast<std::size_t>(following) < text.size();
    for (int k = 1; valid && k <= following; ++k) {
      const auto next = static_cast<unsigned char>(text[i + static_cast<std::size_t>(k)]);
      valid = (next & 0xC0u) == 0x80u;
      point = (point << 6u) | (next & 0x3Fu);
    }
    if (valid) i += static_cast<std::size_t>(following);
    const bool control = point < 0x20 || (point >= 0x7F && point < 0xA0);
    const bool surrogate = (point >= 0xD800 && point < 0xE000) || point == 0xFFFE || point == 0xFFFF;
    points.push_back(!valid || surrogate ? U'?' : control ? U' ' : point);
  }
  return points;
}

std::string page_number(double value) {
  if (!std::isfinite(value)) return "0";
  std::string text = fmt::format("{:.3f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string joined_lengths(const std::vector<double>& lengths) {
  std::string text;
  for (const double length : lengths) {
    if (!text.empty()) text += ' ';
    text += page_number(length);
  }
  return text;
}

double helvetica_width(const std::string& text) {
  int width = 0;
  for (const char32_t point : code_points(text))
    width += point >= U' ' && point <= U'~' ? kHelveticaWidths[static_cast<std::size_t>(point - U' ')] : kDigitWidth;
  return 1e-3 * width;
}

// Scalable Vector Graphics 1.1, https://www.w3.org/TR/SVG11/.

namespace {

std::string svg_color(const PageColor& color) {
  const auto byte = [](double part) { return static_cast<int>(std::lround(255 * std::fmin(1, std::fmax(0, part)))); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(color[0]), byte(color[1]), byte(color[2]));
}

void append_utf8(std::string& out, char32_t point) {
  const auto add = [&](char32_t byte) { out += static_cast<char>(static_cast<unsigned char>(byte)); };
  const auto tail = [&](unsigned shift) { add(0x80u | ((point >> shift) & 0x3Fu)); };
  if (point < 0x80) {
    add(point);
  } else if (point < 0x800) {
    add(0xC0u | (point >> 6u)), tail(0);
  } else if (point < 0x10000) {
    add(0xE0u | (point >> 12u)), tail(6), tail(0);
  } else {
    add(0xF0u | (point >> 18u)), tail(12), tail(6), tail(0);
  }
}

/// Returns a text for XML 1.0.
std::string xml_escaped(const std::string& text) {
  std::string out;
  for (const char32_t point : code_points(text)) {
    if (point == U'&') {
      out += "&amp;";
    } else if (point == U'<') {
      out += "&lt;";
    } else if (point == U'>') {
      out += "&gt;";
    } else {
      append_utf8(out, point);
    }
  }
  return out;
}

std::string svg_item(const PageLine& line) {
  std::string path;
  bool begins = true;
  for (const PagePoint& p : line.points) {
    const bool finite = std::isfinite(p.x) && std::isfinite(p.y);
    if (finite) path += fmt::format("{}{} {}", begins ? 'M' : 'L', page_number(p.x), page_number(p.y));
    begins = !finite;
  }
  if (path.empty()) return "";
  std::string dashes = joined_lengths(line.dashes);
  if (!dashes.empty())
    dashes = fmt::format(R"( stroke-dasharray="{}" stroke-dashoffset="{}")", dashes, page_number(line.dash_start));
  return fmt::format(R"(<path d="{}" fill="none" stroke="{}" stroke-width="{}" stroke-linejoin="round"{}/>)", path,
                     svg_color(line.color), page_number(line.width), dashes) +
         "\n";
}

std::string svg_item(const PageRect& rect) {
  return fmt::format(R"(<rect x="{}" y="{}" width="{}" height="{}" fill="{}"/>)",
                     page_number(std::fmin(rect.a.x, rect.b.x)), page_number(std::fmin(rect.a.y, rect.b.y)),
                     page_number(std::abs(rect.b.x - rect.a.x)), page_number(std::abs(rect.b.y - rect.a.y)),
                     svg_color(rect.color)) +
         "\n";
}

std::string svg_item(const PageText& text) {
  const char* anchor = text.anchor == TextAnchor::start    ? "start"
                       : text.anchor == TextAnchor::middle ? "middle"
                                                           : "end";
  const std::string x = page_number(text.at.x), y = page_number(text.at.y);
  const std::string turned = text.upward ? fmt::format(" transform=\"rotate(-90 {} {})\"", x, y) : "";
  return fmt::format(R"(<text x="{}" y="{}" font-size="{}" fill="{}" text-anchor="{}"{}>{}</text>)", x, y,
                     page_number(text.size), svg_color(text.color), anchor, turned, xml_escaped(text.text)) +
         "\n";
}

}  // namespace

std::string page_to_svg(const Page& page) {
  const std::string width = page_number(page.width), height = page_number(page.height);
  std::string svg = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  svg += fmt::format(R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0}pt" height="{1}pt" viewBox="0 0 {0} {1}" )"
                     R"(font-family="Helvetica, Arial, sans-serif">)",
                     width, height);
  svg += "\n<title>" + xml_escaped(page.title) + "</title>\n";
  for (const PageItem& item : page.items) svg += std::visit([](const auto& each) { return svg_item(each); }, item);
  return svg + "</svg>\n";
}

// Portable Document Format 1.4 (Adobe, PDF Reference, third edition): one page, one stream of drawing operators, one of
// the 14 standard fonts, and a table of the places of all objects.

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
