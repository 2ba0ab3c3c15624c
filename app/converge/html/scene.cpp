#include "app/converge/html/scene.h"

#include <fmt/format.h>

#include <cmath>

#include "app/converge/analysis/figures.h"
#include "app/converge/html/parts.h"
#include "app/converge/html/tables.h"
#include "app/run/text.h"

namespace ropelight {
namespace {

std::string referenceHtml(const Study& study, const StudyScene& scene) {
  const StudyReference& r = scene.reference;
  std::string const noise = std::isnan(r.noise) ? "of unknown noise" : "with a relMSE of " + figure(r.noise);
  std::string html = paragraph("", fmt::format("Reference, {} of its own: {}. ε = {}.", noise,
                                               r.origin.empty() ? "of unknown origin" : r.origin, figure(r.epsilon)));
  if (!scene.device.empty() && scene.device != study.device) html += paragraph("", "Device: " + scene.device);
  for (const StudyMode& mode : scene.modes)
    if (!mode.referenceWarning.empty()) html += paragraph("warning", mode.label + ": " + mode.referenceWarning);
  return html;
}

std::string plotsHtml(const Study& study, const StudyScene& scene) {
  std::string html = "<h3>Error against run time and iterations</h3>\n<div class=\"plots\">\n";
  for (CurveAxis const axis : {CurveAxis::seconds, CurveAxis::iterations}) {
    LinePlot const plot = errorPlot(study, scene, axis);
    html += imageHtml("image/svg+xml", toSvg(plot), plot.title) + "\n";
  }
  return html + "</div>\n";
}

std::string errorsHtml(const Study& study, const StudyScene& scene) {
  return "<h3>Time to an error</h3>\n" + errorTable(study, scene) +
         paragraph(
             "note",
             "Seconds after which the error stays below: median, and range over the seeds; where the first sample "
             "is below already, its time. Slopes of log error over log x, over the last decade of x. Bold: least, "
             "with a 95% interval clear of all others'.");
}

std::string splitHtml(const Study& study, const StudyScene& scene) {
  return "<h3>Bias and variance at the end</h3>\n" + splitTable(study, scene) +
         paragraph("note",
                   "In squared radiance, with shares of the mean square error. Variance is what differs from seed to "
                   "seed and averages out over more runs; bias² is what all seeds have in common, after the noise of "
                   "their mean and, where it is known, of the reference is taken off.");
}

/// Gather discs that an edge cuts find too few photons: there the error falls more slowly.
std::string edgesHtml(const StudyScene& scene) {
  if (scene.edgeRadius == 0) return "";
  return "<h3>Near edges</h3>\n" + edgeTable(scene) +
         paragraph("note",
                   fmt::format("Pixels within a first gather radius, {}, of a place where the normal or the depth "
                               "jumps, and their share of the error at equal time. Discs that an edge cuts find "
                               "too few photons until the radius has shrunk, so that SPPM converges more slowly "
                               "there and slopes of whole images are flatter than theory's of single points.",
                               figure(scene.edgeRadius)));
}

std::string startHtml(const Study& study, const StudyScene& scene) {
  return "<h3>Start-up</h3>\n" + startTable(study, scene) +
         paragraph(
             "note",
             "None of it is in the curves. A tree that modes share is shown with each and was built in the set-up of "
             "the first, which on a GPU makes the context too; the scene's load includes flattening it.");
}

}  // namespace

std::string sceneHtml(const Study& study, const StudyScene& scene) {
  std::string html =
      fmt::format("<section>\n<h2>{} <small>{}</small></h2>\n", escapeMarkup(scene.name), escapeMarkup(scene.file)) +
      paragraph("verdict", verdictOf(scene, study.trimmed)) + referenceHtml(study, scene);
  if (!scene.modes.empty())
    html += errorsHtml(study, scene) + plotsHtml(study, scene) + "<h3>Pictures at equal time</h3>\n" +
            picturesHtml(scene, study.trimmed) + splitHtml(study, scene) + edgesHtml(scene) + startHtml(study, scene) +
            "<h3>Settings</h3>\n" + settingsHtml(scene);
  return html + "</section>\n";
}

}  // namespace ropelight
