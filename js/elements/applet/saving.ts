// The folded part of the panel from which the figure is taken along, and into which one is brought.
import { html } from "lit";
import { button, choice } from "../../ui/controls.js";
import { translated } from "../../editor/translations.js";

export function savings({ act, code, language, readonly }: import("./panel.js").PanelPort) {
  const opened = (event: Event) => (event.target as HTMLDetailsElement).open && act.refresh();
  const onChange = (event: Event) => {
    const input = event.target as HTMLInputElement;
    if (input.files?.[0]) act.open(input.files[0]);
    input.value = ""; // the same file can be chosen again
  };
  return html`<details class="save" @toggle=${opened}><summary>${translated("Save, open, code")}</summary><div class="body">
    <div class="row" role="group" aria-label=${translated("Save as")}>${button("SVG", act.saveSvg)} ${button("PNG", act.savePng)} ${button("JSON", act.saveJson)}
      ${readonly ? "" : html`<label class="file">${translated("Open a file")}<input type="file" accept=".svg,.json,.txt,image/svg+xml,application/json,text/plain" @change=${onChange}></label>`}</div>
    ${readonly ? "" : html`<p class="note">${translated("Points, an SVG path or saved JSON can also be dropped or pasted here.")}</p>`}
    <div class="row">${choice(translated("Code"), ["js", "rust", "canvas"], language, { js: "JavaScript", rust: "Rust", canvas: translated("canvas calls") }, act.language)} ${button(translated("Copy"), act.copy)}</div>
    <pre tabindex="0" role="region" aria-label=${translated("Code")}>${code}</pre>
  </div></details>`;
}
