#pragma once
// Pieces of an HTML page. Names with html hold markup already; everything else is text and is escaped.

#include <string>
#include <string_view>
#include <vector>

#include "app/converge/analysis/curves.h"

namespace ropelight {

struct HtmlCell {
  std::string html;
  bool best = false;  ///< in bold
};

struct HtmlTable {
  std::vector<std::string> headsHtml;       ///< of the columns, that of the rows' names first
  std::vector<std::vector<HtmlCell>> rows;  ///< each begins with its name
};
std::string toHtml(const HtmlTable& table);

/// Rows alone, for a table with a head of its own.
std::string rowsHtml(const HtmlTable& table);

/// The mode's name beside the colour that its curve has in the plots; it may break behind ':' and ','.
std::string modeHtml(const std::string& label, std::size_t index);

/// A figure, and below it the range over the seeds where there is one.
std::string rangeHtml(const std::string& median, const std::string& low, const std::string& high);
std::string rangeHtml(const BandPoint& band);

/// How many runs reached an error, and after what time.
std::string timeHtml(const TimeTo& time, int seeds);

/// An <img> that holds its own data (RFC 2397).
std::string imageHtml(const char* mediaType, std::string_view bytes, const std::string& description);
/// The image as a screen shows it without exposure, as PNG.
std::string imageHtml(const Image& image, const std::string& description);

/// "<p class=…>text</p>"
std::string paragraph(const char* cssClass, const std::string& text);

}  // namespace ropelight
