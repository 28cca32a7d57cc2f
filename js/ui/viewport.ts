// Looking closer: Ctrl and the wheel, two fingers; and moving about by a finger or the mouse on an empty place.
import { capture } from "./capture.js";

type Point2 = [number, number];

export interface GesturePort {
  /** Where an event is, in the plane */
  place: (event: MouseEvent) => Point2;
  /** Whether there is anywhere to move to */
  enlarged: () => boolean;
  /** Enlarge, and bring what was at one place to another */
  look: (factor: number, from: Point2, to: Point2) => void;
}

/** Enlargement of one notch of a wheel, which is 100 pixels on most. */
const WHEEL = 1.002;
/** A line and a page of the wheel, in pixels. */
const UNITS = [1, 16, 400];

/**
 * @param overlay only what begins on itself counts, not what begins on its children
 */
export function listenToGestures(overlay: HTMLElement, port: GesturePort) {
  const pointers: Map<number, MouseEvent> = new Map();
  overlay.addEventListener("wheel", (event) => turned(event, port), { passive: false });
  overlay.addEventListener("pointerdown", (event) => {
    if (event.target !== overlay || event.button !== 0) return;
    pointers.set(event.pointerId, event);
    capture(event, { move, end: () => pointers.delete(event.pointerId) });
  });
  const move = (event: PointerEvent) => {
    const before = span([...pointers.values()]);
    pointers.set(event.pointerId, event);
    const after = span([...pointers.values()]);
    if (pointers.size === 1 && !port.enlarged()) return;
    port.look(
      before.width > 0 && after.width > 0 ? after.width / before.width : 1,
      port.place(before.centre),
      port.place(after.centre),
    );
  };
}

function turned(event: WheelEvent, port: GesturePort) {
  if (!event.ctrlKey) return;
  event.preventDefault(); // else the page is enlarged
  const place = port.place(event);
  port.look(WHEEL ** (-event.deltaY * UNITS[event.deltaMode]), place, place);
}

/**
 * @param pointers one or two
 */
function span([a, b = a]: MouseEvent[]): { centre: MouseEvent; width: number } {
  const centre = { clientX: (a.clientX + b.clientX) / 2, clientY: (a.clientY + b.clientY) / 2 };
  return {
    centre: centre as MouseEvent,
    width: Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY),
  };
}
