#pragma once

/// What the HTML player has beside the shell of all pages (io/page.h); %BAR% is its play bar.
namespace tandem {
inline namespace v0 {

inline constexpr const char* kPlayerStyle = R"page(:root { --width: 54rem; }
.stage svg { position: absolute; inset: 0; width: 100%; height: 100%; }
#skins path { fill: none; vector-effect: non-scaling-stroke; stroke-width: 1.25px; }
.onion #shape { opacity: .14; }
.strip { display: grid; grid-auto-flow: column; grid-auto-columns: 1fr; gap: .4rem; }
.strip button {
  height: auto; padding: 0; border-radius: 8px; aspect-ratio: 1; overflow: hidden; border-color: transparent;
  background: none;
}
.strip button.near { background: var(--card); border-color: var(--line); }
.strip svg { display: block; width: 100%; height: 100%; }
.strip button { color: var(--soft); }
.strip .key { color: var(--ink); }
@media (max-width: 34rem) { .strip button:nth-child(even) { display: none; } .keys { display: none; } #label { display: none; } }
)page";

inline constexpr const char* kPlayerBody = R"page(<div class="stage" id="stage">
<svg id="picture" role="img" aria-label="The in-between at the slider's position"><g id="skins"></g><g id="shape"></g></svg>
</div>
%BAR%<div class="strip" id="strip"></div>
<p class="keys"><kbd>Space</kbd> play or pause &ensp; <kbd>←</kbd> <kbd>→</kbd> step &ensp; <kbd>O</kbd> onion skin</p>
)page";

inline constexpr const char* kPlayerMore =
    R"page(<datalist id="ticks"></datalist>
<button id="onion" type="button" aria-pressed="false" title="Show all in-betweens at once">Onion skin</button>
)page";

inline constexpr const char* kPlayerScript = R"page(const morph = data;
const keyTimes = morph.keys.map((i) => morph.times[i]);
const last = keyTimes.length - 1;
const still = matchMedia("(prefers-reduced-motion: reduce)").matches;

// The library's blend: evenly from frame to frame, turned and moved with the moving frame.
function mover(i, local) {
  if (!morph.poses) return (x, y) => [x, y];
  const [cx, cy, degrees] = morph.poses[i].map((a, k) => (1 - local) * a + local * morph.poses[i + 1][k]);
  const cosine = Math.cos(degrees * Math.PI / 180), sine = Math.sin(degrees * Math.PI / 180);
  return (x, y) => [cosine * x - sine * y + cx, sine * x + cosine * y + cy];
}

// Path data of every contour.
function blend(s) {
  const [i, local] = locate(morph.times, s);
  const place = mover(i, local);
  return morph.contours.map((contour) => {
    const a = contour.frames[i], b = contour.frames[i + 1];
    let at = 0;
    const next = () => (1 - local) * a[at] + local * b[at++];
    const point = () => place(next(), next()).map((x) => +x.toPrecision(8)).join(" ");
    let d = "M" + point();
    for (const command of contour.commands) {
      d += command + point();
      if (command === "C") d += " " + point() + " " + point();
    }
    return contour.closed ? d + "Z" : d;
  });
}

// Colours change evenly; those of the page (currentColor) are for the browser to mix.
function mixed(a, b, share) {
  if (a === b) return a;
  if (a === "currentColor" || b === "currentColor") return `color-mix(in srgb, ${b} ${100 * share}%, ${a})`;
  const channel = (text, k) => parseInt(text.slice(1 + 2 * k, 3 + 2 * k), 16);
  return `rgb(${[0, 1, 2].map((k) => Math.round((1 - share) * channel(a, k) + share * channel(b, k)))})`;
}

// How a layer is drawn at s.
function styled(layer, s) {
  const [i, local] = locate(keyTimes, s);
  const [a, b] = [layer.keys[i], layer.keys[i + 1]];
  const number = (k) => (1 - local) * a[k] + local * b[k];
  return { fill: mixed(a[0], b[0], local), "fill-opacity": number(1), stroke: mixed(a[2], b[2], local),
           "stroke-opacity": number(3), "stroke-width": number(4), "fill-rule": morph.rule, ...layer.fixed };
}

const svg = (name, attributes) => {
  const node = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const key in attributes) node.setAttribute(key, attributes[key]);
  return node;
};

// Draws the in-between at s into a path per layer. Lines of drawings without a style may be wider.
function draw(group, s, widen = 1) {
  const contours = blend(s);
  while (group.childNodes.length < morph.layers.length) group.append(svg("path", { class: "layer" }));
  morph.layers.forEach((layer, i) => {
    const node = group.childNodes[i], style = styled(layer, s);
    if (morph.plain) style["stroke-width"] *= widen;
    node.setAttribute("d", layer.contours.map((c) => contours[c]).join(""));
    for (const name in style) node.style.setProperty(name, style[name]);
  });
}

const box = morph.view.join(" ");
byId("picture").setAttribute("viewBox", box);

// Film strip: every key and evenly spaced in-betweens.
const each = Math.max(1, Math.round(8 / last));
const strip = last * each;
const stripTimes = [];
for (let i = 0; i <= strip && strip <= 24; i++) {
  const button = document.createElement("button");
  button.type = "button";
  const isKey = i % each === 0;
  const key = Math.min(Math.floor(i / each), last - 1);
  const at = keyTimes[key] + (i / each - key) * (keyTimes[key + 1] - keyTimes[key]);
  stripTimes.push(at);
  button.className = isKey ? "key" : "";
  button.setAttribute("aria-label", isKey ? "Key " + (i / each + 1) : "In-between at " + at.toFixed(2));
  const picture = svg("svg", { viewBox: box, "aria-hidden": "true" });
  draw(picture, at, 5 / 3);
  button.append(picture);
  button.addEventListener("click", () => { pause(); goTo(at); });
  byId("strip").append(button);
}
byId("s").setAttribute("list", "ticks");
for (const time of last > 1 ? keyTimes : []) {
  const tick = document.createElement("option");
  tick.value = time;
  byId("ticks").append(tick);
}

// Onion skin: outlines of all in-betweens, tinted from the first shape's colour to the last one's.
const skins = Math.max(12, last * 4);
function setOnion(on) {
  byId("onion").setAttribute("aria-pressed", on);
  byId("stage").classList.toggle("onion", on);
  byId("skins").replaceChildren();
  for (let i = 0; on && i <= skins; i++) {
    const end = i === 0 || i === skins;
    const path = svg("path", { d: blend(i / skins).join(""), "stroke-opacity": end ? 0.95 : 0.45 });
    path.style.stroke = `color-mix(in srgb, var(--to) ${100 * i / skins}%, var(--from))`;
    if (!path.style.stroke) path.style.stroke = "var(--accent)";
    byId("skins").append(path);
  }
}

function showShape(s) {
  draw(byId("shape"), s);
  const distance = (at) => Math.abs(at - s);
  const near = stripTimes.reduce((best, at, i) => distance(at) < distance(stripTimes[best]) ? i : best, 0);
  [...byId("strip").children].forEach((button, i) => button.classList.toggle("near", i === near));
}

byId("onion").addEventListener("click", () => setOnion(byId("onion").getAttribute("aria-pressed") !== "true"));
document.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const control = event.target.closest("button, input");
  if (event.key === " " && !(control && control.tagName === "BUTTON")) { setPlaying(!playing); event.preventDefault(); }
  else if (event.key === "o" || event.key === "O") byId("onion").click();
  else if (event.key.startsWith("Arrow") && !(control && control.tagName === "INPUT")) {
    const by = { ArrowRight: 0.02, ArrowUp: 0.02, ArrowLeft: -0.02, ArrowDown: -0.02 }[event.key];
    pause(); goTo(s + by); event.preventDefault();
  }
});

// player.html#s=0.5&onion opens at a place, at rest, with all in-betweens.
const placed = open_(morph, showShape);
setOnion(wanted.has("onion"));
if (!still && !placed) setPlaying(true);
)page";

}  // namespace v0
}  // namespace tandem
