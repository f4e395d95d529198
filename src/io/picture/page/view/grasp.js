// What is drawn of the grasp and of the answer that is shown.
const drawCone = ({ normal, tangents }, mu, point, normalForce, ink) => {
  const high = scene.cone * normalForce * scene.force, wide = mu * high;
  if (!(high > 0 && wide > 0)) return;
  const rim = Array.from({ length: SIDES }, (_, k) => {
    const [c, s] = [Math.cos((2 * Math.PI * k) / SIDES), Math.sin((2 * Math.PI * k) / SIDES)];
    return add(add(add(point, normal, high), tangents[0], wide * c), tangents[1], wide * s);
  });
  rim.forEach((p, k) => face([point, p, rim[(k + 1) % SIDES]], ink, 0.1));
  loop(rim, ink, 1);
};

const drawDot = (at, state, size) => {
  const [x, y, depth] = project(at);
  paint(depth + 1e-2, () => {
    pen.beginPath();
    pen.arc(x, y, size, 0, 2 * Math.PI);
    const open = !state || state === "separated", ink = COLOURS[state] || GREY;
    [pen.fillStyle, pen.strokeStyle, pen.lineWidth] = [open ? "#fff" : ink, open ? ink : "#fff", open ? 2 : 1];
    pen.fill();
    pen.stroke();
  });
};
const drawContact = (contact, answer, i) => {
  const { point, points, normal, name } = contact;
  // The finger, behind the contact, or a link.
  line(...(contact.line ?? [add(point, normal, -scene.finger), point]), GREY, 5);
  if (answer) {
    const { at } = answer, ink = COLOURS[answer.state];
    if (layers.cones) drawCone(contact, answer.mu, at, answer.normal_force, ink);
    if (layers.forces) arrow(at, answer.force.map((f) => f * scene.force), ink, 3);
    if (layers.displacements) arrow(at, answer.displacement.map((u) => u * scene.displacement), PINK, 2);
    if (answer.slides) arrow(at, answer.slides.map((d) => scene.slip * d), "#7a3600", 2);
    points.forEach((p, k) => drawDot(p, answer.states[k], (points.length > 1 ? 3 : 6) + (i === lit ? 3 : 0)));
  } else {
    drawDot(point, null, i === lit ? 9 : 6);
  }
  if (i === lit || (layers.names && scene.contacts.length <= scene.many)) text(add(point, normal, -scene.finger), name, "#222", i === lit);
};

const drawLoad = ({ at, force, moment, newtons, newton_metres: newtonMetres }) => {
  const pushes = length(force) > 0 || force.some(Boolean), turns = moment.some(Boolean);
  const name = ({ tip, toScale }, what, size, always) => {
    if (layers.names && (always || !toScale)) text(tip, toScale ? what : `${what} ${size}, not to scale`, BLACK, false);
  };
  if (pushes) name(loadArrow(at, force, scene.force, 3, 1), "load", newtons, true);
  if (turns) name(loadArrow(at, moment, scene.moment, 2, 2), pushes ? "moment" : "load", newtonMetres, !pushes);
};

// A round force, and the arrow that stands for it.
const drawScale = () => {
  const pixels = length(add(project([scene.force, 0, 0]), project([0, 0, 0]), -1));
  if (!(pixels > 0)) return;
  const power = 10 ** Math.floor(Math.log10(100 / pixels));
  const round = [5, 2, 1].map((k) => k * power).find((force) => force * pixels <= 100);
  const [from, to] = [canvas.clientWidth - 20 - round * pixels, canvas.clientWidth - 20];
  const y = canvas.clientHeight - 22;
  paint(Infinity, () => {
    path([[from, y], [to - 9, y]]);
    [pen.strokeStyle, pen.fillStyle, pen.lineWidth, pen.font] = [GREY, GREY, 3, "13px sans-serif"];
    pen.stroke();
    path([[to, y], [to - 13, y - 5], [to - 13, y + 5]], true);
    pen.fill();
    pen.fillText(`${Number(round.toPrecision(1))} N`, from, y - 9);
  });
};

const drawAxes = () => {
  // In the corner, turned like the grasp.
  const origin = project(scene.centre), unit = reach / zoom;
  const corner = [46, canvas.clientHeight - 46];
  ["x", "y", "z"].forEach((name, k) => {
    const tip = project(add(scene.centre, [0, 1, 2].map((j) => (j === k ? 0.13 * unit : 0))));
    const end = [corner[0] + tip[0] - origin[0], corner[1] + tip[1] - origin[1]];
    paint(Infinity, () => {
      path([corner, end]);
      [pen.strokeStyle, pen.lineWidth, pen.fillStyle, pen.font] = ["#888", 1.5, "#555", "13px sans-serif"];
      pen.stroke();
      pen.fillText(name, end[0] + 4 * Math.sign(end[0] - corner[0]) - 3, end[1] + 4 * Math.sign(end[1] - corner[1]) + 4);
    });
  });
};

const draw = () => {
  const ratio = window.devicePixelRatio || 1;
  [canvas.width, canvas.height] = [canvas.clientWidth * ratio, canvas.clientHeight * ratio];
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  [pen.lineJoin, pen.lineCap] = ["round", "round"];
  look();
  [strokes, names] = [[], []];
  const frame = scene.frames[shown];
  for (const fixture of scene.fixtures) loop(fixture, "#ccc", 1);
  scene.bodies.forEach(body);
  const shade = shades();
  scene.outlines.forEach((outline, k) => {
    loop(outline, shade, 1.2);
    if (frame && frame.twist && layers.displacements) loop(outline.map((p) => moved(twistOf(frame, k), p)), PINK, 1, [5, 4]);
  });
  const state = frame && frame.contacts ? frame : null;
  scene.contacts.forEach((contact, i) => drawContact(contact, state && state.contacts[i], i));
  if (frame && frame.load && layers.load) drawLoad(frame.load);
  if (frame && frame.leaves && layers.leaves) {
    for (const corners of frame.leaves.lines) loop(corners, VERMILION, 1.5, [5, 4]);
    for (const [from, along] of frame.leaves.arrows) arrow(from, along, VERMILION, 1.5);
  }
  for (const { name, at } of state ? state.yields : []) {
    const [x, y, depth] = project(at);
    paint(depth + 1e-2, () => {
      pen.beginPath();
      pen.arc(x, y, 7, 0, 2 * Math.PI);
      pen.fillStyle = VERMILION;
      pen.fill();
    });
    if (layers.names) text(at, `${name} yields`, VERMILION, false);
  }
  if (state && layers.free) {
    for (const { at, along, turns } of state.free) {
      line(add(at, along, -scene.axis), add(at, along, scene.axis), SKY, 2, [9, 6]);
      text(add(at, along, scene.axis), turns ? "turns freely" : "moves freely", SKY, false);
    }
  }
  drawAxes();
  if (state && layers.forces) drawScale();
  strokes.sort((a, b) => (a.depth < b.depth ? -1 : a.depth > b.depth ? 1 : 0)).forEach(({ draw }) => draw());
  writeNames();
};
