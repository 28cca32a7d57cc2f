// Elements that come into view together start one after the other, so that no frame has to wait for all of them.

/** An element waits no longer than this for an idle moment of the page. */
const MAX_WAIT_MS = 200;

let last = Promise.resolve();

/** Resolves when all elements that asked before have had their turn and the page is idle. */
export function whenIdle() {
  last = last.then(idle);
  return last;
}

function idle(): Promise<void> {
  return new Promise((done) => {
    if ("requestIdleCallback" in globalThis) requestIdleCallback(() => done(), { timeout: MAX_WAIT_MS });
    else setTimeout(done); // Safari
  });
}
