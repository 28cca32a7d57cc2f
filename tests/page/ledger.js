// What a page has running: put in before any script, it keeps count of listeners beyond the elements, frames, timers,
// observers and graphics contexts.

/** Runs in the page. @param {string} also elements of this name count, too */
function keep(also) {
  const live = {
    listeners: new Map(),
    frames: new Set(),
    intervals: new Set(),
    observed: new Map(),
    contexts: 0,
    made: 0,
  };
  const beyond = (target) =>
    target === window ||
    target === document ||
    target === document?.documentElement ||
    target === document?.body ||
    target instanceof MediaQueryList ||
    target === window.visualViewport ||
    target === document?.fonts ||
    (also !== "" && target?.localName === also);
  const keyOf = (type, listener, options) => [
    type,
    Boolean(typeof options === "object" ? options?.capture : options),
    listener,
  ];
  const same = (a, b) => a.every((x, i) => x === b[i]);
  const { addEventListener: add, removeEventListener: remove } = EventTarget.prototype;
  const forget = (target, key) => {
    const list = live.listeners.get(target) ?? [];
    const at = list.findIndex((each) => same(each, key));
    if (at >= 0) list.splice(at, 1);
  };
  EventTarget.prototype.addEventListener = function (type, listener, /** @type {any} */ options) {
    const target = this ?? window;
    if (listener && beyond(target)) {
      const key = keyOf(type, listener, options);
      const list = live.listeners.get(target) ?? [];
      if (!list.some((each) => same(each, key))) list.push(key);
      live.listeners.set(target, list);
      options?.signal && add.call(options.signal, "abort", () => forget(target, key));
      if (options?.once) add.call(target, type, () => forget(target, key), { once: true, capture: key[1] });
    }
    return add.call(target, type, listener, options);
  };
  EventTarget.prototype.removeEventListener = function (type, listener, options) {
    const target = this ?? window;
    forget(target, keyOf(type, listener, options));
    return remove.call(target, type, listener, options);
  };
  const {
    requestAnimationFrame: request,
    cancelAnimationFrame: cancel,
    setInterval: start,
    clearInterval: stop,
  } = window;
  window.requestAnimationFrame = (act) => {
    const id = request.call(window, (now) => {
      live.frames.delete(id);
      act(now);
    });
    live.frames.add(id);
    return id;
  };
  window.cancelAnimationFrame = (id) => {
    live.frames.delete(id);
    cancel.call(window, id);
  };
  window.setInterval = (/** @type {any[]} */ ...args) => {
    const id = Reflect.apply(start, window, args);
    live.intervals.add(id);
    return id;
  };
  window.clearInterval = (id) => {
    live.intervals.delete(id);
    stop.call(window, id);
  };
  for (const name of ["ResizeObserver", "IntersectionObserver", "MutationObserver"]) {
    const { prototype } = window[name];
    const { observe, disconnect, unobserve } = prototype;
    const targets = (observer) => live.observed.get(observer) ?? live.observed.set(observer, new Set()).get(observer);
    prototype.observe = function (target, ...rest) {
      observe.call(this, target, ...rest); // may refuse
      targets(this).add(target);
    };
    prototype.disconnect = function () {
      live.observed.delete(this);
      return disconnect.call(this);
    };
    if (unobserve) {
      prototype.unobserve = function (target) {
        targets(this).delete(target);
        if (targets(this).size === 0) live.observed.delete(this);
        return unobserve.call(this, target);
      };
    }
  }
  const seen = new WeakSet();
  const { getContext } = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = /** @returns {any} */ function (kind, ...rest) {
    const context = getContext.call(this, kind, ...rest);
    if (context && /webgl/.test(kind) && !seen.has(context)) {
      seen.add(context);
      live.contexts++;
    }
    return context;
  };
  const { define } = customElements;
  const names = [];
  customElements.define = function (name, ...rest) {
    names.push(name);
    return define.call(this, name, ...rest);
  };
  globalThis.ledger = {
    names,
    /** How much of each is alive; frames and timers that end by themselves are not waited for here. */
    count: () => ({
      listeners: [...live.listeners.values()].reduce((sum, list) => sum + list.length, 0),
      frames: live.frames.size,
      intervals: live.intervals.size,
      observers: live.observed.size,
      contexts: live.contexts,
    }),
    /** The kinds of listeners, for messages. */
    types: () => [...live.listeners.values()].flat().map(([type]) => type),
  };
}

/**
 * Opens nothing yet: puts the ledger into every page that is opened next.
 *
 * @param {import("playwright-core").Page} page
 */
export function keepLedger(page) {
  return page.addInitScript(keep, "");
}

/** The same as a script for a page as text. @param {string} also the listeners of elements of this name count, too */
export const ledgerScript = (also) => `(${keep})(${JSON.stringify(also)})`;

/**
 * What is left after collecting what is not used: bytes of the scripts' heap (without the machine code that the browser
 * makes as it goes, and what it notes for itself), nodes, and listeners of all kinds, as the browser itself counts them.
 *
 * @param {import("playwright-core").CDPSession} client
 */
export async function leftOver(client) {
  for (let i = 0; i < 3; i++) await client.send("HeapProfiler.collectGarbage");
  const { nodes, jsEventListeners } = await client.send("Memory.getDOMCounters");
  return { bytes: await heapBytes(client), nodes, listeners: jsEventListeners };
}

/** What the browser has for itself: of the page's things the nodes are among it, which are counted apart. */
const NOT_OURS = ["code", "native", "hidden"];

/** The sizes of all that a snapshot of the heap holds of the page's scripts. */
async function heapBytes(client) {
  const chunks = [];
  const listen = ({ chunk }) => chunks.push(chunk);
  client.on("HeapProfiler.addHeapSnapshotChunk", listen);
  await client.send("HeapProfiler.takeHeapSnapshot");
  client.off("HeapProfiler.addHeapSnapshotChunk", listen);
  const {
    nodes,
    snapshot: { meta },
  } = JSON.parse(chunks.join(""));
  const [step, type, size] = [
    meta.node_fields.length,
    meta.node_fields.indexOf("type"),
    meta.node_fields.indexOf("self_size"),
  ];
  const foreign = new Set(NOT_OURS.map((name) => meta.node_types[type].indexOf(name)));
  let bytes = 0;
  for (let i = 0; i < nodes.length; i += step) if (!foreign.has(nodes[i + type])) bytes += nodes[i + size];
  return bytes;
}
