// Filters the entries of a page of the reference by name while the reader types. Without scripts the page is the plain list.

const field = /** @type {HTMLInputElement | null} */ (document.querySelector(".filter input"));
if (field) addFilter(field);

/** @param {HTMLInputElement} field */
function addFilter(field) {
  const status = /** @type {HTMLElement} */ (document.querySelector(".filter [role=status]"));
  const entries = Array.from(
    /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll("[data-name]")),
    (element) => ({
      element,
      name: element.dataset.name?.toLowerCase() ?? "",
    }),
  );

  function update() {
    const words = field.value.toLowerCase().split(/[\s.#()]+/);
    const found = entries.filter(({ element, name }) => {
      element.hidden = !words.every((word) => name.includes(word));
      return !element.hidden;
    });
    for (const section of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll("section:has(.entries)")))
      section.hidden = !section.querySelector("[data-name]:not([hidden])");
    for (const link of linksToSections()) {
      const target = document.getElementById(link.hash.slice(1));
      const item = link.closest("li");
      if (item) item.hidden = Boolean(target?.closest("[hidden]"));
    }
    status.textContent = `${found.length || "No"} ${found.length === 1 ? "entry" : "entries"}`;
  }

  field.disabled = false;
  field.addEventListener("input", update);
  // An address with the name of a hidden entry shows all of them.
  addEventListener("hashchange", () => {
    const target = document.getElementById(location.hash.slice(1));
    if (!target?.closest("[hidden]")) return;
    field.value = "";
    update();
    target.scrollIntoView();
  });
  document.addEventListener("keydown", (event) => moveFocus(field, event));
  if (field.value) update(); // a browser may have restored it
}

const linksToSections = () =>
  /** @type {NodeListOf<HTMLAnchorElement>} */ (document.querySelectorAll(".contents a, nav.names a"));

/** Arrow keys go from the field through the links of the entries; Enter in the field opens the first. @param {HTMLInputElement} field @param {KeyboardEvent} event */
function moveFocus(field, event) {
  const links = /** @type {HTMLElement[]} */ ([
    ...document.querySelectorAll(".entries a, nav.names a, .contents:has(+ main > nav.names) a"),
  ]);
  const stops = [field, ...links.filter((link) => link.checkVisibility())];
  const at = stops.indexOf(/** @type {HTMLElement} */ (document.activeElement));
  if (event.key === "Enter" && at === 0) stops[1]?.click();
  const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
  if (!step || at < 0) return;
  event.preventDefault();
  stops[Math.min(Math.max(at + step, 0), stops.length - 1)].focus();
}
