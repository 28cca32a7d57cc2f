import { LitElement } from "lit";
import { Surface } from "../../surfaces.js";
import { adoptProperties } from "../adopt.js";
import { acceptAttributeText } from "../attribute-text.js";
import { followTranslations } from "../follow-translations.js";
import { PROPERTIES } from "./attributes.js";
import { HOME } from "./camera.js";
import { SurfaceController } from "./controller.js";
import { figureOf } from "./figure.js";
import { frame } from "./frame.js";
import { ATTRIBUTE_NAMES } from "./settings.js";
import { withSurface } from "./state.js";
import { style } from "./style.js";
import { Subject } from "./subject.js";
import type { PropertyDeclaration, PropertyDeclarations } from "lit";
import type { Attributes } from "./settings.js";
import type { State } from "./state.js";

/** Root margin for lazy loading. */
const NEAR = "300px";
/** Root margin of the WebGL context: farther away it is released. */
const FAR = "150% 0px";

/** A surface of another entry point ("casteljau/surfaces", "casteljau/slim"), which has a class of its own. */
function surfaceOfOtherBundle(value: Surface): Surface {
  if (value?.casteljauType !== "surface") {
    const isEmpty = typeof value === "object" && Object.keys(value).length === 0;
    const hint = isEmpty ? " without keys; structuredClone and postMessage need toJSON() and fromJSON()" : "";
    throw new TypeError(`surface: expected a Surface or null, got ${typeof value}${hint}`);
  }
  return Surface.fromJSON(value.toJSON());
}

/** `<bezier-surface>`; what can be set from outside is documented in ../types.js. */
export class BezierSurface extends LitElement {
  // Of the properties, those that are no part of the state.
  declare label: string;
  declare theme: string;
  declare patch: number | null;
  declare controls: string | boolean | null;
  declare autoRotate: boolean;

  static properties: PropertyDeclarations = Object.fromEntries(
    Object.entries(PROPERTIES).map(([name, { declaration }]) => [name, declaration]),
  );

  static getPropertyDescriptor(name: PropertyKey, key: string | symbol, options: PropertyDeclaration) {
    const accessor = isAttribute(name)
      ? BezierSurface.#accessor(name)
      : // biome-ignore lint/complexity/noThisInStatic: Lit's method reads the prototype of the class it is called on
        super.getPropertyDescriptor(name, key, options);
    return acceptAttributeText(accessor, name, options);
  }

  /** A property that is a part of the state. */
  static #accessor(name: keyof Attributes): PropertyDescriptor {
    return {
      configurable: true,
      enumerable: true,
      get(this: BezierSurface) {
        return this.subject.state[name];
      },
      set(this: BezierSurface, value: unknown) {
        const { editor, state } = this.subject;
        if (!Object.is(value, state[name])) editor.replaceState({ ...state, [name]: value });
      },
    };
  }

  static styles = style;
  /**
   * What is shown, without the picture.
   *
   * @internal
   */
  subject: Subject = new Subject((problem) => console.warn(`<${this.localName}> ${problem}`));
  #controller = new SurfaceController(this);
  /** The state of the last call of `#stateChanged`. */
  #lastState: State = this.subject.state;
  #observers: IntersectionObserver[] = [];

  constructor() {
    super();
    followTranslations(this);
    this.subject.editor.subscribe((event) => {
      if (event === "state") this.#stateChanged();
      if (event !== "input") this.requestUpdate(); // a complete step can be undone
    });
    for (const [name, { value }] of Object.entries(PROPERTIES)) Object.assign(this, { [name]: value });
  }

  /** Lit renders what has changed and reflects it. */
  #stateChanged() {
    const [before, { state }] = [this.#lastState, this.subject];
    this.#lastState = state;
    if (before.given !== state.given) this.patch = null;
    for (const name of ATTRIBUTE_NAMES) if (before[name] !== state[name]) this.requestUpdate(name, before[name]);
  }

  /** The surface that is shown, moved points and all. */
  get surface() {
    return this.subject.surface;
  }

  set surface(surface: Surface | null | undefined) {
    this.subject.assigned = surface;
    if ((surface as { casteljauType?: string } | null | undefined)?.casteljauType === "rationalsurface") {
      void this.#showWithWeights(surface);
      return;
    }
    const own = surface === undefined || surface === null || surface instanceof Surface;
    this.#replaceSurface(own ? (surface ?? null) : surfaceOfOtherBundle(surface));
  }

  /** Shows a surface with weights when the code for them is there, unless another one is set before. */
  async #showWithWeights(surface: any) {
    const rational = await this.#controller.loadRational();
    if (!rational || this.subject.assigned !== surface) return;
    this.#replaceSurface(rational.shownSurface(surface));
  }

  /** The page shows another surface: the undo steps are those of the one before. */
  #replaceSurface(surface: Surface | null) {
    const { editor, state } = this.subject;
    editor.replaceState(withSurface(state, surface));
    editor.clearHistory();
    this.patch = null;
  }

  /** Where the eye is: degrees, enlargement, shift in radii. */
  get view() {
    return this.#controller.view;
  }

  set view(view) {
    this.#controller.move(view ?? HOME);
  }

  /** What is shown, as plain values; see SurfaceFigure in ../types.js. */
  get figure() {
    const { scene } = this.#controller;
    return figureOf(scene, this.#controller.factsOf(scene));
  }

  /** Takes back the last change of the surface or its settings by the user. */
  undo() {
    this.subject.editor.undo();
  }

  /** Repeats the change that was taken back. */
  redo() {
    this.subject.editor.redo();
  }

  /** The picture as it is now, a PNG. */
  async toBlob(): Promise<Blob | null> {
    return this.#controller.toBlob();
  }

  connectedCallback() {
    super.connectedCallback();
    adoptProperties(this, ["surface", "view"]);
    this.#observers = [
      this.#observe(FAR, (near) => this.#controller.setNear(near)),
      this.#observe(NEAR, (visible) => this.#controller.setVisible(visible)),
    ];
  }

  disconnectedCallback() {
    super.disconnectedCallback();
    this.#observers.forEach((observer) => observer.disconnect());
    this.#observers = [];
    this.#controller.end();
  }

  #observe(margin: string, act: (inside: boolean) => void) {
    const observer = new IntersectionObserver((entries) => act(entries[entries.length - 1].isIntersecting), {
      rootMargin: margin,
    });
    observer.observe(this);
    return observer;
  }

  /** @internal Renders the controls at once if they are to be rendered. */
  renderControls() {
    if (this.isUpdatePending) this.performUpdate();
  }

  willUpdate(changed: Map<string, unknown>) {
    if (!this.hasUpdated) return;
    if (["model", "height", "up"].some((name) => changed.has(name))) {
      this.subject.forgetMovesOfOthers();
      if (!changed.has("patch")) this.patch = null;
    }
  }

  updated(changed: Map<string, unknown>) {
    this.#controller.update(changed);
    this.dispatchEvent(new Event("update"));
  }

  render() {
    return frame(this.#controller);
  }
}

const isAttribute = (name: PropertyKey): name is keyof Attributes => ATTRIBUTE_NAMES.some((each) => each === name);
