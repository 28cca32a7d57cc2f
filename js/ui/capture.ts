// Following a pointer from its press to its release.

export interface CaptureListener {
  move: (event: PointerEvent) => void;
  /** `released` is false if the pointer was taken away: by the browser, or since its element is gone */
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
  const listen = (type: string, listener: (event: PointerEvent) => void) =>
    target.addEventListener(
      type,
      (event) => {
        if ((event as PointerEvent).pointerId === id) listener(event as PointerEvent);
      },
      { signal: listening.signal },
    );
  target.setPointerCapture(id);
  listen("pointermove", move);
  for (const type of ["pointerup", "pointercancel", "lostpointercapture"])
    listen(type, (event) => {
      listening.abort();
      end?.(event, type === "pointerup");
    });
  return () => {
    listening.abort();
    if (target.hasPointerCapture(id)) target.releasePointerCapture(id);
  };
}
