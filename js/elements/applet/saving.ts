// The part of the panel that saves the figure, opens one, and shows code.
import { html } from "lit";
import { button, select } from "../../ui/controls.js";
import { translated } from "../../editor/translations.js";
import type { AppletController } from "./controller.js";
import type { Language } from "../../editor/code.js";

export function exportPanel(controller: AppletController) {
  const { host, language } = controller;
  const { readonly } = host;
  const isOpen = host.renderRoot.querySelector<HTMLDetailsElement>("details.save")?.open;
  const code = isOpen ? controller.toCode(language) : "";
  const opened = (event: Event) => (event.target as HTMLDetailsElement).open && host.requestUpdate();
  const onChange = (event: Event) => {
    const input = event.target as HTMLInputElement;
    if (input.files?.[0]) controller.openFile(input.files[0]);
    input.value = ""; // the same file can be chosen again
  };
  return html`<details class="save" @toggle=${opened}><summary>${translated("Save, open, code")}</summary><div class="body">
    <div class="row" role="group" aria-label=${translated("Save as")}>${button("SVG", () => controller.saveSVG())} ${button("PNG", () => void controller.savePNG())} ${button("JSON", () => controller.saveJSON())}
      ${readonly ? "" : html`<label class="file">${translated("Open a file")}<input type="file" accept=".svg,.json,.txt,image/svg+xml,application/json,text/plain" @change=${onChange}></label>`}</div>
    ${readonly ? "" : html`<p class="note">${translated("Points, an SVG path or saved JSON can also be dropped or pasted here.")}</p>`}
    <div class="row">${select(translated("Code"), ["js", "rust", "canvas"], language, { js: "JavaScript", rust: "Rust", canvas: translated("canvas calls") }, (word) => controller.chooseLanguage(word as Language))} ${button(translated("Copy"), () => void controller.copyCode())}</div>
    <pre tabindex="0" role="region" aria-label=${translated("Code")}>${code}</pre>
  </div></details>`;
}
