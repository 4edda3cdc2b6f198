#pragma once

/// How the page of a surface is moved, and redrawn; the end of its script.
namespace tandem {
inline namespace v0 {

inline constexpr const char* kSurfaceMoves =
    R"page(let waiting = false, last = 0, speed = [0, 0], goal = null;
const isDragged = () => fingers.size > 0;
function request() {
  if (waiting) return;
  waiting = true;
  requestAnimationFrame((now) => {
    waiting = false;
    const seconds = Math.min((now - last) / 1000, 0.05);
    last = now;
    step(seconds);
    draw();
  });
}

// What moves by itself: a turntable that was asked for, the rest of a push, the way home.
function step(seconds) {
  let moves = false;
  if (goal) {
    const share = still ? 1 : 1 - Math.exp(-9 * seconds);
    let left = 0;
    for (const key in goal) {
      eye[key] += share * (goal[key] - eye[key]);
      left = Math.max(left, Math.abs(goal[key] - eye[key]));
    }
    if (left < 1e-3) { Object.assign(eye, goal); goal = null; } else moves = true;
  }
  if (!still && !isDragged() && Math.hypot(...speed) > 1) {
    turn(speed[0] * seconds, speed[1] * seconds);
    speed = speed.map((x) => x * Math.exp(-5 * seconds));
    moves = true;
  }
  if (shown.spin && !isDragged()) { eye.azimuth += 24 * seconds; moves = true; }
  if (moves) request();
}

function turn(azimuth, elevation) {
  eye.azimuth += azimuth;
  eye.elevation = Math.min(90, Math.max(-90, eye.elevation + elevation));
}

function zoom(factor, x, y) {
  const before = eye.zoom;
  eye.zoom = Math.min(60, Math.max(0.2, eye.zoom * factor));
  // What is under the pointer stays there.
  const box = canvas.getBoundingClientRect(), unit = 2 * 1.04 / Math.min(box.width, box.height);
  const fx = (x - box.left - box.width / 2) * unit, fy = -(y - box.top - box.height / 2) * unit;
  eye.x += fx / eye.zoom - fx / before;
  eye.y += fy / eye.zoom - fy / before;
}

function move(dx, dy) {
  const unit = 2 * 1.04 / Math.min(canvas.clientWidth, canvas.clientHeight) / eye.zoom;
  eye.x += dx * unit;
  eye.y -= dy * unit;
}

const fingers = new Map();
canvas.addEventListener("pointerdown", (event) => {
  canvas.setPointerCapture(event.pointerId);
  fingers.set(event.pointerId, event);
  goal = null;
  speed = [0, 0];
});
canvas.addEventListener("pointermove", (event) => {
  const before = fingers.get(event.pointerId);
  if (!before) return;
  const dx = event.clientX - before.clientX, dy = event.clientY - before.clientY;
  if (fingers.size === 1 && !event.shiftKey && !(event.buttons & 6)) {
    turn(-0.4 * dx, 0.4 * dy);
    const seconds = Math.max((event.timeStamp - before.timeStamp) / 1000, 0.004);
    speed = [0.6 * speed[0] - 0.16 * dx / seconds, 0.6 * speed[1] + 0.16 * dy / seconds];
  } else if (fingers.size === 1) {
    move(dx, dy);
  } else if (fingers.size === 2) {
    const other = [...fingers].find(([id]) => id !== event.pointerId)[1];
    const span = (e) => Math.hypot(e.clientX - other.clientX, e.clientY - other.clientY);
    move(dx / 2, dy / 2);
    zoom(span(event) / Math.max(span(before), 1), (event.clientX + other.clientX) / 2, (event.clientY + other.clientY) / 2);
  }
  fingers.set(event.pointerId, event);
  request();
});
function lift(event) {
  const before = fingers.get(event.pointerId);
  if (before && event.timeStamp - before.timeStamp > 60) speed = [0, 0];
  fingers.delete(event.pointerId);
  last = performance.now();
  request();
}
canvas.addEventListener("pointerup", lift);
canvas.addEventListener("pointercancel", lift);
canvas.addEventListener("contextmenu", (event) => event.preventDefault());
canvas.addEventListener("wheel", (event) => {
  event.preventDefault();
  goal = null;
  zoom(Math.exp(-event.deltaY * (event.deltaMode === 1 ? 0.04 : 0.0015)), event.clientX, event.clientY);
  request();
}, { passive: false });
canvas.addEventListener("dblclick", reset);

function toggle(name) {
  shown[name] = !shown[name];
  byId(name).setAttribute("aria-pressed", shown[name]);
  last = performance.now();
  request();
}
function reset() {
  speed = [0, 0];
  eye.azimuth -= 360 * Math.round((eye.azimuth - home.azimuth) / 360);
  goal = { ...home };
  last = performance.now();
  request();
}
for (const name in shown) byId(name).addEventListener("click", () => toggle(name));
byId("reset").addEventListener("click", reset);
const keys = {
  i: () => toggle("iso"), w: () => toggle("wire"), b: () => toggle("back"), t: () => toggle("spin"), r: reset,
  ArrowLeft: () => turn(-6, 0), ArrowRight: () => turn(6, 0), ArrowUp: () => turn(0, 6), ArrowDown: () => turn(0, -6),
};
addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const box = canvas.getBoundingClientRect();
  const scale = { "+": 1.2, "=": 1.2, "-": 1 / 1.2 }[event.key];
  if (scale) zoom(scale, box.left + box.width / 2, box.top + box.height / 2);
  else if (keys[event.key]) keys[event.key]();
  else if (keys[event.key.toLowerCase()]) keys[event.key.toLowerCase()]();
  else return;
  event.preventDefault();
  request();
});
// At home the scene fills the stage, not the ball about it.
function fill() {
  const points = new Float32Array(bytes(scene.positions)), aspect = canvas.clientWidth / Math.max(canvas.clientHeight, 1);
  const [view, projection] = matrices(aspect);
  let most = 0;
  for (let i = 0; i < points.length; i += 3) {
    const row = (m, k, p) => m[k] * p[0] + m[4 + k] * p[1] + m[8 + k] * p[2] + m[12 + k];
    const at = points.subarray(i, i + 3), p = [0, 1, 2].map((k) => row(view, k, at));
    const w = row(projection, 3, p);
    most = Math.max(most, Math.abs(row(projection, 0, p) / w), Math.abs(row(projection, 1, p) / w));
  }
  if (most > 0) home.zoom = eye.zoom = Math.min(Math.max(0.92 / most, 0.5), 4);
}
fill();
if (scene.planar) byId("back").textContent = "Folds";
new ResizeObserver(request).observe(canvas);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", request);
draw();
)page";

}  // namespace v0
}  // namespace tandem
