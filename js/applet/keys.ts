// The keyboard: letters on the whole page, arrows on the points.
import { historyStep, isForText, isPlain, keyOf } from "../ui/keys.js";
import { addKeyTarget, keyTarget } from "../ui/key-targets.js";

/** What the letters do. */
export interface KeyPort {
  host: HTMLElement;
  /** Whether letters count when the focus is elsewhere */
  pageWide: () => boolean;
  randomize: () => void;
  toggle: () => void;
  undo: () => void;
  redo: () => void;
  /** Ends a drag; false if there is none */
  escape: () => boolean;
}

/**
 * Listens to the page.
 *
 * @returns ends it
 */
export function listenToKeys(port: KeyPort): () => void {
  const page = port.host.ownerDocument;
  const listener = (event: KeyboardEvent) => pressed(event, port);
  const removeTarget = addKeyTarget(port.host);
  page.addEventListener("keydown", listener);
  return () => {
    removeTarget();
    page.removeEventListener("keydown", listener);
  };
}

function pressed(event: KeyboardEvent, port: KeyPort) {
  if (event.key === "Escape" && port.escape()) return event.preventDefault();
  const step = historyStep(event);
  const letter = isPlain(event) && { r: port.randomize, m: port.toggle }[keyOf(event)];
  const act = step ? port[step] : letter;
  if (!act || isForText(event)) return;
  const { host, focused } = keyTarget(event, port.host.ownerDocument);
  if (host !== port.host || !(focused || (!step && port.pageWide()))) return;
  event.preventDefault();
  act();
}
