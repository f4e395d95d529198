// After each change of the state: one answer, one drawing.
(async () => {
  const root = document.getElementById("picture"), drawn = document.getElementById("drawing");
  const files = JSON.parse(document.getElementById("scenes").textContent);

  const update = () => {
    const scene = state.scene(), found = answers.of(asking.ask(scene));
    // The picture is in pixels, so that its letters have the size of the page.
    const width = root.clientWidth, height = Math.round(Math.min(560, Math.max(380, 0.8 * width)));
    root.setAttribute("viewBox", `0 0 ${width} ${height}`);
    root.setAttribute("height", height);
    const place = view.of(width, height, state.now);
    const { scale, factor, toScale } = picture.draw(drawn, place, found);
    handles.update(place, found, scale);
    loadline.draw(document.getElementById("loadline"), width, found);
    told.tell(found, factor, toScale);
    controls.update();
    document.getElementById("scene").textContent = JSON.stringify(scene);
    document.getElementById("time").textContent = `${asking.time().toFixed(2)} ms an answer`;
  };
  const rebuild = () => {
    handles.build(document.getElementById("handles"), update);
    update();
  };

  const choose = (id) => {
    const chosen = scenes.find((scene) => scene.id === id) || scenes[0];
    state.start({ ...chosen, scene: files[chosen.id] });
    controls.units();
    document.getElementById("teaching").textContent = state.now.teaching;
    for (const button of document.querySelectorAll("#choices button")) {
      button.setAttribute("aria-pressed", String(button.dataset.scene === state.now.id));
    }
    rebuild();
  };
  const offer = ({ id, title }) => {
    const button = document.createElement("button");
    [button.type, button.textContent, button.dataset.scene] = ["button", title, id];
    button.addEventListener("click", () => choose(id));
    return button;
  };

  try {
    await asking.begin();
  } catch (error) {
    document.getElementById("verdict").textContent = `This browser does not run the module: ${error.message}`;
    return;
  }
  document.getElementById("choices").append(...scenes.map(offer));
  controls.connect(update);
  for (const [id, change] of [["add", state.addFinger], ["remove", state.removeFinger]]) {
    document.getElementById(id).addEventListener("click", () => {
      change();
      rebuild();
    });
  }
  window.addEventListener("resize", update);
  window.addEventListener("hashchange", () => choose(location.hash.slice(1)));
  choose(location.hash.slice(1));
  document.body.dataset.ready = "true";
})();
