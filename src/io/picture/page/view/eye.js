// The grasp as data, vectors, and where points come to lie on the canvas: seen from afar.
const scene = JSON.parse(document.getElementById("grasp").textContent);
const canvas = document.getElementById("view");
const pen = canvas.getContext("2d");
const COLOURS = {
  "sticking": "#0072b2", "about-to-slide": "#e69f00", "sliding": "#d55e00", "separated": "#6e6e6e", "frictionless": "#009e73",
};
const [BLACK, GREY, PINK, SKY, VERMILION] = ["#000", "#6e6e6e", "#cc79a7", "#3a8fc8", "#d55e00"];
const SIDES = 32;
const START = { ...scene.view, zoom: 1 };
let { yaw, pitch, zoom } = START;
let shown = 0, lit = -1;
const layers = {};

const add = (a, b, s = 1) => a.map((x, k) => x + s * b[k]);
const dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const length = (a) => Math.hypot(...a);
// To first order, magnified.
// Of several bodies each outline has the twist of its own.
const twistOf = ({ twist, twists }, k) => twists?.[k] ?? twist;
const moved = (twist, p) => add(p, add(twist.slice(0, 3), cross(twist.slice(3), p)), scene.displacement);

// Everything of every answer stays inside the picture, so that answers can be compared.
const reach = (() => {
  const ends = [...scene.outlines.flat(), ...scene.fixtures.flat()];
  for (const { point, normal } of scene.contacts) ends.push(point, add(point, normal, -scene.finger));
  for (const frame of scene.frames.filter(Boolean)) {
    const { load, contacts, twist, leaves } = frame;
    if (load) ends.push(load.at, add(load.at, load.force, scene.force), add(load.at, load.moment, scene.moment));
    if (contacts) contacts.forEach(({ at, force }) => ends.push(add(at, force, scene.force)));
    if (twist) ends.push(...scene.outlines.flatMap((outline, k) => outline.map((p) => moved(twistOf(frame, k), p))));
    if (leaves) ends.push(...leaves.lines.flat(), ...leaves.arrows.map(([from, along]) => add(from, along)));
  }
  return Math.max(...ends.map((p) => length(add(p, scene.centre, -1))), scene.span / 2);
})();

// A point in pixels and its distance towards the eye.
let project = () => [0, 0, 0], perMetre = () => 1;
const look = () => {
  const [cy, sy, cp, sp] = [Math.cos(yaw), Math.sin(yaw), Math.cos(pitch), Math.sin(pitch)];
  const right = [cy, sy, 0], eye = [sy * cp, -cy * cp, sp], up = cross(eye, right);
  const scale = (0.46 * zoom * Math.min(canvas.clientWidth, canvas.clientHeight)) / reach;
  perMetre = () => scale;
  project = (p) => {
    const q = add(p, scene.centre, -1);
    return [canvas.clientWidth / 2 + scale * dot(right, q), canvas.clientHeight / 2 - scale * dot(up, q), scale * dot(eye, q)];
  };
};
