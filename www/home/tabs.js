// Tabs, as in the pattern of ARIA: the arrow keys move, and only the selected tab is a stop of the Tab key. And buttons that
// copy the code that is visible in their box.

const COPIED_MS = 2000;

for (const box of document.querySelectorAll("[data-tabs]")) {
  const tabs = /** @type {HTMLElement[]} */ ([...box.querySelectorAll('[role="tab"]')]);
  const select = (/** @type {HTMLElement} */ selected) => {
    for (const tab of tabs) {
      tab.setAttribute("aria-selected", String(tab === selected));
      tab.tabIndex = tab === selected ? 0 : -1;
      const panel = document.getElementById(tab.getAttribute("aria-controls") ?? "");
      if (panel) panel.hidden = tab !== selected;
    }
  };
  for (const [i, tab] of tabs.entries()) {
    tab.addEventListener("click", () => select(tab));
    tab.addEventListener("keydown", (event) => {
      const next = { ArrowRight: i + 1, ArrowLeft: i - 1, Home: 0, End: -1 }[event.key];
      const target = next === undefined ? undefined : tabs.at(next % tabs.length);
      if (!target) return;
      event.preventDefault();
      select(target);
      target.focus();
    });
  }
}

for (const button of document.querySelectorAll("[data-copy]")) {
  const text = button.textContent;
  button.addEventListener("click", async () => {
    const code = button.closest(".code")?.querySelector("pre:not([hidden])")?.textContent ?? "";
    const copied = await navigator.clipboard.writeText(code.trim()).then(
      () => true,
      () => false,
    );
    button.textContent = copied ? "Copied" : "Not allowed";
    setTimeout(() => (button.textContent = text), COPIED_MS);
  });
}
