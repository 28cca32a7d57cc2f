// Following a pointer from its press to its release.

export interface CaptureListener {
  move: (event: PointerEvent) => void;
  /** `released` is false if the browser has taken the pointer away */
  end?: (event: PointerEvent, released: boolean) => void;
}

/**
 * Captures a pointer that has been pressed and reports its moves, until it is released or taken away.
 *
 * @param target the element that keeps the pointer; that of the listener by default
 * @returns ends it without a report
 */
export function capture(
  start: PointerEvent,
  { move, end }: CaptureListener,
  target = start.currentTarget as Element,
): () => void {
  const id = start.pointerId;
  const listening = new AbortController();
  const listen = (on: EventTarget, type: string, listener: (event: PointerEvent) => void) =>
    on.addEventListener(
      type,
      (event) => {
        if ((event as PointerEvent).pointerId === id) listener(event as PointerEvent);
      },
      { signal: listening.signal },
    );
  const finish = (event: PointerEvent) => {
    listening.abort();
    end?.(event, event.type === "pointerup");
  };
  target.setPointerCapture(id);
  listen(target, "pointermove", move);
  for (const type of ["pointerup", "pointercancel", "lostpointercapture"]) listen(target, type, finish);
  // An element that was removed gets no more events; its drag goes on until the pointer is released.
  for (const type of ["pointerup", "pointercancel"]) listen(target.ownerDocument, type, finish);
  return () => {
    listening.abort();
    if (target.hasPointerCapture(id)) target.releasePointerCapture(id);
  };
}

export type Point2 = [number, number];

export interface HandleListener {
  /** Where the handle is */
  from: readonly [number, number];
  /** A pointer's place in the same coordinates */
  placeOf: (event: PointerEvent) => readonly [number, number];
  /** A move of the pointer, and where the handle is then */
  move: (to: Point2, event: PointerEvent) => void;
  end?: CaptureListener["end"];
}

/**
 * Captures a pointer that has been pressed on a handle, which keeps its place under the pointer.
 *
 * @param target as of `capture`
 * @returns ends it without a report
 */
export function dragHandle(
  start: PointerEvent,
  { from, placeOf, move, end }: HandleListener,
  target?: Element,
): () => void {
  const [x, y] = placeOf(start);
  let hasMoved = false;
  return capture(
    start,
    {
      move: (event) => {
        hasMoved ||= event.clientX !== start.clientX || event.clientY !== start.clientY; // not only the pressure of a pen
        const [toX, toY] = placeOf(event);
        if (hasMoved) move([from[0] + toX - x, from[1] + toY - y], event);
      },
      end,
    },
    target,
  );
}
