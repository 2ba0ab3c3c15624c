#include <fmt/format.h>

#include "app/bench/results/result.h"
#include "app/converge/analysis/figures.h"
#include "app/converge/html/parts.h"
#include "app/converge/html/scene.h"

namespace ropelight {
namespace {

bool sameSize(const Image& a, const Image& b) { return a.width == b.width && a.height == b.height; }

std::string captionHtml(const StudyMode& mode, std::size_t index) {
  return fmt::format("<b>{}</b>{}, {} iterations", modeHtml(mode.label, index), duration(mode.pictureSeconds),
                     grouped(mode.pictureIterations));
}

std::string modePicture(const StudyScene& scene, std::size_t index, bool trimmed) {
  const StudyMode& mode = scene.modes[index];
  std::string const picture = imageHtml(mode.picture, mode.label + " at equal time");
  std::string const caption = captionHtml(mode, index);
  if (!sameSize(mode.picture, scene.reference.image))
    return fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", picture, caption);
  MetricsOptions const options{.epsilon = scene.reference.epsilon};
  Metrics const metrics = compareImages(mode.picture, scene.reference.image, options);
  Image const error = errorImage(mode.picture, scene.reference.image, options);
  return fmt::format("<figure>{}<figcaption>{}</figcaption>\n{}<figcaption>{} {}, mean FLIP {}</figcaption></figure>\n",
                     picture, caption, imageHtml(error, "error of " + mode.label), metricName(trimmed),
                     figure(errorOf(metrics, trimmed)), figure(mode.pictureFlip));
}

/// Below it is the scale of the error maps beside it.
std::string referencePicture(const Image& image) {
  return fmt::format(
      "<figure>{}<figcaption><b>reference</b></figcaption>\n<div class=\"scale\"></div><div "
      "class=\"ends\"><span>−100%</span>"
      "<span>0</span><span>+100%</span></div></figure>\n",
      imageHtml(image, "reference"));
}

}  // namespace

std::string picturesHtml(const StudyScene& scene, bool trimmed) {
  std::string figures;
  if (!scene.reference.image.pixels.empty()) figures += referencePicture(scene.reference.image);
  for (std::size_t i = 0; i < scene.modes.size(); ++i)
    if (!scene.modes[i].picture.pixels.empty()) figures += modePicture(scene, i, trimmed);
  if (figures.empty()) return paragraph("quiet", "No picture was taken.");
  return "<div class=\"pictures\">\n" + figures + "</div>\n" +
         paragraph(
             "note",
             "Pictures of the first seed, linear radiance cut at 1, as sRGB. Below each its error map, blue where "
             "it is too dark and red where too bright: the relative error (a − b)/√(b² + ε), averaged over the "
             "channels; green where a pixel is not finite.");
}

}  // namespace ropelight
