// Double clicks and double taps on an empty place. Not the event "dblclick", which touch screens fire at their discretion.

/** As long as between the two clicks of a double click on most systems. */
const DOUBLE_MS = 500;
/** A fingertip's uncertainty. */
const DOUBLE_PX = 24;

/**
 * @param overlay only clicks on itself count, not those on its children
 */
export function onDoubleTap(overlay: HTMLElement, act: (event: MouseEvent) => void) {
  let first: MouseEvent | null = null;
  overlay.addEventListener("click", (event) => {
    if (event.target !== overlay) first = null;
    else if (first && isSameTap(first, event)) [first] = [null, act(event)];
    else first = event;
  });
}

function isSameTap(first: MouseEvent, second: MouseEvent): boolean {
  const far = Math.hypot(second.clientX - first.clientX, second.clientY - first.clientY);
  return second.timeStamp - first.timeStamp <= DOUBLE_MS && far <= DOUBLE_PX;
}
