// Formats numbers with four digits and a unit. Every element also stores the full number.
const numbers = (() => {
  const DIGITS = 4;

  const plain = (x) => {
    // The crate writes numbers that are not finite as words.
    if (typeof x === "string") return x;
    if (x === 0) return "0";
    const size = Math.abs(x);
    const text = size >= 1e5 || size < 1e-4 ? x.toExponential(DIGITS - 1) : String(Number(x.toPrecision(DIGITS)));
    return text.replace("-", "\u2212");
  };

  // Lengths of small objects read better in mm.
  const UNITS = { N: ["N", 1], Nm: ["N m", 1], m: ["m", 1], mm: ["mm", 1e3], rad: ["°", 180 / Math.PI], times: ["", 1] };
  const text = (x, unit) => {
    const [name, factor] = UNITS[unit];
    const number = plain(typeof x === "number" ? x * factor : x);
    return name === "" ? number : name === "°" ? number + name : `${number}\u00a0${name}`;
  };

  // `what` is the name under which the number is stored.
  const element = (what, x, unit) => {
    const shown = document.createElement("span");
    shown.className = "number";
    [shown.dataset.what, shown.dataset.value] = [what, String(x)];
    shown.textContent = text(x, unit);
    return shown;
  };

  // The next 1, 2 or 5 times a power of ten that is at least x, or at most x.
  const STEPS = [1, 2, 5, 10];
  const roundUp = (x) => {
    const power = 10 ** Math.floor(Math.log10(x));
    return power * STEPS.find((step) => step * power >= x * (1 - 1e-9));
  };
  const roundDown = (x) => {
    const power = 10 ** Math.floor(Math.log10(x));
    return power * STEPS.findLast((step) => step * power <= x * (1 + 1e-9));
  };

  return { text, element, roundUp, roundDown };
})();
