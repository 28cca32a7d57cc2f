// <surface-controls for="id" controls="segments shading">: the few controls of a figure that its text speaks of.
import { element, uniqueId } from "../parts/dom.js";
import { LinkedFigure } from "./lib/linked-figure.js";
import { jointAngle } from "./lib/surfaces.js";

const decimals = (/** @type {number} */ x) => x.toFixed(2);
const figures = (/** @type {number} */ x) => (x < 1e-4 ? x.toExponential(1) : String(Number(x.toPrecision(2))));

/** Sliders. The positions of those with `log` are decimal logarithms. */
const SLIDERS = {
  segments: { label: "Segments", min: 1, max: 32, step: 1, shown: String },
  lines: { label: "Strips", min: 1, max: 12, step: 1, shown: String },
  u: { label: "u", min: 0, max: 1, step: 0.01, shown: decimals },
  v: { label: "v", min: 0, max: 1, step: 0.01, shown: decimals },
  tolerance: { label: "Tolerance", min: -3, max: 0, step: 0.05, shown: figures, log: true },
  pixels: { label: "Pixels", min: -1, max: 1.5, step: 0.05, shown: figures, log: true },
  flatness: { label: "Flatness limit", min: -3, max: 0.3, step: 0.05, shown: figures, log: true },
};

/** Each of these takes the place of the segments. */
const LENGTHS = ["tolerance", "pixels", "flatness"];

/** Choices: each button sets some properties. */
const CHOICES = {
  shading: {
    label: "Shading",
    options: { Smooth: { shading: "smooth" }, Flat: { shading: "flat" }, Normals: { shading: "normals" } },
  },
  evaluation: {
    label: "Evaluated by",
    options: {
      "the processor": { evaluation: "cpu" },
      "forward differences": { evaluation: "forward" },
      "the graphics card": { evaluation: "gpu" },
    },
  },
  fineness: {
    label: "Subdivision",
    options: {
      uniformly: { segments: 8, tolerance: null, pixels: null, flatness: null },
      "by tolerance": { tolerance: 0.03, pixels: null, flatness: null },
      "by pixels": { tolerance: null, pixels: 1, flatness: null },
      "until flat": { tolerance: null, pixels: null, flatness: 0.03 },
    },
  },
  recipe: {
    label: "Subdivision",
    options: {
      "until flat": { tolerance: null, flatness: 0.05 },
      "by tolerance": { tolerance: 0.05, flatness: null },
    },
  },
  model: {
    label: "Model",
    options: { Teapot: { model: "teapot" }, Teacup: { model: "teacup" }, Teaspoon: { model: "teaspoon" } },
  },
  up: { label: "Vertical axis", options: { z: { up: "z" }, y: { up: "y" } } },
  height: { label: "Height", options: { usual: { height: "squashed" }, "Newell’s": { height: "original" } } },
  body: {
    label: "Draw",
    options: {
      tubes: { show: "tubes" },
      ribbons: { show: "ribbons" },
      lines: { show: "surface isocurves" },
      "ribbons on the pot": { show: "surface ribbons" },
    },
  },
};

/** The parts of the teapot by the number of their first patch. @type {[number, string][]} */
const TEAPOT_PARTS = [
  [28, "bottom"],
  [20, "lid"],
  [16, "spout"],
  [12, "handle"],
  [4, "body"],
  [0, "rim"],
];

/** Lines that say what a figure shows. */
const READINGS = {
  joint: (/** @type {any} */ figure) =>
    figure
      ? `The largest angle between normals along the common side is ${jointAngle(figure.surface).toFixed(1)}°.`
      : "",
  point: (/** @type {any} */ figure) =>
    figure?.place
      ? `S(${decimals(figure.u)}, ${decimals(figure.v)}) = (${figure.place.point.map((/** @type {number} */ x) => x.toFixed(3).replace("-", "−")).join(", ")})`
      : "",
  hit: (/** @type {any} */ figure) =>
    figure && figure.patch === null
      ? "The click missed the pot."
      : `Patch ${figure?.patch} (${TEAPOT_PARTS.find(([first]) => figure?.patch >= first)?.[1]}), u = ${decimals(figure?.u ?? 0)}, v = ${decimals(figure?.v ?? 0)}.`,
};

/** Check boxes for the words of a list. */
const LISTS = {
  show: {
    label: "Show",
    words: {
      surface: "surface",
      mesh: "mesh",
      isocurves: "curves",
      net: "net",
      casteljau: "de Casteljau",
      derivatives: "derivatives",
      names: "names",
    },
  },
  parts: {
    label: "Parts",
    words: { lid: "lid", rim: "rim", body: "body", handle: "handle", spout: "spout", bottom: "bottom" },
  },
};

const STEPS = [
  "Step 1 of 4: evaluate the curve of row 0 at u.",
  "Step 2 of 4: evaluate the curves of the other rows at the same u.",
  "Step 3 of 4: the four points are the control points of one more curve.",
  "Step 4 of 4: evaluate this curve at v. The result is S(u, v).",
];

class SurfaceControls extends LinkedFigure {
  /** @type {(() => void)[]} */ #followers = [];

  follow() {
    this.#followers.forEach((follow) => follow());
  }

  build() {
    const allowed = (this.getAttribute("words") ?? "").split(" ").filter(Boolean);
    for (const name of (this.getAttribute("controls") ?? "").split(" ")) {
      if (name === "step") this.append(this.#stepper());
      else if (name === "probe") this.append(...this.#probe());
      else if (name in READINGS) this.append(this.#reading(/** @type {keyof typeof READINGS} */ (name)));
      else if (name in SLIDERS) this.append(this.#slider(/** @type {keyof typeof SLIDERS} */ (name)));
      else if (name in CHOICES) this.append(this.#choice(/** @type {keyof typeof CHOICES} */ (name)));
      else this.append(this.#list(/** @type {keyof typeof LISTS} */ (name), allowed));
    }
  }

  /** @param {keyof typeof SLIDERS} name */
  #slider(name) {
    const { label, min, max, step, shown } = SLIDERS[name];
    const log = "log" in SLIDERS[name];
    const input = Object.assign(document.createElement("input"), { type: "range", min, max, step, name });
    const value = element("output", {});
    const line = element("label", { className: "line" }, element("span", {}, label), input, value);
    for (const type of /** @type {const} */ (["input", "change"])) {
      input.addEventListener(type, () =>
        this.setTarget(
          { [name]: log ? Number((10 ** input.valueAsNumber).toPrecision(2)) : input.valueAsNumber },
          type,
        ),
      );
    }
    this.#followers.push(() => {
      const now = this.target?.[name];
      line.hidden = now === null || (name === "segments" && LENGTHS.some((other) => this.target?.[other] !== null)); // another way of cutting counts
      if (typeof now !== "number") return;
      input.value = String(log ? Math.log10(now) : now);
      value.textContent = shown(now);
      input.setAttribute("aria-valuetext", shown(now));
    });
    return line;
  }

  /** @param {keyof typeof CHOICES} name */
  #choice(name) {
    const { label, options } = CHOICES[name];
    const group = element(
      "div",
      { className: "choice", role: "group", ariaLabel: label },
      element("span", { ariaHidden: "true" }, label),
    );
    for (const [title, properties] of Object.entries(options)) {
      const made = Object.assign(document.createElement("button"), { type: "button", textContent: title });
      made.addEventListener("click", () => this.setTarget(properties, "change"));
      // It is pressed when what makes it differ from its neighbours is there: words, and which lengths are in use.
      const same = (/** @type {[string, unknown]} */ [key, value]) =>
        typeof value === "number" && key !== "segments"
          ? this.target?.[key] !== null
          : key === "segments" || this.target?.[key] === value;
      this.#followers.push(() => made.setAttribute("aria-pressed", String(Object.entries(properties).every(same))));
      group.append(made);
    }
    return group;
  }

  /** @param {keyof typeof LISTS} name @param {string[]} allowed */
  #list(name, allowed) {
    const { label, words } = LISTS[name];
    const all = Object.keys(words);
    const group = element(
      "div",
      { className: "choice", role: "group", ariaLabel: label },
      element("span", { ariaHidden: "true" }, label),
    );
    const chosen = () => this.target?.[name]?.split(" ") ?? all;
    for (const word of all.filter((each) => allowed.length === 0 || allowed.includes(each))) {
      const box = Object.assign(document.createElement("input"), { type: "checkbox", name: word });
      box.addEventListener("change", () =>
        this.setTarget(
          { [name]: all.filter((each) => (each === word ? box.checked : chosen().includes(each))).join(" ") },
          "change",
        ),
      );
      this.#followers.push(() => (box.checked = chosen().includes(word)));
      group.append(element("label", {}, box, /** @type {Record<string, string>} */ (words)[word]));
    }
    return group;
  }

  /** A line that says what the figure shows. @param {keyof typeof READINGS} name */
  #reading(name) {
    const words = element("p", { className: "note" });
    words.setAttribute("role", "status");
    this.#followers.push(() => (words.textContent = READINGS[name](this.target?.figure)));
    return words;
  }

  /** Three sliders for a point in space, and what is nearest to it. */
  #probe() {
    const now = () => this.target?.figure?.probe ?? [0, 0, 0];
    const lines = ["x", "y", "z"].map((axis, k) => {
      const input = Object.assign(document.createElement("input"), {
        type: "range",
        min: -4,
        max: 4,
        step: 0.05,
        name: axis,
      });
      const value = element("output", {});
      for (const type of /** @type {const} */ (["input", "change"])) {
        input.addEventListener(type, () =>
          this.setTarget({ probe: now().with(k, input.valueAsNumber).join(" ") }, type),
        );
      }
      this.#followers.push(() => {
        input.value = String(now()[k]);
        value.textContent = now()[k].toFixed(2).replace("-", "−");
      });
      return element("label", { className: "line" }, element("span", {}, axis), input, value);
    });
    const words = element("p", { className: "note" });
    words.setAttribute("role", "status");
    this.#followers.push(() => {
      const found = this.target?.figure?.nearest;
      words.textContent = found
        ? `The distance is ${found.distance.toFixed(3)}. The nearest point is on patch ${found.patch}, at u = ${found.u.toFixed(2)}, v = ${found.v.toFixed(2)}.`
        : "";
    });
    return [...lines, words];
  }

  #stepper() {
    const words = element("p", { className: "note", id: uniqueId("step") });
    words.setAttribute("role", "status");
    const move = (/** @type {number} */ by) => () =>
      this.setTarget({ step: Math.min(Math.max(this.target?.step + by, 1), STEPS.length) }, "change");
    const [back, next] = [
      ["Step back", -1],
      ["Next step", 1],
    ].map(([title, by]) => {
      const made = Object.assign(document.createElement("button"), { type: "button", textContent: title });
      made.addEventListener("click", move(Number(by)));
      return made;
    });
    this.#followers.push(() => {
      const step = this.target?.step ?? STEPS.length;
      words.textContent = STEPS[step - 1];
      back.disabled = step === 1;
      next.disabled = step === STEPS.length;
    });
    return element("div", { className: "choice" }, back, next, words);
  }
}

customElements.define("surface-controls", SurfaceControls);
