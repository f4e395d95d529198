// The marks of the grasp and of the answer that is shown.
const isShown = ({ layer, tip }) => (layer === "names" || layer === "pointed") && tip === lit || (layer ? layers[layer] : true);
const drawMark = (mark, shade) => {
  const { ink, width } = mark, ofLit = mark.tip !== undefined && mark.tip === lit;
  if (!isShown(mark)) return;
  if (mark.line) line(mark.line, ink, width, mark.dashes);
  else if (mark.edge) line(mark.edge, shade, 1.2);
  else if (mark.body) body(mark.body);
  else if (mark.arrow) arrow(mark.arrow, mark.along, ink, width, mark.heads);
  else if (mark.cone) cone(mark);
  else if (mark.load) load(mark);
  else if (mark.dot) circle(mark.dot, mark.radius + (ofLit ? 3 : 0), ink, mark.open);
  else if (mark.name) text(mark.name, mark.words, ofLit);
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
    [pen.strokeStyle, pen.fillStyle, pen.lineWidth, pen.font] = [scene.grey, scene.grey, 3, "13px sans-serif"];
    pen.stroke();
    path([[to, y], [to - 13, y - 5], [to - 13, y + 5]], true);
    pen.fill();
    pen.fillText(`${Number(round.toPrecision(1))} N`, from, y - 9);
  });
};

const drawAxes = () => {
  // In the corner, turned like the grasp.
  const origin = project(scene.centre), unit = scene.reach / zoom;
  const corner = [46, canvas.clientHeight - 46], letters = [];
  ["x", "y", "z"].forEach((name, k) => {
    const tip = project(add(scene.centre, [0, 1, 2].map((j) => (j === k ? 0.13 * unit : 0))));
    const end = [corner[0] + tip[0] - origin[0], corner[1] + tip[1] - origin[1]];
    let [x, y] = end.map((at, axis) => at + 4 * Math.sign(at - corner[axis]) + (axis ? 4 : -3));
    // Where two axes end in one place, the letter of the second stands above the other.
    while (letters.some((at) => Math.abs(at[0] - x) < 10 && Math.abs(at[1] - y) < 15)) y -= 15;
    letters.push([x, y]);
    paint(Infinity, () => {
      path([corner, end]);
      [pen.strokeStyle, pen.lineWidth, pen.fillStyle, pen.font] = [scene.grey, 1.5, scene.grey, "13px sans-serif"];
      pen.stroke();
      pen.fillText(name, ...letters[k]);
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
  const marks = [...scene.grasp, ...scene.frames[shown]];
  const shade = shades(marks.flatMap(({ edge }) => edge || []));
  for (const mark of marks) drawMark(mark, shade);
  drawAxes();
  if (layers.forces && marks.some(({ layer }) => layer === "forces")) drawScale();
  strokes.sort((a, b) => (a.depth < b.depth ? -1 : a.depth > b.depth ? 1 : 0)).forEach(({ draw }) => draw());
  writeNames();
};
