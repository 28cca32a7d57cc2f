// Looking closer: Ctrl and the wheel, two fingers; and moving about by a finger or the mouse on an empty place.
import { PressedPointers } from "./pressed-pointers.js";

type Point2 = [number, number];

export interface GestureOptions {
  /** Where an event is, in the plane */
  place: (event: { clientX: number; clientY: number }) => Point2;
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
  const pointers = new PressedPointers({
    move: (before, after) => {
      if (pointers.count === 1 && !options.isEnlarged()) return;
      const factor = before.width > 0 && after.width > 0 ? after.width / before.width : 1;
      options.zoomAt(factor, options.place(before), options.place(after));
    },
  });
  overlay.addEventListener("wheel", (event) => zoomByWheel(event, options), { passive: false });
  overlay.addEventListener("pointerdown", (event) => {
    if (event.target === overlay && event.button === 0) pointers.add(event);
  });
}

function zoomByWheel(event: WheelEvent, options: GestureOptions) {
  if (!event.ctrlKey) return;
  event.preventDefault(); // else the page is enlarged
  const place = options.place(event);
  options.zoomAt(WHEEL ** (-event.deltaY * UNITS[event.deltaMode]), place, place);
}
