// Two estimates of one scene, and the reference that both are measured against.

#include <fmt/format.h>
#include <imgui.h>

#include <cmath>

#include "app/viewer/panel/panel.h"
#include "app/viewer/panel/parts.h"
#include "app/viewer/session/error_curves.h"
#include "app/viewer/widgets/param_widgets.h"

namespace ropelight::view {
namespace {

void drawLayout(CompareSettings& compare) {
  editParam("compare", "layout", compare.layout,
            {.doc = "how the two share the picture (V)", .choices = choicesOf<Layout>});
  static constexpr ChoiceInfo others[] = {{"B", "the other estimate"}, {"reference", "what errors are against"}};
  int against = compare.withReference ? 1 : 0;
  if (editChoice("compare", "against", against, {.doc = "what A is compared with in the picture", .choices = others}))
    compare.withReference = against == 1;
  if (compare.layout == Layout::split)
    editParam("compare", "split", compare.split, {.doc = "share of the picture that A has ([, ])", .min = 0, .max = 1});
  if (compare.layout == Layout::flicker)
    editParam("compare", "rate", compare.flickerHz,
              {.doc = "swaps a second", .min = 0.1, .max = 30, .unit = "Hz", .logarithmic = true});
  if (compare.layout == Layout::difference)
    editParam(
        "compare", "gain", compare.gain,
        {.doc = "of the absolute difference", .min = 1e-3, .max = 1e6, .low = 0.1, .high = 1000, .logarithmic = true});
}

void drawReference(PanelContext& context) {
  const ReferenceStatus& reference = context.reference;
  std::string text = reference.present ? reference.name : "none: open an EXR of this scene, or accumulate one";
  if (reference.accumulating)
    text = fmt::format("{}, {} iterations", reference.name.empty() ? "accumulating" : reference.name,
                       reference.iterations);
  valueRow("reference", text, "the image that errors are measured against");
  if (!reference.problem.empty()) problemText(reference.problem);
  editParam("reference", "accumulate", context.state.compare.accumulateReference,
            {.doc = "let the path tracer make a reference in the background; it takes a share of the machine"});
  if (!reference.present) return;
  rowLabel("", {});
  if (markedButton("clear reference", "reference/clear", "", -1)) context.actions.clearReference = true;
}

void drawError(const char* name, const EstimateStatus& status) {
  if (status.errors.empty()) return;
  std::string text = fmt::format("{:.3g} after {:.3g} s", status.errors.back().relMse, status.errors.back().seconds);
  if (std::isfinite(status.slope)) text += fmt::format(", slope {:.2f}", status.slope);
  valueRow(name, text, "relMSE against the reference, and the exponent of run time that the later half follows");
}

void drawVerdict(const PanelContext& context) {
  const EstimateStatus &a = context.estimates[0], &b = context.estimates[1];
  drawError("error of A", a);
  if (!context.state.compare.enabled) return;
  drawError("error of B", b);
  if (context.reference.present) wrappedText(closerSentence(errorCurve(a), errorCurve(b)));
}

}  // namespace

void drawCompare(PanelContext& context) {
  ViewState& state = context.state;
  CompareSettings& compare = state.compare;
  bool const switched = editParam("compare", "enabled", compare.enabled,
                                  {.doc = "a second estimate B of this scene shares the machine's time (C)"});
  if (switched && compare.enabled && compare.layout == Layout::single) compare.layout = Layout::split;
  if (compare.enabled || context.reference.present) drawLayout(compare);
  if (compare.enabled) {
    rowLabel("settings", {});
    bool const editsA = state.edited == estimateA;
    if (markedButton(editsA ? "copy A's to B" : "copy B's to A", "compare/copy", "both then differ by noise alone", -1))
      context.actions.copySettingsToOther = true;
  }
  drawReference(context);
  drawVerdict(context);
  markedCheckbox("error plot", "show/plot", state.plotShown, "error against run time (L)");
  ImGui::SameLine();
  markedCheckbox("inspector", "show/inspector", state.inspectorShown, "values under the cursor (I)");
}

}  // namespace ropelight::view
