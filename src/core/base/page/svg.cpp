// Scalable Vector Graphics 1.1, https://www.w3.org/TR/SVG11/.
#include <fmt/format.h>

#include <cmath>

#include "core/base/page/page.h"
#include "core/base/page/page_text.h"

namespace taxel {
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

}  // namespace taxel
