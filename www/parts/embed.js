// embed.html?element=bezier-surface&model=teacup: the query's parameters become the element's attributes.
import { loadElement } from "casteljau/elements";
import { apply, LONGEST_ADDRESS, read, SHARED, shortened } from "./address.js";

/** @typedef {import("./address.js").Form} Form */

const FIRST = "bezier-applet";
/** What only a page of one's own can set, besides what can be shared. @type {Record<string, Form>} */
const ALWAYS = { controls: "words", label: "text", theme: "words" };
/** @type {Record<string, Record<string, Form>>} */
const MORE = {
  "bezier-applet": { hotkeys: "words", readonly: "words" },
  "bezier-surface": { turn: "words", swept: "words" },
};

const parameters = new URLSearchParams(location.search.length > LONGEST_ADDRESS ? "" : location.search);
const asked = parameters.get("element") ?? FIRST;
const name = /** @type {"bezier-applet" | "bezier-surface"} */ (Object.hasOwn(SHARED, asked) ? asked : FIRST);
parameters.delete("element");

const { values, problems } = read(String(parameters), { ...SHARED[name], ...MORE[name], ...ALWAYS });
if (asked !== name)
  problems.unshift(`element: expected ${Object.keys(SHARED).join(" or ")}, got “${shortened(asked)}”`);
if (location.search.length > LONGEST_ADDRESS)
  problems.unshift(`the address is longer than ${LONGEST_ADDRESS} characters and was not read`);

void loadElement(name);
const element = document.createElement(name);
apply(element, values);
const main = /** @type {HTMLElement} */ (document.querySelector("main"));
main.append(element);
if (problems.length) {
  const line = Object.assign(document.createElement("p"), {
    className: "address-message",
    textContent: `Not everything in the address could be used. ${problems.join("; ")}.`,
  });
  line.setAttribute("role", "status");
  element.before(line);
}

/** Whoever embeds the page may follow its height: { casteljau: "height", height }. */
new ResizeObserver(() => {
  if (parent !== window)
    parent.postMessage({ casteljau: "height", height: Math.ceil(main.getBoundingClientRect().height) }, "*");
}).observe(main);
