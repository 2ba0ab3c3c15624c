#pragma once
// The look of the report, on screen and on paper.

namespace ropelight {

inline constexpr const char* htmlStyle = R"css(
:root { color-scheme: light; }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 40px 32px 80px; max-width: 1120px; background: #fff; color: #1f2328;
  font: 15px/1.5 "DejaVu Sans", Verdana, Helvetica, Arial, sans-serif; }
h1 { margin: 0 0 4px; font-size: 28px; line-height: 1.2; }
h2 { margin: 64px 0 12px; padding-top: 20px; border-top: 2px solid #1f2328; font-size: 23px; line-height: 1.25; }
h3 { margin: 34px 0 6px; font-size: 16.5px; }
h2 small { margin-left: 10px; color: #59636e; font-size: 14px; font-weight: normal; overflow-wrap: anywhere; }
p { margin: 6px 0; max-width: 110ch; }
.lead, .quiet { color: #59636e; }
.note { color: #59636e; font-size: 13px; }
.verdict { margin: 14px 0; padding: 12px 18px; max-width: none; border-left: 4px solid #0072b2; background: #eef5fa;
  font-size: 16.5px; }
.warning { margin: 10px 0; padding: 8px 18px; max-width: none; border-left: 4px solid #d55e00; background: #fdf2ea; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 3px 20px; margin: 18px 0; }
dt { color: #59636e; }
dd { margin: 0; min-width: 0; overflow-wrap: anywhere; }
code { font: 13px/1.5 "DejaVu Sans Mono", Menlo, Consolas, monospace; overflow-wrap: anywhere; }
.scroll { overflow-x: auto; margin: 8px 0; }
table { border-collapse: collapse; font-size: 14px; line-height: 1.35; font-variant-numeric: tabular-nums; }
th, td { padding: 7px 12px; border-bottom: 1px solid #d8dee4; text-align: right; vertical-align: top; }
thead th { border-bottom: 1.5px solid #1f2328; color: #59636e; font-size: 13px; font-weight: normal;
  vertical-align: bottom; }
th:first-child { padding-left: 4px; text-align: left; }
tbody th { font-weight: normal; }
tbody tr:hover { background: #f6f8fa; }
.group { border-bottom: 1px solid #d8dee4; text-align: center; }
td small { display: block; color: #59636e; font-size: 12px; font-weight: normal; white-space: nowrap; }
.mode { display: inline-block; position: relative; padding-left: 18px; }
.mode i { position: absolute; left: 0; top: 0.35em; width: 10px; height: 10px; border-radius: 50%; }
.plots img { display: block; width: 100%; max-width: 900px; margin: 10px 0 22px; }
.pictures { display: grid; grid-template-columns: repeat(auto-fill, minmax(240px, 1fr)); gap: 24px 20px;
  margin: 14px 0; }
figure { margin: 0; break-inside: avoid; }
figure img { display: block; width: 100%; border: 1px solid #d8dee4; }
figcaption { padding: 5px 0 8px; font-size: 13px; line-height: 1.4; }
figcaption b { display: block; font-size: 14px; overflow-wrap: anywhere; }
.scale { height: 14px; margin-top: 6px;
  background: linear-gradient(90deg, #00f, #0000bc 25%, #000 50%, #bc0000 75%, #f00); }
.ends { display: flex; justify-content: space-between; color: #59636e; font-size: 12px; }
ul { margin: 6px 0; padding-left: 20px; }
details { margin: 10px 0; }
summary { cursor: pointer; color: #0072b2; }
@media print {
  body { padding: 0; max-width: none; font-size: 10.5pt; }
  section + section h2 { break-before: page; margin-top: 0; }
  h2, h3 { break-after: avoid; }
  table, .plots img { break-inside: avoid; }
  .plots img { max-width: 620px; }
  .pictures { grid-template-columns: repeat(auto-fill, minmax(150px, 1fr)); gap: 12px; }
  table { font-size: 8.5pt; }
  th, td { padding: 3px 7px; }
  .scroll { overflow: visible; }
  * { print-color-adjust: exact; }
}
)css";

}  // namespace ropelight
