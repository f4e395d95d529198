// Grips that can be dragged: fingers along the outline, the head of the load, and its point of application. The tab key visits all of them.
const handles = (() => {
  // Pixels: distance of a finger from its contact, distance of the load grip beyond the head, least distance of that grip from the load's point.
  const FINGER = 34, BEYOND = 18, LEAST = 52;
  // Steps of arrow keys: STEP is a part of the outline or of the size of the object, TURN is in degrees. With the shift key steps are a tenth.
  const STEP = 0.01, TURN = 2;
  const KEYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

  let place, changed, kept = [];

  const grips = () => [
    ...state.dragged().map((finger, k) => ({
      name: finger.name, label: String(k + 1), className: "finger",
      at: () => outline.add(place.pixel(finger.point), place.along(finger.normal), -FINGER / outline.length(finger.normal)),
      drag: (p) => state.place(finger, finger.line.nearest(p)),
      // Counterclockwise, for either orientation of the corners.
      key: ([x, y], part) => state.place(finger, finger.s + (x + y) * part * STEP * finger.line.total * finger.line.turns),
      says: () => `at ${numbers.text(finger.point[0], "m")}, ${numbers.text(finger.point[1], "m")}`,
    })),
    {
      name: "direction of the load", label: "", className: "turns-load",
      at: (scale) => {
        const { force, at } = state.now.load, size = outline.length(force);
        return outline.add(place.pixel(at), place.along(force), Math.max(LEAST, size * scale + BEYOND) / size);
      },
      drag: (p) => {
        const way = outline.add(p, state.now.load.at, -1);
        if (outline.length(way) > 0) state.turnLoad(Math.atan2(way[1], way[0]));
      },
      key: ([x, y], part) => state.turnLoad(state.angleOfLoad() + ((x + y) * part * TURN * Math.PI) / 180),
      says: () => numbers.text(state.angleOfLoad(), "rad"),
    },
    {
      name: "where the load acts", label: "", className: "moves-load",
      at: () => place.pixel(state.now.load.at),
      drag: (p) => { state.now.load.at = p; },
      key: (way, part) => { state.now.load.at = outline.add(state.now.load.at, way, part * STEP * state.now.line.size); },
      says: () => `at ${numbers.text(state.now.load.at[0], "m")}, ${numbers.text(state.now.load.at[1], "m")}`,
    },
  ];

  const element = (grip) => {
    const made = svg.element("g", { class: `grip ${grip.className}`, tabindex: 0, role: "slider", "aria-label": grip.name });
    const radius = grip.className === "moves-load" ? 7 : grip.className === "turns-load" ? 10 : 14;
    if (grip.className === "finger") made.append(svg.line([0, 0], [0, 0], {}));
    // An invisible larger circle, because a touch is less exact than a mouse.
    made.append(svg.element("circle", { r: radius + 8, class: "room" }), svg.element("circle", { r: radius }));
    made.append(svg.text([0, 5], grip.label), svg.text([0, 0], "", { class: "says" }));
    made.addEventListener("pointerdown", (event) => grab(event, grip));
    made.addEventListener("keydown", (event) => {
      const way = KEYS[event.key];
      if (!way) return;
      event.preventDefault();
      grip.key(way, event.shiftKey ? 0.1 : 1);
      changed();
    });
    return made;
  };

  // The window receives moves, because a fast pointer leaves the grip.
  const grab = (event, grip) => {
    event.preventDefault();
    event.currentTarget.focus();
    const root = event.currentTarget.ownerSVGElement;
    const move = (next) => {
      const { left, top } = root.getBoundingClientRect();
      grip.drag(place.metre([next.clientX - left, next.clientY - top]));
      changed();
    };
    const end = () => {
      window.removeEventListener("pointermove", move);
      for (const name of ["pointerup", "pointercancel"]) window.removeEventListener(name, end);
    };
    window.addEventListener("pointermove", move);
    for (const name of ["pointerup", "pointercancel"]) window.addEventListener(name, end);
  };

  // Elements are made anew only for a new scene, so that a grip keeps its focus between drags.
  const build = (group, onChange) => {
    changed = onChange;
    kept = grips().map((grip) => ({ grip, made: element(grip) }));
    group.replaceChildren(...kept.map(({ made }) => made));
  };

  // Writes the state of a finger beside its grip: on the side away from the edge of the picture, else on the other side, else not at all.
  const label = (made, at, { state: what }, taken) => {
    const says = made.querySelector(".says");
    const x = Math.min(place.width - 34, Math.max(34, at[0]));
    const sides = at[1] < place.height / 2 ? [-20, 31] : [31, -20];
    const free = (y) => taken.every(([left, top]) => Math.abs(left - x) >= 68 || Math.abs(top - at[1] - y) >= 16);
    const y = sides.find(free);
    says.textContent = y === undefined ? "" : words.STATES[what];
    if (y === undefined) return;
    taken.push([x, at[1] + y]);
    says.setAttribute("x", x - at[0]);
    says.setAttribute("y", y);
  };

  const update = (into, found, scale) => {
    place = into;
    const taken = [];
    kept.forEach(({ grip, made }, k) => {
      const at = grip.at(scale), contact = found.held && found.held.contacts[k];
      made.setAttribute("transform", `translate(${at[0]} ${at[1]})`);
      made.setAttribute("aria-valuetext", grip.says());
      if (grip.className !== "finger") return;
      const [x, y] = outline.add(place.pixel(state.now.fingers[k].point), at, -1);
      made.querySelector("line").setAttribute("x2", x);
      made.querySelector("line").setAttribute("y2", y);
      made.setAttribute("class", `grip finger ${contact ? contact.state : "unknown"}`);
      if (contact) label(made, at, contact, taken);
      else made.querySelector(".says").textContent = "";
    });
  };

  return { build, update };
})();
