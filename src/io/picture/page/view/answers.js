// Buttons and the slider choose one of the answers.
const step = document.getElementById("step"), choices = document.querySelectorAll("#frames button");
const choose = (k) => {
  for (const part of document.querySelectorAll("section[data-frame]")) part.hidden = Number(part.dataset.frame) !== k;
  for (const button of choices) button.setAttribute("aria-pressed", String(Number(button.dataset.frame) === k));
  if (step) step.value = k;
};
const onChoice = (show) => {
  for (const button of choices) button.addEventListener("click", () => show(Number(button.dataset.frame)));
  if (step) step.addEventListener("input", () => show(Number(step.value)));
};
const points = document.getElementById("points");
if (points) points.addEventListener("change", () => document.body.classList.toggle("points", points.checked));
