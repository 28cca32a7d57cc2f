// Controls of the page that set an attribute of a figure: <input data-for="id" data-sets="segments">. A slider with
// data-power="2" sets 2 to the power of its value, so that every step is the same ratio.

/** @param {ParentNode} root */
export function steerFrom(root) {
  for (const input of /** @type {NodeListOf<HTMLInputElement>} */ (root.querySelectorAll("input[data-for][data-sets]")))
    steer(input);
}

/** @param {HTMLInputElement} input */
function steer(input) {
  const { for: id = "", sets: name = "" } = input.dataset;
  const target = /** @type {HTMLElement & Record<string, string>} */ (document.getElementById(id));
  const show = () => {
    if (input.type === "radio") input.checked = target[name] === input.value;
    else follow(input, Number(target[name]));
  };
  for (const type of ["input", "change"]) {
    input.addEventListener(type, () => {
      if (input.type === "radio" && !input.checked) return;
      target.setAttribute(name, exactValueOf(input));
      target.dispatchEvent(new Event(type, { bubbles: true, composed: true })); // a reader did this
    });
  }
  target.addEventListener("update", show);
  show();
}

/** @param {HTMLInputElement} input @param {number} value */
function follow(input, value) {
  const power = Number(input.dataset.power);
  input.value = String(power ? Math.log(value) / Math.log(power) : value);
  const words = String(Number(value.toPrecision(3)));
  input.setAttribute("aria-valuetext", words);
  const output = input.parentElement?.querySelector("output");
  if (output) output.textContent = words;
}

/** @param {HTMLInputElement} input */
function exactValueOf({ value, dataset }) {
  const power = Number(dataset.power);
  return power ? String(Number((power ** Number(value)).toPrecision(6))) : value;
}
