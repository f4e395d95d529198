// Writes the answers as text: verdict, onset, limit, a table of contacts, and the motion of the object.
const told = (() => {
  const at = (id) => document.getElementById(id);
  // Parts are strings or elements.
  const fill = (id, ...parts) => at(id).replaceChildren(...parts);

  const newtons = (factor) => {
    const { force, moment } = state.now.load;
    const parts = [" (", numbers.text(factor * outline.length(force), "N")];
    if (moment !== 0) parts.push(", ", numbers.text(factor * moment, "Nm"));
    return [...parts, ")"].join("");
  };
  const times = (what, factor) => [numbers.element(what, factor, "times"), ` times this load${newtons(factor)}`];

  const onset = ({ onset: first }) => {
    switch (first.outcome) {
      case "at": return [`${words.leaving(first.leaving)} first, at `, ...times("onset", first.factor), `. ${words.beyond(first.beyond)}`];
      case "never": return ["Nothing slides, however large this load grows."];
      case "already_sliding": return ["Something slides or is open by the squeeze alone, before any load acts."];
      case "no_base": return [`There is no equilibrium even without load. ${words.proof(first)}`];
      case "gives_way": return ["Nothing slides, but from ", ...times("onset", first.factor), ` on nothing resists. ${words.proof(first.reason)}`];
      default: return [`Undecided: ${words.doubt(first.doubt)}.`];
    }
  };

  const limit = (found) => {
    const { path } = found, factor = answers.limit(found);
    switch (path.outcome) {
      case "lost": return ["The path from rest ends at ", ...times("limit", factor), `. ${words.beyond(path.beyond)}`];
      case "completed": return [`No limit up to ${state.FAR} times this load.`];
      case "no_start": return ["There is no equilibrium to start from."];
      default: return [`Undecided from ${numbers.text(path.fraction * state.FAR, "times")} times this load on: ${words.doubt(path.doubt)}.`];
    }
  };

  const row = (contact, k) => {
    const { name, state: what, force, margin, gap, slip } = contact;
    const cells = [
      document.createTextNode(words.STATES[what]),
      numbers.element(`normal-${k}`, force[0], "N"), numbers.element(`tangential-${k}`, force[1], "N"),
      numbers.element(`margin-${k}`, margin, "N"),
      what === "separated" ? numbers.element(`gap-${k}`, gap, "mm") : numbers.element(`slip-${k}`, slip[1], "mm"),
    ];
    const line = document.createElement("tr"), head = document.createElement("th");
    head.textContent = name.endsWith(` ${k + 1}`) ? name : `${k + 1} ${name}`;
    line.append(head, ...cells.map((cell, column) => {
      const made = document.createElement("td");
      if (column === 0) made.className = what;
      made.append(cell);
      return made;
    }));
    return line;
  };

  const moves = (who, { translation, rotation }, of) => [
    `The ${who} moves by `, numbers.element(`x${of}`, translation[0], "mm"), ", ", numbers.element(`y${of}`, translation[1], "mm"),
    " and turns by ", numbers.element(`turn${of}`, rotation, "rad"), ". ",
  ];
  const motion = ({ twist, bodies }) =>
    bodies ? bodies.flatMap(({ body, twist: own }, k) => moves(body, own, `-${k}`)) : moves("object", twist, "");

  const tell = (found, factor, toScale) => {
    const [className, headline, explanation] = words.verdict(found);
    at("verdict").className = className;
    fill("verdict", headline);
    fill("why", explanation);
    fill("onset", ...(found.refused ? [] : onset(found)));
    fill("limit", ...(found.refused ? [] : limit(found)));
    fill("warnings", ...(found.warnings || []));
    at("contacts").hidden = !found.held;
    fill("rows", ...(found.held ? found.held.contacts.map(row) : []));
    fill("motion", ...(found.held ? motion(found.held) : []));
    const moved = factor === null ? "" : `Dashed outline: this motion, ${numbers.text(factor, "times")} times as large. `;
    fill("drawn", moved, toScale ? "" : "The load is so small that its arrow is not to scale.");
  };

  return { tell };
})();
