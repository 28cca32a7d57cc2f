// Looking closer: Ctrl and the wheel, two fingers; and moving about by a finger or the mouse on an empty place.
import { capture } from "./capture.js";

type Point2 = [number, number];

export interface GestureOptions {
  /** Where an event is, in the plane */
  place: (event: MouseEvent) => Point2;
  /** Whether there is anywhere to move to */
  isEnlarged: () => boolean;
  /** Enlarge, and bring what was at one place to another */
  zoomAt: (factor: number, from: Point2, to: Point2) => void;
}

/** Enlargement of one notch of a wheel, which is 100 pixels on most. */
const WHEEL = 1.002;
/** A line and a page of the wheel, in pixels. */
const UNITS = [1, 16, 400];

/**
 * @param overlay only what begins on itself counts, not what begins on its children
 */
export function listenToGestures(overlay: HTMLElement, options: GestureOptions) {
  const pointers: Map<number, MouseEvent> = new Map();
  overlay.addEventListener("wheel", (event) => turned(event, options), { passive: false });
  overlay.addEventListener("pointerdown", (event) => {
    if (event.target !== overlay || event.button !== 0) return;
    pointers.set(event.pointerId, event);
    capture(event, { move, end: () => pointers.delete(event.pointerId) });
  });
  const move = (event: PointerEvent) => {
    const before = span([...pointers.values()]);
    pointers.set(event.pointerId, event);
    const after = span([...pointers.values()]);
    if (pointers.size === 1 && !options.isEnlarged()) return;
    options.zoomAt(
      before.width > 0 && after.width > 0 ? after.width / before.width : 1,
      options.place(before.centre),
      options.place(after.centre),
    );
  };
}

function turned(event: WheelEvent, options: GestureOptions) {
  if (!event.ctrlKey) return;
  event.preventDefault(); // else the page is enlarged
  const place = options.place(event);
  options.zoomAt(WHEEL ** (-event.deltaY * UNITS[event.deltaMode]), place, place);
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
