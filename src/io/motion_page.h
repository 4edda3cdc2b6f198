#pragma once

/// What the page of plots of motions has beside the shell of all pages (io/page.h).
namespace tandem {
inline namespace v0 {

inline constexpr const char* kMotionStyle = R"page(:root { --width: 64rem; }
.plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 22rem), 1fr)); gap: .6rem; }
.plot { width: 100%; background: var(--card); border: 1px solid var(--line); border-radius: 10px; }
.plot text { font: 11px system-ui, sans-serif; fill: var(--soft); }
.plot .name { font-weight: 600; fill: var(--ink); }
.box, .zero { fill: none; stroke: var(--line); }
.zero { stroke-dasharray: 3 3; }
.key, .now { fill: none; stroke-linejoin: round; }
.key { stroke-width: 1.25; opacity: .6; }
.now { stroke: var(--ink); stroke-width: 2; }
.bar { position: sticky; bottom: 0; padding: .5rem 0; background: var(--page); }
)page";

inline constexpr const char* kMotionScript = R"page(const motion = data;
const [left, top_, right, low] = motion.plot;

const share = ([lo, hi], x) => hi > lo ? (x - lo) / (hi - lo) : 0.5;
function line(a, b, local, c) {
  const at = (k, i) => (1 - local) * a[k][i] + local * b[k][i];
  let d = "M";
  for (let i = 0; i < a[0].length; i++) {
    const x = left + (right - left) * share(motion.ranges[0], at(0, i));
    const y = low - (low - top_) * share(motion.ranges[c], at(c, i));
    d += (i ? "L" : "") + x.toFixed(2) + " " + y.toFixed(2);
  }
  return d;
}
const plots = [...document.querySelectorAll(".plot")].map((svg, i) => {
  const path = (name) => {
    const node = document.createElementNS("http://www.w3.org/2000/svg", "path");
    node.setAttribute("class", name);
    svg.append(node);
    return node;
  };
  for (const key of motion.keys) {
    const node = path("key");
    node.setAttribute("d", line(motion.frames[key], motion.frames[key], 0, i + 1));
    node.style.stroke = `color-mix(in srgb, var(--to) ${100 * motion.times[key]}%, var(--from))`;
    if (!node.style.stroke) node.style.stroke = "var(--soft)";
  }
  return path("now");
});

// Nothing moves before it is asked to.
open_(motion, (s) => {
  const [i, local] = locate(motion.times, s);
  plots.forEach((node, c) => node.setAttribute("d", line(motion.frames[i], motion.frames[i + 1], local, c + 1)));
});
)page";

}  // namespace v0
}  // namespace tandem
