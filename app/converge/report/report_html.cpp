#include <fmt/format.h>

#include "app/bench/results/result.h"
#include "app/converge/analysis/figures.h"
#include "app/converge/analysis/report.h"
#include "app/converge/html/parts.h"
#include "app/converge/html/scene.h"
#include "app/converge/html/style.h"
#include "app/converge/html/tables.h"
#include "app/run/text.h"

namespace ropelight {
namespace {

std::string limitText(const Study& study) {
  std::string text;
  if (study.seconds > 0) text = duration(study.seconds);
  if (study.iterations > 0) text += (text.empty() ? "" : " or ") + grouped(study.iterations) + " iterations";
  return text.empty() ? "no limit" : text;
}

std::string errorText(bool trimmed) {
  return std::string(
             "relMSE, the mean of (a − b)²/(b² + ε) over pixels and channels, a the picture and b the reference") +
         (trimmed ? ", without the worst 0.1% of pixels (trimmed)" : ", with all pixels (not trimmed)");
}

std::string bandText(int seeds) {
  if (seeds < 2) return "one; a single seed says nothing of chance, so that no mode is called best";
  return fmt::format(
      "{}; bands run from the least to the largest, and a mode is called best only where the 95% interval of its mean "
      "over the seeds (Student's, of the logarithm) lies clear of all others'",
      seeds);
}

std::string entry(const char* term, const std::string& text) {
  return fmt::format("<dt>{}</dt><dd>{}</dd>\n", term, escapeMarkup(text));
}

std::string headerHtml(const Study& study) {
  std::string html = "<h1>Error against run time</h1>\n<p class=\"lead\">ropelight converge</p>\n";
  if (!study.complete) html += paragraph("warning", "Stopped before the end: scenes or seeds are missing below.");
  return html + "<dl>\n" + entry("Device", study.device + ", " + threadsText(study.threads)) +
         entry("Version", study.version) + entry("Every run", limitText(study)) +
         entry("Seeds", bandText(study.seeds)) + entry("Error", errorText(study.trimmed)) +
         fmt::format("<dt>Command</dt><dd><code>{}</code></dd>\n</dl>\n", escapeMarkup(study.command));
}

std::string summaryHtml(const Study& study) {
  return "<h2>All scenes</h2>\n" + summaryTable(study) +
         paragraph("note", fmt::format("Seconds to {} 0.01, and the {} at the equal time named with the scene. Bold: "
                                       "least, with a 95% interval clear of all others'.",
                                       metricName(study.trimmed), metricName(study.trimmed)));
}

}  // namespace

std::string toHtml(const Study& study) {
  std::string body = headerHtml(study);
  if (study.scenes.empty()) body += paragraph("verdict", "Nothing was measured.");
  if (study.scenes.size() > 1) body += summaryHtml(study);
  for (const StudyScene& scene : study.scenes) body += sceneHtml(study, scene);
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n<title>Error against run time – ropelight</title>\n"
      "<style>{}</style>\n</head>\n<body>\n{}</body>\n</html>\n",
      htmlStyle, body);
}

}  // namespace ropelight
