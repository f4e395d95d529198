// Sliders. A slider sets the state, and is updated after any other change of the state.
const controls = (() => {
  const now = state.now;
  // Steps of a logarithmic slider for each power of ten.
  const STEPS = 100;
  const power = (low, high, read, write) => ({
    min: STEPS * Math.log10(low), max: STEPS * Math.log10(high), step: 1,
    read: () => STEPS * Math.log10(read()), write: (x) => write(10 ** (x / STEPS)),
  });

  // Squeeze of all fingers, as forces or commands along the normals: one number, or the least and the largest.
  const squeezed = () => {
    const inwards = ({ pressed, command }) => (pressed ?? (command ? command[0] : 0)) * now.squeeze;
    const [least, most] = [Math.min, Math.max].map((pick) => pick(...state.dragged().map(inwards)));
    const unit = now.fingers[0].pressed ? "N" : now.line.size < 1 ? "mm" : "m";
    return least === most ? `${numbers.text(most, unit)} each` : `${numbers.text(least, unit)} to ${numbers.text(most, unit)}`;
  };
  const ratio = () => {
    const { rest } = now.fingers[0];
    const series = (axis) => ["body_stiffness", "finger_stiffness", "series_stiffness"]
      .filter((field) => rest[field]).reduce((sum, field) => sum + 1 / rest[field][axis], 0);
    return `${numbers.text((now.ratio * series(0)) / series(1), "times")} × normal`;
  };

  const SLIDERS = {
    friction: { min: 0, max: 1.5, step: 0.01, read: () => now.friction, write: (x) => { now.friction = x; }, says: () => numbers.text(now.friction, "times") },
    squeeze: { min: 0, max: 3, step: 0.01, read: () => now.squeeze, write: (x) => { now.squeeze = x; }, says: squeezed },
    ratio: { ...power(0.02, 50, () => now.ratio, (x) => { now.ratio = x; }), says: ratio },
    size: { ...power(1e-3, 1e3, () => outline.length(now.load.force) / now.unit, (x) => state.sizeLoad(x * now.unit)), says: () => numbers.text(outline.length(now.load.force), "N") },
    angle: { min: -180, max: 180, step: 1, read: () => (state.angleOfLoad() * 180) / Math.PI, write: (x) => state.turnLoad((x * Math.PI) / 180), says: () => numbers.text(state.angleOfLoad(), "rad") },
    moment: { min: -2, max: 2, step: 0.01, read: () => now.load.moment / now.arm, write: (x) => { now.load.moment = x * now.arm; }, says: () => numbers.text(now.load.moment, "Nm") },
  };

  const input = (name) => document.querySelector(`input[name="${name}"]`);

  // Units of the sliders of load and moment, from the initial load of the scene.
  const units = () => {
    now.unit = outline.length(now.load.force);
    now.arm = Math.max(now.unit * now.line.size * 0.5, Math.abs(now.load.moment));
  };

  const update = () => {
    for (const [name, { read, says }] of Object.entries(SLIDERS)) {
      input(name).value = read();
      input(name).setAttribute("aria-valuetext", says());
      document.getElementById(`${name}-says`).textContent = says();
    }
  };

  const connect = (changed) => {
    for (const [name, { min, max, step, write }] of Object.entries(SLIDERS)) {
      Object.assign(input(name), { min, max, step });
      input(name).addEventListener("input", () => {
        write(Number(input(name).value));
        changed();
      });
    }
  };

  return { units, update, connect };
})();
