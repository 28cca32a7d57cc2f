// A page in Firefox or WebKitGTK: the few commands of WebDriver that the tests need.
import { until } from "./until.js";
import { startFirefox } from "./marionette.js";
import { startWebKit } from "./webkit.js";

/** @typedef {"navigate" | "execute" | "act" | "release" | "timeouts" | "resize"} Command */
/** @typedef {{ send(command: Command, parameters: object): Promise<any>, end(): Promise<void> }} Transport */

const STARTS = { firefox: startFirefox, webkit: startWebKit };
const SCRIPT_MS = 120_000;
const SIZE = { width: 900, height: 1200 };

/** Keys by name, as WebDriver writes them. */
const KEYS = {
  Tab: "\uE004",
  Enter: "\uE007",
  Shift: "\uE008",
  Control: "\uE009",
  Alt: "\uE00A",
  Escape: "\uE00C",
  ArrowLeft: "\uE012",
  ArrowUp: "\uE013",
  ArrowRight: "\uE014",
  ArrowDown: "\uE015",
  Delete: "\uE017",
};

/**
 * Starts a browser.
 *
 * @param {"firefox" | "webkit"} name
 * @param {string} path of Firefox or of WebKit's driver
 */
export async function start(name, path) {
  const transport = await STARTS[name](path);
  await transport.send("timeouts", { script: SCRIPT_MS, pageLoad: SCRIPT_MS });
  await transport.send("resize", SIZE);
  return new Session(transport);
}

export class Session {
  #transport;

  /** @param {Transport} transport */
  constructor(transport) {
    this.#transport = transport;
  }

  end() {
    return this.#transport.end();
  }

  /**
   * Goes to a page and waits until it has been drawn.
   *
   * @param {string} url
   */
  async open(url) {
    await this.#transport.send("navigate", { url });
    await this.frame();
  }

  /** Waits until what was changed has been drawn. */
  frame() {
    return this.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  }

  /**
   * Calls a function in the page; promises are waited for, what it throws is thrown here.
   *
   * @param {(...args: any[]) => any} act
   * @param {...any} args plain values
   */
  async evaluate(act, ...args) {
    const script = `const [args, done] = [[...arguments].slice(0, -1), arguments[arguments.length - 1]];
      Promise.resolve().then(() => (${act})(...args)).then((value) => done({ value }), (error) => done({ error: String(error?.stack && error) }));`;
    const { value, error } = await this.#transport.send("execute", { script, args });
    if (error) throw new Error(`in the page: ${error}`);
    return value ?? undefined;
  }

  /**
   * Waits until a function in the page gives something true.
   *
   * @param {(...args: any[]) => any} ask
   * @param {...any} args
   */
  waitFor(ask, ...args) {
    return until(String(ask), () => this.evaluate(ask, ...args));
  }

  /**
   * Presses a key, or several together: "m", "Shift+ArrowRight".
   *
   * @param {...string} chords
   */
  async press(...chords) {
    for (const chord of chords) {
      const keys = chord.split(/\+(?=.)/).map((key) => KEYS[key] ?? key);
      const down = keys.map((value) => ({ type: "keyDown", value }));
      const up = keys.toReversed().map((value) => ({ type: "keyUp", value }));
      await this.#transport.send("act", { actions: [{ type: "key", id: "keyboard", actions: [...down, ...up] }] });
    }
  }

  /**
   * Presses the mouse at the first place, moves it along the others and lets it go. One place: a click.
   *
   * @param {...[number, number]} places in the window
   */
  async drag(...places) {
    const to = ([x, y]) => ({
      type: "pointerMove",
      x: Math.round(x),
      y: Math.round(y),
      duration: 0,
      origin: "viewport",
    });
    const [first, ...others] = places.map(to);
    const actions = [first, { type: "pointerDown", button: 0 }, ...others, { type: "pointerUp", button: 0 }];
    await this.#transport.send("act", {
      actions: [{ type: "pointer", id: "mouse", parameters: { pointerType: "mouse" }, actions }],
    });
  }
}
