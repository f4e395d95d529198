// Buttons choose an answer; pointer, wheel and keys turn and enlarge.
const show = (k) => {
  shown = k;
  choose(k);
  draw();
};
const light = (i) => {
  if (i === lit) return;
  lit = i;
  for (const row of document.querySelectorAll("tr[data-contact]")) row.classList.toggle("lit", Number(row.dataset.contact) === i);
  draw();
};
const under = ({ offsetX, offsetY }) => {
  const near = scene.contacts.map((point, i) => [Math.hypot(project(point)[0] - offsetX, project(point)[1] - offsetY), i]);
  const [distance, i] = near.reduce((best, next) => (next[0] < best[0] ? next : best));
  return distance < 14 ? i : -1;
};
const turn = (across, down) => {
  yaw -= 0.008 * across;
  pitch = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, pitch + 0.008 * down));
  draw();
};

// One pointer turns, two enlarge.
const held = new Map();
const apart = () => {
  const [a, b] = [...held.values()];
  return Math.hypot(a[0] - b[0], a[1] - b[1]);
};
const enlarge = (factor) => {
  zoom = Math.max(0.2, Math.min(20, zoom * factor));
  draw();
};
canvas.addEventListener("pointerdown", (event) => {
  held.set(event.pointerId, [event.clientX, event.clientY]);
  canvas.setPointerCapture(event.pointerId);
  // A finger has nothing to hover with.
  light(under(event));
});
canvas.addEventListener("pointermove", (event) => {
  const from = held.get(event.pointerId);
  if (!from) return light(under(event));
  const before = held.size === 2 ? apart() : 0;
  held.set(event.pointerId, [event.clientX, event.clientY]);
  if (held.size === 1) turn(event.clientX - from[0], event.clientY - from[1]);
  else if (before > 0) enlarge(apart() / before);
});
for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, ({ pointerId }) => held.delete(pointerId));
canvas.addEventListener("wheel", (event) => {
  event.preventDefault();
  enlarge(Math.exp(-0.0015 * event.deltaY));
}, { passive: false });
canvas.addEventListener("dblclick", () => {
  ({ yaw, pitch, zoom } = START);
  draw();
});
canvas.addEventListener("keydown", (event) => {
  const way = { ArrowLeft: [-15, 0], ArrowRight: [15, 0], ArrowUp: [0, -15], ArrowDown: [0, 15] }[event.key];
  if (!way) return;
  event.preventDefault();
  turn(...way);
});
for (const row of document.querySelectorAll("tr[data-contact]")) {
  row.addEventListener("mouseenter", () => light(Number(row.dataset.contact)));
  row.addEventListener("mouseleave", () => light(-1));
}
onChoice(show);
for (const box of document.querySelectorAll("input[data-layer]")) {
  layers[box.dataset.layer] = box.checked;
  box.addEventListener("change", () => {
    layers[box.dataset.layer] = box.checked;
    draw();
  });
}
window.addEventListener("resize", draw);
draw();
