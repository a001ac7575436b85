// A page of lines, rectangles and texts, which is written as SVG or PDF, and the characters and numbers of its texts.
#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

namespace taxel {

/// A place on a page: from its upper left corner to the right and down [points of 1/72 inch].
struct PagePoint {
  double x = 0, y = 0;
};

using PageColor = std::array<double, 3>;  ///< red, green and blue, each 0 to 1

/// A line through points. A point with a number that is not finite interrupts the line.
struct PageLine {
  std::vector<PagePoint> points;
  PageColor color{};
  double width = 1;            ///< [points]
  std::vector<double> dashes;  ///< lengths of dash and gap in turn [points]; empty for a solid line
  double dash_start = 0;       ///< place in the pattern of dashes at the first point [points]
};

/// A filled rectangle with two opposite corners.
struct PageRect {
  PagePoint a, b;
  PageColor color{};
};

enum class TextAnchor { start, middle, end };

/// A text in Helvetica. `at` is on the base line: at the text's start, middle or end.
struct PageText {
  PagePoint at;
  std::string text;  ///< UTF-8
  double size = 9;   ///< [points]
  PageColor color{};
  TextAnchor anchor = TextAnchor::start;
  bool upward = false;  ///< true for a text that is read from below to above
};

using PageItem = std::variant<PageLine, PageRect, PageText>;

/// A page with its items, the lowest first.
struct Page {
  double width = 0, height = 0;  ///< [points]
  std::string title;             ///< name of the document
  std::vector<PageItem> items;
};

/// Returns the width of a text in Helvetica of size 1. Characters outside of ASCII count as digits.
[[nodiscard]] double helvetica_width(const std::string& text);

/// Returns the page as an SVG document. Texts are text. The same page gives the same bytes.
[[nodiscard]] std::string page_to_svg(const Page& page);

/// Returns the page as a PDF document (version 1.4) in vectors. Texts are text in Helvetica, one of the fonts that
/// every viewer has; a character that the encoding of Western European languages lacks becomes a question mark. The
/// same page gives the same bytes.
[[nodiscard]] std::string page_to_pdf(const Page& page);

/// Returns the code points of a UTF-8 text. A byte that is no part of a character becomes a question mark, and control
/// characters become spaces.
[[nodiscard]] std::u32string code_points(const std::string& text);

/// Returns a length or a colour with at most three decimals, without zeros at the end: "12.5". A number that is not
/// finite becomes 0.
[[nodiscard]] std::string page_number(double value);

/// Returns lengths with spaces between them.
[[nodiscard]] std::string joined_lengths(const std::vector<double>& lengths);

}  // namespace taxel
