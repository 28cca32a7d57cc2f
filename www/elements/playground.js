// The playground: controls for the attributes of an element, the live element, and its tag as code.
import { controlOf, FIRST, tagText } from "./controls.js";

/** @typedef {import("./controls.js").Control} Control */

/** What each element begins with. @type {Record<string, Record<string, string>>} */
const INITIAL = {
  "bezier-applet": { show: "polygon construction", t: "0.4", controls: "t" },
  "bezier-surface": { model: "teapot", segments: "12" },
  "bezier-bernstein": { degree: "3", t: "0.4" },
  "bezier-equation": { points: "60,360 160,60 500,60 600,360", t: "0.4", form: "sum" },
  "bezier-coordinates": { points: "60,360 160,60 500,60 600,360" },
  "bezier-easing": { value: "ease-in-out" },
};
/** The id of the applet that a companion is linked to. */
const LINKED = "my-curve";
const COPIED_MS = 2000;

/** @param {HTMLElement} box */
export function startPlayground(box) {
  const part = (/** @type {string} */ selector) => /** @type {HTMLElement} */ (box.querySelector(selector));
  const [stage, form, code, copy] = [".stage", "form", "code", ".copy"].map(part);
  /** @type {HTMLElement} */
  let element;
  const observer = new MutationObserver(update);

  /** Shows what the attributes are now: the user changes them in the picture, too. */
  function update() {
    code.textContent = [...stage.children].map((each) => tagText(each.localName, attributesOf(each))).join("\n");
    for (const field of form.querySelectorAll("[data-attribute]")) read(/** @type {HTMLElement} */ (field), element);
  }

  /** @param {string} tag */
  function show(tag) {
    observer.disconnect();
    element = elementWith(tag, INITIAL[tag]);
    stage.replaceChildren(element);
    observe();
    const fields = rowsOf(tag).map(({ name, value, meaning }) => {
      const field = fieldOf(name, controlOf(name, value, meaning));
      field.dataset.attribute = name;
      field.title = meaning;
      return field;
    });
    const isFirst = (/** @type {HTMLElement} */ { dataset }) =>
      FIRST[tag]?.includes(dataset.attribute ?? "") ?? !["label", "theme"].includes(dataset.attribute ?? "");
    const more = document.createElement("details");
    more.append(Object.assign(document.createElement("summary"), { textContent: "More" }));
    more.append(...fields.filter((field) => !isFirst(field)));
    form.replaceChildren(...fields.filter(isFirst), more);
    update();
  }

  function observe() {
    for (const each of stage.children) observer.observe(each, { attributes: true });
  }

  form.addEventListener("submit", (event) => event.preventDefault());
  form.addEventListener("input", ({ target }) => {
    const field = /** @type {HTMLElement | null} */ (/** @type {Element} */ (target).closest("[data-attribute]"));
    if (!field) return;
    const { attribute = "", kind } = field.dataset;
    const value = attributeValue(field);
    if (value === null) element.removeAttribute(attribute);
    else element.setAttribute(attribute, value);
    if (kind !== "link") return;
    observer.disconnect();
    stage.replaceChildren(
      ...(value === null ? [] : [elementWith("bezier-applet", { id: LINKED, ...INITIAL["bezier-applet"] })]),
      element,
    );
    observe();
    update();
  });
  for (const radio of /** @type {NodeListOf<HTMLInputElement>} */ (box.querySelectorAll('[name="element"]'))) {
    radio.disabled = false;
    radio.addEventListener("change", () => show(radio.value));
  }
  copy.addEventListener("click", async () => {
    const copied = await navigator.clipboard.writeText(code.textContent ?? "").then(
      () => true,
      () => false,
    );
    copy.textContent = copied ? "Copied" : "Not allowed";
    setTimeout(() => (copy.textContent = "Copy"), COPIED_MS);
  });
  show(/** @type {HTMLInputElement} */ (box.querySelector('[name="element"]:checked')).value);
}

/**
 * The attributes of an element that its table lists, in the order of the table, behind its id. Some elements write all their
 * properties into attributes: those that have their default are left out.
 *
 * @param {Element} element
 */
function attributesOf(element) {
  const tag = element.localName;
  const unchanged = /** @type {any} */ (document.createElement(tag));
  return ["id", ...rowsOf(tag).map(({ name }) => name)].flatMap((name) => {
    const value = element.getAttribute(name);
    const isShown = value !== null && (name in INITIAL[tag] || value !== String(unchanged[name]));
    return isShown ? [/** @type {const} */ ([name, value])] : [];
  });
}

/** The rows of an element's table on this page. @param {string} tag */
const rowsOf = (tag) =>
  Array.from(document.querySelectorAll(`table[data-element="${tag}"] tbody tr`), (row) => {
    const [name, value, meaning] = Array.from(row.children, (cell) => cell.textContent ?? "");
    return { name, value, meaning };
  });

/** @param {string} tag @param {Record<string, string>} attributes */
function elementWith(tag, attributes) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  return element;
}

let count = 0;

/** A label with a control, or a group of checkboxes. @param {string} name @param {Control} control */
function fieldOf(name, control) {
  const field = document.createElement(control.kind === "words" ? "fieldset" : "label");
  field.dataset.kind = control.kind;
  const title = document.createElement(control.kind === "words" ? "legend" : "span");
  title.textContent = name;
  const input = (/** @type {Record<string, string | boolean>} */ properties) =>
    Object.assign(document.createElement("input"), { name: `attribute-${count++}`, ...properties });
  if (control.kind === "words") {
    const boxes = control.options.map((word) => {
      const label = document.createElement("label");
      label.append(input({ type: "checkbox", value: word }), word);
      return label;
    });
    field.append(title, ...boxes);
  } else if (control.kind === "choice") {
    const select = document.createElement("select");
    select.name = `attribute-${count++}`;
    for (const option of ["", ...control.options]) select.add(new Option(option || "default", option));
    field.append(title, select);
  } else if (control.kind === "number") {
    const { min, max, step, initial } = control;
    const range = max === 1;
    const given = {
      step: String(step),
      ...(min !== undefined && { min: String(min) }),
      ...(max !== undefined && { max: String(max) }),
    };
    const number = input({ type: range ? "range" : "number", ...given, placeholder: String(initial ?? "") });
    if (range) number.defaultValue = String(initial ?? min);
    field.append(title, number);
  } else if (control.kind === "text")
    field.append(title, input({ type: "text", spellcheck: false, autocomplete: "off" }));
  else field.append(input({ type: "checkbox" }), title);
  return field;
}

/** What a control says: the value of the attribute, or null where it is absent. @param {HTMLElement} field */
function attributeValue(field) {
  const [first, ...others] = /** @type {HTMLInputElement[]} */ ([...field.querySelectorAll("input, select")]);
  const { kind } = field.dataset;
  if (kind === "link") return first.checked ? LINKED : null;
  if (kind === "flag") return first.checked ? "" : null;
  if (kind !== "words") return first.value === "" ? null : first.value;
  const words = [first, ...others].filter(({ checked }) => checked).map(({ value }) => value);
  return words.length > 0 ? words.join(" ") : null;
}

/** Shows the value of the attribute in its control, unless the user is typing there. @param {HTMLElement} field @param {Element} element */
function read(field, element) {
  const inputs = /** @type {HTMLInputElement[]} */ ([...field.querySelectorAll("input, select")]);
  const { attribute = "", kind } = field.dataset;
  const value = element.getAttribute(attribute);
  if (kind === "words") {
    const words = value?.split(/[\s,]+/) ?? [];
    for (const box of inputs) box.checked = words.includes(box.value);
  } else if (kind === "flag" || kind === "link") inputs[0].checked = value !== null;
  else if (document.activeElement !== inputs[0]) inputs[0].value = value ?? inputs[0].defaultValue ?? "";
}
