// The bar above every page: its menus, and the search.
import "./search.js";

const PHONE = matchMedia("(max-width: 44rem)");
const navigation = /** @type {HTMLElement} */ (document.getElementById("site-nav"));
const menuButton = /** @type {HTMLButtonElement} */ (document.querySelector(".menu-button"));

/** The button and the list of each group. */
const groups = Array.from(navigation.querySelectorAll(".group"), (element) => ({
  element,
  button: /** @type {HTMLButtonElement} */ (element.querySelector("button")),
  list: /** @type {HTMLElement} */ (element.querySelector("ul")),
}));

/** Opens one group and closes the others. @param {(typeof groups)[number] | undefined} open */
function show(open) {
  for (const group of groups) {
    group.button.setAttribute("aria-expanded", String(group === open));
    group.list.hidden = group !== open;
  }
}

const isOpen = (/** @type {(typeof groups)[number]} */ { list }) => !list.hidden;

for (const group of groups) {
  group.button.addEventListener("click", () => show(isOpen(group) ? undefined : group));
  group.element.addEventListener("focusout", (event) => {
    const { relatedTarget } = /** @type {FocusEvent} */ (event);
    if (relatedTarget && !group.element.contains(/** @type {Node} */ (relatedTarget))) show(undefined);
  });
}
document.addEventListener("pointerdown", ({ target }) => {
  if (!navigation.contains(/** @type {Node} */ (target))) show(undefined);
});
document.addEventListener("keydown", ({ key }) => {
  if (key !== "Escape") return;
  const open = groups.find(isOpen);
  if (open) {
    show(undefined);
    open.button.focus();
  } else if (navigation.classList.contains("open")) {
    menuButton.click();
    menuButton.focus();
  }
});

menuButton.addEventListener("click", () => {
  const open = navigation.classList.toggle("open");
  menuButton.setAttribute("aria-expanded", String(open));
  menuButton.textContent = open ? "Close" : "Menu";
});

/** In the menu of a phone, the buttons of the groups are only headings: all lists are shown. */
function setStops() {
  for (const { button } of groups) button.tabIndex = PHONE.matches ? -1 : 0;
}
PHONE.addEventListener("change", setStops);
setStops();
