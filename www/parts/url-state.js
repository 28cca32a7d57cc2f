// A figure that the reader has changed is in the page's address, to be kept or sent: #id?points=…&t=…, with what differs
// from the page. Written when a change is done, read with suspicion. The elements know nothing of it.
import { loadElement } from "casteljau/elements";
import { apply, LONGEST_ADDRESS, propertyOf, read, SHARED, write } from "./address.js";

/** Applications keep a state of their own there. */
const OTHERS = "#state=";
const ELEMENTS = Object.keys(SHARED).join(",");

/** What each element was on the page, before the address or the reader. @type {WeakMap<Element, Map<string, string>>} */
const originals = new WeakMap();

/** A property's value as its attribute would have it; "" for none. @param {unknown} value */
const text = (value) => (Array.isArray(value) ? value.map(String).join(" ") : String(value ?? ""));
/** @param {any} element */
const settings = (element) =>
  new Map(Object.keys(SHARED[element.localName]).map((name) => [name, text(element[propertyOf(name)])]));

/** An element and the id by which the address names it: its own, or its figure's. @param {Element} element */
const idOf = (element) => element.id || element.closest("[id]")?.id || "";

/** @param {string} id */
function elementOf(id) {
  const named = document.getElementById(id);
  return named?.matches(ELEMENTS) ? named : (named?.querySelector(ELEMENTS) ?? null);
}

/** Says it above the text; an empty text takes it away. @param {string} words @param {Element | null} [near] */
function showMessage(words, near) {
  const line =
    document.querySelector(".address-message") ??
    Object.assign(document.createElement("p"), { className: "address-message" });
  line.setAttribute("role", "status");
  if (!words) return line.remove();
  const place = near?.closest("figure") ?? near;
  if (place) place.before(line);
  else document.querySelector("h1")?.after(line);
  line.textContent = words;
}

/** @param {string} text */
function decoded(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

/** Brings a figure into the state that the address asks for, as far as it can be used. */
function load() {
  kept?.abort();
  const { hash } = location;
  if (hash.length < 2 || hash.startsWith(OTHERS)) return showMessage("");
  if (hash.length > LONGEST_ADDRESS)
    return showMessage(
      `The part of the address after # is ${hash.length} characters long; at most ${LONGEST_ADDRESS} are read. The page is as it was.`,
    );
  const [name, query] = hash.slice(1).split(/\?(.*)/s);
  const id = decoded(name);
  if (!document.getElementById(id)) return showMessage("The address asks for a place that is not on this page.");
  if (query === undefined) {
    if (!moved) keepInPlace(/** @type {HTMLElement} */ (document.getElementById(id)));
    return showMessage("");
  }
  const element = elementOf(id);
  if (!element) return showMessage("The address sets values where there is no figure to take them.");
  const { values, problems } = read(query, SHARED[element.localName]);
  apply(element, values);
  element.scrollIntoView({ block: "center" });
  showMessage(problems.length ? `Not everything in the address could be used. ${problems.join("; ")}.` : "", element);
}

/** @param {Event} event */
function save({ target }) {
  if (!(target instanceof Element) || !target.matches(ELEMENTS) || !idOf(target)) return;
  const before = originals.get(target);
  const query = write(new Map([...settings(target)].filter(([name, value]) => value !== before?.get(name))));
  try {
    history.replaceState(history.state, "", `#${idOf(target)}${query && `?${query}`}`);
  } catch {
    // Browsers allow only so many a minute; the next change will do.
  }
}

/** Whether the reader has moved the page since it was opened. */
let moved = false;
for (const type of ["wheel", "touchmove", "keydown", "pointerdown"])
  addEventListener(type, () => (moved = true), { once: true, passive: true });

/** What `keepInPlace` listens to, until another place is kept. @type {AbortController | undefined} */
let kept;

/** Scrolls to an element, and again whenever a figure above it changes its height, until the reader scrolls. @param {HTMLElement} element */
function keepInPlace(element) {
  kept?.abort();
  kept = new AbortController();
  const { signal } = kept;
  const page = document.documentElement;
  const box = element.offsetParent || element.localName !== "figure" ? element : element.firstElementChild; // scenes.css
  let height = 0;
  let top = 0;
  const observer = new ResizeObserver(() => {
    if (moved) return kept?.abort();
    box?.scrollIntoView();
    [height, top] = [page.scrollHeight, scrollY];
  });
  observer.observe(document.body);
  signal.addEventListener("abort", () => observer.disconnect());
  const scrolled = () => {
    // A scroll bar sends no other event. Browsers scroll by themselves only when the height changes.
    if (page.scrollHeight === height && Math.abs(scrollY - top) > 1) moved = true;
    if (moved) kept?.abort();
  };
  addEventListener("scroll", scrolled, { signal, passive: true });
}

async function start() {
  const elements = [...document.querySelectorAll(ELEMENTS)];
  await Promise.all(
    [...new Set(elements.map((element) => element.localName))].map((name) => loadElement(/** @type {any} */ (name))),
  );
  await Promise.all(elements.map((element) => /** @type {any} */ (element).updateComplete));
  for (const element of elements) originals.set(element, settings(element));
  load();
  document.addEventListener("change", save);
  addEventListener("hashchange", load);
  document.documentElement.dataset.address = "read"; // for whoever waits
}

void start();
