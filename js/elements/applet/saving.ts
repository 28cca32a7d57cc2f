// The folded part of the panel from which the figure is taken along, and into which one is brought.
import { html } from "lit";
import { button, choice } from "../../ui/controls.js";

export function savings({ act, code, language, readonly }: import("./panel.js").PanelPort) {
  const opened = (event: Event) => (event.target as HTMLDetailsElement).open && act.refresh();
  const onChange = (event: Event) => {
    const input = event.target as HTMLInputElement;
    if (input.files?.[0]) act.open(input.files[0]);
    input.value = ""; // the same file can be chosen again
  };
  return html`<details class="save" @toggle=${opened}><summary>Save, open, code</summary><div class="body">
    <div class="row" role="group" aria-label="Save as">${button("SVG", act.saveSvg)} ${button("PNG", act.savePng)} ${button("JSON", act.saveJson)}
      ${readonly ? "" : html`<label class="file">Open a file<input type="file" accept=".svg,.json,.txt,image/svg+xml,application/json,text/plain" @change=${onChange}></label>`}</div>
    ${readonly ? "" : html`<p class="note">Points, an SVG path or saved JSON can also be dropped or pasted here.</p>`}
    <div class="row">${choice("Code", ["js", "rust", "canvas"], language, { js: "JavaScript", rust: "Rust", canvas: "canvas calls" }, act.language)} ${button("Copy", act.copy)}</div>
    <pre tabindex="0" role="region" aria-label="Code">${code}</pre>
  </div></details>`;
}
