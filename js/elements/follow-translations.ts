import { translations } from "../editor/translations.js";
import type { ReactiveControllerHost } from "lit";

/**
 * Draws an element on the page again when `setTranslations` is called.
 *
 * @param update draws it; by default Lit renders it
 */
export function followTranslations(host: ReactiveControllerHost, update = () => host.requestUpdate()) {
  host.addController({
    hostConnected: () => translations.addEventListener("change", update),
    hostDisconnected: () => translations.removeEventListener("change", update),
  });
}
