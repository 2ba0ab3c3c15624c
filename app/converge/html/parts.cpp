#include "app/converge/html/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "app/converge/analysis/figures.h"
#include "app/plot/svg_plot.h"
#include "app/run/text.h"
#include "render/image_files/png.h"

namespace ropelight {
namespace {

/// RFC 4648, section 4.
std::string base64(std::string_view bytes) {
  static constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::size_t const count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < count ? std::uint8_t(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? letters[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

std::string cellHtml(const HtmlCell& cell) {
  return fmt::format("<td>{}{}{}</td>", cell.best ? "<b>" : "", cell.html, cell.best ? "</b>" : "");
}

}  // namespace

std::string rowsHtml(const HtmlTable& table) {
  std::string html;
  for (const auto& row : table.rows) {
    html += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i)
      html += i == 0 ? "<th scope=\"row\">" + row[i].html + "</th>" : cellHtml(row[i]);
    html += "</tr>\n";
  }
  return html;
}

std::string toHtml(const HtmlTable& table) {
  std::string heads;
  for (const std::string& head : table.headsHtml) heads += "<th scope=\"col\">" + head + "</th>";
  return fmt::format("<div class=\"scroll\"><table>\n<thead><tr>{}</tr></thead>\n<tbody>\n{}</tbody></table></div>\n",
                     heads, rowsHtml(table));
}

std::string modeHtml(const std::string& label, std::size_t index) {
  std::string html = fmt::format("<span class=\"mode\"><i style=\"background:{}\"></i>", curveColour(index));
  for (char const c : label) {
    html += escapeMarkup(std::string(1, c));
    if (c == ':' || c == ',') html += "<wbr>";
  }
  return html + "</span>";
}

std::string rangeHtml(const std::string& median, const std::string& low, const std::string& high) {
  return low == high ? median : fmt::format("{}<small>{} to {}</small>", median, low, high);
}

std::string rangeHtml(const BandPoint& band) {
  return rangeHtml(figure(band.median), figure(band.low), figure(band.high));
}

std::string timeHtml(const TimeTo& time, int seeds) {
  if (seeds == 0) return "–";
  if (time.reached == 0) return "<span class=\"quiet\">not reached</span>";
  if (time.reached < seeds)
    return fmt::format("<span class=\"quiet\">reached by {} of {} seeds</span>", time.reached, seeds);
  return rangeHtml(figure(time.median), figure(time.low), figure(time.high));
}

std::string imageHtml(const char* mediaType, std::string_view bytes, const std::string& description) {
  return fmt::format("<img alt=\"{}\" src=\"data:{};base64,{}\">", escapeMarkup(description), mediaType, base64(bytes));
}

std::string imageHtml(const Image& image, const std::string& description) {
  auto const bytes = encodePng(image);
  return imageHtml("image/png", {reinterpret_cast<const char*>(bytes.data()), bytes.size()}, description);
}

std::string paragraph(const char* cssClass, const std::string& text) {
  return fmt::format("<p class=\"{}\">{}</p>\n", cssClass, escapeMarkup(text));
}

}  // namespace ropelight
