#include "app/study/report_parts.h"

namespace firstlight::app {

// Line 0 is what all others are compared with: neutral and dashed. After eight colours they come again, with dots.
std::string_view report_style() {
  return R"css(
:root { color-scheme: light dark;
  --page: #fcfcfb; --ink: #1b1b1a; --soft: #5c5b57; --faint: #e4e3de; --axis: #8f8e88;
  --c0: #5c5b57; --c1: #2a78d6; --c2: #d9541e; --c3: #168a61; --c4: #b07a00; --c5: #c9488c; --c6: #4a3aa7; --c7: #c5302f;
  --c8: #0f7f8c; }
@media (prefers-color-scheme: dark) { :root {
  --page: #1a1a19; --ink: #f1f0ec; --soft: #b5b4ad; --faint: #34342f; --axis: #85847c;
  --c0: #b5b4ad; --c1: #5a9cec; --c2: #ee7d4c; --c3: #35b487; --c4: #d9a22b; --c5: #ea83b4; --c6: #a197f0; --c7: #ef7877;
  --c8: #45b9c6; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 2rem 1.25rem 4rem; max-width: 76rem; background: var(--page); color: var(--ink);
  font: 16px/1.5 system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: 0 0 .4rem; }
h2 { font-size: 1.2rem; margin: 2.6rem 0 .6rem; }
h3 { font-size: 1rem; margin: 0 0 .3rem; }
p, li { max-width: 46rem; }
.soft, figcaption { color: var(--soft); }
code { font-family: ui-monospace, "DejaVu Sans Mono", monospace; font-size: .88em; overflow-wrap: anywhere; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: .92rem; margin: .4rem 0; }
th, td { padding: .35rem .75rem .35rem 0; text-align: right; border-bottom: 1px solid var(--faint); }
th { font-weight: 500; color: var(--soft); vertical-align: bottom; }
th:first-child, td:first-child { text-align: left; }
td { white-space: nowrap; }
.best { font-weight: 700; }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 32rem), 1fr)); gap: 2rem 2.5rem; }
.small { grid-template-columns: repeat(auto-fill, minmax(min(100%, 20rem), 1fr)); gap: 1.2rem 1.5rem; }
figure { margin: 0; min-width: 0; }
figcaption { font-size: .9rem; margin-top: .3rem; }
svg { width: 100%; height: auto; display: block; overflow: visible; }
svg text { font: 12px system-ui, "DejaVu Sans", sans-serif; fill: var(--soft); }
.grid { stroke: var(--faint); } .axis, .tick { stroke: var(--axis); }
.line { fill: none; stroke-width: 1.5; stroke-linejoin: round; }
.line0, .line1 { stroke-width: 2.5; }
.line0 { stroke: var(--c0); stroke-dasharray: 6 4; }
.line1, .line9 { stroke: var(--c1); } .line2, .line10 { stroke: var(--c2); } .line3, .line11 { stroke: var(--c3); }
.line4, .line12 { stroke: var(--c4); } .line5, .line13 { stroke: var(--c5); } .line6, .line14 { stroke: var(--c6); }
.line7, .line15 { stroke: var(--c7); } .line8, .line16 { stroke: var(--c8); }
.line9, .line10, .line11, .line12, .line13, .line14, .line15, .line16 { stroke-dasharray: 1.5 4; stroke-linecap: round; }
.legend { list-style: none; display: flex; flex-wrap: wrap; gap: .1rem 1.1rem; margin: .2rem 0 .3rem; padding: 0;
  font-size: .88rem; }
.legend li { display: flex; align-items: center; gap: .4rem; cursor: default; }
.legend svg { width: 26px; height: 8px; }
.focus .line { opacity: .18; } .focus .lit { opacity: 1; stroke-width: 3; }
.moments { display: grid; gap: .5rem; margin: .3rem 0 1.3rem;
  grid-template-columns: repeat(auto-fill, minmax(8.5rem, 1fr)); }
.moments img { width: 100%; height: auto; display: block; background: #000; }
.moments figcaption { font-size: .8rem; line-height: 1.3; font-variant-numeric: tabular-nums; }
)css";
}

std::string_view report_script() {
  return R"js(
for (const item of document.querySelectorAll('.legend li')) {
  const figure = item.closest('figure');
  const lines = figure.querySelectorAll('.line.' + item.dataset.line);
  const show = on => { figure.classList.toggle('focus', on); for (const l of lines) l.classList.toggle('lit', on); };
  item.addEventListener('pointerenter', () => show(true));
  item.addEventListener('pointerleave', () => show(false));
}
)js";
}

}  // namespace firstlight::app
