// Draws the load axis, from zero to beyond the limit: the onset of sliding, the end of the path, and the present load.
const loadline = (() => {
  const HEIGHT = 64, TOP = 26, THICK = 14, SIDE = 14;
  // The axis ends at MORE times the last mark, but at most at MORE times MOST, so that marks are not too close together.
  const MORE = 1.25, MOST = 12;

  const bands = (found, end) => {
    const { onset, path } = found, limit = answers.limit(found), first = answers.onset(found);
    const slides = { already_sliding: 0, at: first, gives_way: onset.factor, never: end }[onset.outcome];
    if (path.outcome === "no_start") return [[0, end, "none"]];
    if (slides === undefined) return [[0, end, "doubt"]];
    const last = limit ?? (onset.outcome === "gives_way" ? onset.factor : path.outcome === "undecided" ? path.fraction * state.FAR : end);
    const after = path.outcome === "undecided" ? "doubt" : path.outcome === "lost" && path.beyond.what === "limit_load" ? "none" : "doubt";
    const cut = (x) => Math.min(end, x);
    return [[0, cut(slides), "holds"], [cut(slides), cut(last), "slides"], [cut(last), end, onset.outcome === "gives_way" ? "none" : after]]
      .filter(([from, to]) => to > from);
  };

  const draw = (root, width, found) => {
    root.setAttribute("viewBox", `0 0 ${width} ${HEIGHT}`);
    root.setAttribute("height", HEIGHT);
    if (found.refused) return root.replaceChildren();
    const marks = [[answers.onset(found), "first slides", "onset"], [answers.limit(found), "ends", "limit"]].filter(([x]) => x !== null);
    const end = MORE * Math.min(MOST, Math.max(1.2, ...marks.map(([x]) => x)));
    const at = (x) => SIDE + ((width - 2 * SIDE) * x) / end;
    const parts = bands(found, end).map(([from, to, className]) =>
      svg.element("rect", { x: at(from), y: TOP, width: at(to) - at(from), height: THICK, class: className }));
    const text = (x, y, what) => svg.text([Math.min(width - 44, Math.max(44, x)), y], what, { "text-anchor": "middle" });
    parts.push(svg.polygon([[at(1), TOP - 1], [at(1) - 6, TOP - 10], [at(1) + 6, TOP - 10]], { class: "here" }));
    parts.push(text(at(1), TOP - 13, "this load"));
    const places = marks.map(([x]) => at(x));
    // Two marks that are close together share a label.
    const together = places.length === 2 && places[1] - places[0] < 84;
    marks.forEach(([x, what, className], k) => {
      if (x > end) return;
      parts.push(svg.line([at(x), TOP - 2], [at(x), TOP + THICK + 4], { class: `mark ${className}` }));
      if (!together) parts.push(text(at(x), TOP + THICK + 18, what));
    });
    if (together && marks[0][0] <= end) parts.push(text((places[0] + places[1]) / 2, TOP + THICK + 18, "first slides, ends"));
    if (places.some((x) => x > width)) parts.push(text(width, TOP + THICK + 18, "… farther"));
    root.replaceChildren(...parts);
  };

  return { draw };
})();
