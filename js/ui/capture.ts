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
  // An element that was removed gets no more events.
  for (const type of ["pointerup", "pointercancel"]) listen(target.ownerDocument, type, finish);
  return () => {
    listening.abort();
    if (target.hasPointerCapture(id)) target.releasePointerCapture(id);
  };
}
