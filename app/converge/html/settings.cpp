#include <fmt/format.h>

#include "app/arguments/values.h"
#include "app/converge/html/parts.h"
#include "app/converge/html/tables.h"
#include "app/run/text.h"

namespace ropelight {
namespace {

struct NamedValue {
  std::string name, value;
};

/// In the order of their list; without the seed, of which every mode has several.
std::vector<NamedValue> valuesOf(Settings settings) {
  std::vector<NamedValue> values;
  settings.params([&](const std::string& name, const auto& value, const ParamInfo&) {
    if (name != "seed") values.push_back({name, formatValue(value)});
  });
  return values;
}

std::string differencesHtml(const StudyMode& mode) {
  std::vector<NamedValue> const values = valuesOf(mode.settings), defaults = valuesOf({});
  std::string html;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (values[i].value != defaults[i].value)
      html += fmt::format(" <code>{}={}</code>", values[i].name, escapeMarkup(values[i].value));
  return html.empty() ? " all as by default" : html;
}

std::string fullTable(const StudyScene& scene) {
  HtmlTable table{{"setting"}, {{{"rays go through"}}, {{"kernels"}}}};
  std::vector<NamedValue> const defaults = valuesOf({});
  for (const NamedValue& value : defaults) table.rows.push_back({{value.name}});
  for (std::size_t i = 0; i < scene.modes.size(); ++i) {
    const StudyMode& mode = scene.modes[i];
    table.headsHtml.push_back(modeHtml(mode.label, i));
    table.rows[0].push_back({escapeMarkup(mode.accel)});
    table.rows[1].push_back({escapeMarkup(mode.kernels)});
    std::vector<NamedValue> const values = valuesOf(mode.settings);
    for (std::size_t k = 0; k < values.size(); ++k)
      table.rows[k + 2].push_back({escapeMarkup(values[k].value), values[k].value != defaults[k].value});
  }
  return toHtml(table);
}

}  // namespace

std::string settingsHtml(const StudyScene& scene) {
  std::string html = "<ul>\n";
  for (const StudyMode& mode : scene.modes)
    html += fmt::format("<li>{}:{}</li>\n", escapeMarkup(mode.label), differencesHtml(mode));
  return html + "</ul>\n<details><summary>All settings</summary>\n" + fullTable(scene) +
         "<p class=\"note\">Bold: other than by default, or an automatic value as it came out.</p></details>\n";
}

}  // namespace ropelight
