// The keyboard: `r` and `m` from the whole page, everything else while the focus is inside.
import { actionOfKey } from "../../editor/actions.js";
import { addKeyTarget, keyTarget } from "../../ui/key-targets.js";
import { arrowStep, historyStep, isForText, isPlain } from "../../ui/keys.js";
import type { ActionName } from "../../editor/actions.js";

/** Actions whose keys count on the whole page. */
const PAGE_WIDE: readonly ActionName[] = ["randomize", "toggle"];

export interface KeyPort {
  /** Whether there are no keys but the arrows */
  off: () => boolean;
  /** The point that has the focus; −1 for none */
  pointOf: (event: Event) => number;
  nudge: (index: number, step: [number, number]) => void;
  /** The point whose weight has the focus; −1 for none */
  weightOf: (event: Event) => number;
  nudgeWeight: (index: number, steps: number) => void;
  /** The key is up again */
  settled: () => void;
  escape: () => boolean;
  remove: (index: number, bare: boolean) => void;
  /** Another mode for a joint; false where there is none */
  cycle: (index: number) => boolean;
  run: (name: ActionName) => void;
  help: () => void;
}

export function listenToKeys(host: HTMLElement, port: KeyPort) {
  host.addEventListener("keydown", (event) => {
    const elsewhere =
      event.defaultPrevented ||
      isForText(event) ||
      event.composedPath().some((each) => each instanceof HTMLDialogElement);
    if (!elsewhere && pressed(event, port)) event.preventDefault();
  });
  for (const type of ["keyup", "focusout"]) host.addEventListener(type, () => port.settled());
}

/**
 * Listens to `r` and `m` on the page, which count if the element is under the pointer or the only applet in view.
 *
 * @returns stops listening
 */
export function listenToPage(host: HTMLElement, port: KeyPort): () => void {
  const page = host.ownerDocument;
  const removeTarget = addKeyTarget(host);
  const listener = (event: KeyboardEvent) => {
    const action = actionOfKey((event.key ?? "").toLowerCase());
    if (!action || !PAGE_WIDE.includes(action) || port.off() || !isPlain(event) || isForText(event)) return;
    const target = keyTarget(event, page);
    if (target.focused || target.host !== host) return;
    event.preventDefault();
    port.run(action);
  };
  page.addEventListener("keydown", listener);
  return () => {
    removeTarget();
    page.removeEventListener("keydown", listener);
  };
}

/**
 * @returns whether it was used
 */
function pressed(event: KeyboardEvent, port: KeyPort): boolean {
  const index = port.pointOf(event);
  const arrow = arrowStep(event);
  const weight = arrow ? port.weightOf(event) : -1;
  if (arrow && weight >= 0) return used(port.nudgeWeight(weight, arrow[0] - arrow[1]));
  if (arrow && index >= 0) return used(port.nudge(index, arrow));
  if (event.key === "Escape") return port.escape();
  if (port.off() || event.isComposing) return false;
  const step = historyStep(event);
  if (step) return used(port.run(step));
  if (event.ctrlKey || event.metaKey || event.altKey || event.repeat) return false;
  if (index >= 0 && event.key === "Enter") return port.cycle(index);
  if (index >= 0 && ["Delete", "Backspace"].includes(event.key)) return used(port.remove(index, event.shiftKey));
  if (event.key === "?") return used(port.help());
  const action = actionOfKey((event.key ?? "").toLowerCase());
  return action !== undefined && used(port.run(action));
}

/** @param _ what was done */
const used = (_: unknown) => true;
