// The state of the page: places and data of the fingers, and the load. It is converted to the scene for the crate.
const state = (() => {
  // Multiple of the load up to which a path is followed to find its end.
  const FAR = 1000;
  const SPRINGS = ["body_stiffness", "finger_stiffness", "series_stiffness"];
  // Largest number of contact points that the module accepts.
  const MOST_FINGERS = 12;

  const now = {};

  const start = ({ id, title, teaching, scene }) => {
    const { contacts, bodies, loaded, outline: corners, questions } = scene.planar;
    // A single object is one part without a name.
    const parts = bodies
      ? bodies.map((given) => ({ given, line: outline.of(given.outline) }))
      : [{ given: null, line: outline.of(corners) }];
    const line = bodies ? outline.around(parts.map((part) => part.line)) : parts[0].line;
    const part = (on) => parts.find(({ given }) => given && given.name === on) || parts[0];
    const { load } = questions.find((question) => question.solve).solve;
    Object.assign(now, {
      id, title, teaching, line, parts, loaded,
      // The numbers of the file are kept to the bit until they are changed.
      fingers: contacts.map((given, k) => {
        const { point, normal, friction, command, pressed_with: pressed, name = `finger ${k + 1}`, ...rest } = given;
        const own = part(given.on).line;
        // A contact between two parts cannot be dragged.
        return { name, rest, command, pressed, point, normal, line: own, fixed: Boolean(given.against), s: own.nearest(point) };
      }),
      friction: contacts[0].friction, squeeze: 1, ratio: 1,
      load: { force: load.force, moment: load.moment || 0, at: load.at || [0, 0] },
    });
  };

  const springs = (rest) => {
    const scaled = { ...rest };
    for (const field of SPRINGS) {
      if (Array.isArray(rest[field])) scaled[field] = [rest[field][0], rest[field][1] * now.ratio];
    }
    return scaled;
  };

  const contact = ({ name, rest, command, pressed, point, normal }) => ({
    name, point, normal, ...springs(rest), friction: now.friction,
    ...(command && { command: command.map((a) => a * now.squeeze) }),
    ...(pressed && { pressed_with: pressed * now.squeeze }),
  });

  const scene = () => {
    const { force, moment, at } = now.load;
    const load = { force, moment, at };
    const far = { force: force.map((f) => f * FAR), moment: moment * FAR, at };
    const questions = [{ onset: { direction: load } }, { solve: { load } }, { follow: { legs: [{ load_by: far }] } }];
    const bodies = now.parts.map(({ given }) => given);
    const held = bodies[0] ? { bodies, ...(now.loaded && { loaded: now.loaded }) } : { outline: now.line.corners };
    return { format: "grasp-lcp/1", planar: { contacts: now.fingers.map(contact), ...held, questions } };
  };

  const place = (finger, s) => Object.assign(finger, finger.line.at(s));

  // Fingers that can be dragged; they come first in the list.
  const dragged = () => now.fingers.filter(({ fixed }) => !fixed);

  // Adds a finger with the data of the last one, in the middle of the longest free part of the outline.
  const addFinger = () => {
    if (now.fingers.length === MOST_FINGERS) return;
    const last = dragged().length, like = now.fingers[last - 1], { line } = like;
    const places = now.fingers.filter((finger) => finger.line === line).map(({ s }) => line.at(s).s).sort((a, b) => a - b);
    const gaps = places.map((s, k) => [(places[k + 1] ?? places[0] + line.total) - s, s]);
    const [gap, s] = gaps.reduce((best, next) => (next[0] > best[0] ? next : best));
    now.fingers.splice(last, 0, place({ ...like, name: `finger ${last + 1}` }, s + gap / 2));
  };
  const removeFinger = () => {
    const last = dragged().length;
    if (last > 1) now.fingers.splice(last - 1, 1);
  };

  const turnLoad = (angle) => {
    const size = outline.length(now.load.force);
    now.load.force = [size * Math.cos(angle), size * Math.sin(angle)];
  };
  const sizeLoad = (size) => {
    const before = outline.length(now.load.force);
    now.load.force = now.load.force.map((f) => (f * size) / before);
  };
  const angleOfLoad = () => Math.atan2(now.load.force[1], now.load.force[0]);

  return { now, FAR, start, scene, place, dragged, addFinger, removeFinger, turnLoad, sizeLoad, angleOfLoad };
})();
