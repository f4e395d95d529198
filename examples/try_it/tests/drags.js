// The test appends this script to the page. It drags grips, turns the load and moves sliders like a user, and records the contents of the page.
(async () => {
  const records = [];
  const at = (id) => document.getElementById(id);
  const ready = () => new Promise((resolve) => {
    const look = () => (document.body.dataset.ready ? resolve() : setTimeout(look, 10));
    look();
  });
  const record = (what) => {
    const shown = {};
    for (const number of document.querySelectorAll(".number")) shown[number.dataset.what] = { value: number.dataset.value, text: number.textContent };
    records.push({
      what, scene: at("scene").textContent, shown,
      states: [...document.querySelectorAll("#rows td:nth-child(2)")].map((cell) => cell.textContent),
      arrows: document.querySelectorAll("#drawing .force").length,
      verdict: at("verdict").textContent, why: at("why").textContent, onset: at("onset").textContent, limit: at("limit").textContent,
    });
  };

  // Events go to the element that the browser finds at the pointer, as for a real pointer.
  const middle = (grip) => {
    const { left, top, width, height } = grip.querySelector("circle:not(.room)").getBoundingClientRect();
    return [left + width / 2, top + height / 2];
  };
  const send = (target, type, [x, y]) =>
    target.dispatchEvent(new PointerEvent(type, { clientX: x, clientY: y, pointerId: 1, bubbles: true, cancelable: true }));
  const drag = (selector, k, [dx, dy]) => {
    const [x, y] = middle(document.querySelectorAll(`#handles ${selector}`)[k]);
    send(document.elementFromPoint(x, y), "pointerdown", [x, y]);
    for (const part of [0.25, 0.5, 0.75, 1]) send(window, "pointermove", [x + part * dx, y + part * dy]);
    send(window, "pointerup", [x + dx, y + dy]);
  };
  const key = (selector, name) =>
    document.querySelector(`#handles ${selector}`).dispatchEvent(new KeyboardEvent("keydown", { key: name, bubbles: true, cancelable: true }));
  const slide = (name, value) => {
    const input = document.querySelector(`input[name="${name}"]`);
    input.value = value;
    input.dispatchEvent(new Event("input", { bubbles: true }));
  };
  const choose = (id) => document.querySelector(`button[data-scene="${id}"]`).click();

  await ready();
  for (const button of document.querySelectorAll("#choices button")) {
    button.click();
    record(button.dataset.scene);
  }

  choose("box");
  drag(".finger", 0, [0, -20]);
  record("a finger dragged");
  key(".finger", "ArrowLeft");
  record("a finger moved by a key");
  drag(".turns-load", 0, [60, -90]);
  record("the load turned");
  drag(".moves-load", 0, [10, 15]);
  record("the load moved");
  slide("squeeze", 1.5);
  slide("ratio", 40);
  slide("moment", 0.1);
  record("sliders");
  at("add").click();
  record("a finger more");

  choose("box");
  slide("friction", 0);
  record("no friction");
  choose("wedge");
  slide("friction", 0.5);
  record("the wedge with friction");
  choose("two_parts");
  drag(".finger", 0, [0, 20]);
  slide("size", 10);
  record("a part of two held lower");
  choose("pentagon");
  slide("size", 60);
  record("the pentagon with a large load");
  choose("paper_disk");
  slide("size", 100 * Math.log10(9));
  slide("moment", 2);
  record("a disk that slides");

  // Size of the arrow of the smallest load that can be set, line and head, pixels.
  choose("box");
  slide("size", -300);
  const load = document.querySelector("#drawing .load").getBoundingClientRect(), smallest = Math.hypot(load.width, load.height);
  // Two fingers at the same place: their labels must not overlap.
  for (const finger of state.now.fingers) state.place(finger, 0.1);
  slide("size", 0);
  const boxes = [...document.querySelectorAll("#handles .says")].filter((says) => says.textContent).map((says) => says.getBoundingClientRect());
  const overlap = boxes.some((a, k) => boxes.slice(0, k).some((b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom));

  choose("pentagon");
  const scene = JSON.parse(at("scene").textContent), rounds = 500;
  const before = performance.now();
  for (let k = 0; k < rounds; k += 1) asking.ask(scene);
  const time = (performance.now() - before) / rounds;
  const turned = performance.now();
  for (let k = 0; k < 100; k += 1) key(".turns-load", "ArrowLeft");
  const drawn = (performance.now() - turned) / 100;

  const told = document.createElement("script");
  [told.type, told.id] = ["application/json", "records"];
  told.textContent = JSON.stringify({ records, time, drawn, smallest, overlap, wide: document.documentElement.scrollWidth }).replaceAll("<", "\\u003c");
  document.body.append(told);
})();
