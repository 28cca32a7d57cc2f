// The attributes of the element and their properties.
import { LitElement } from "lit";
import { acceptAttributeText, CONTROLS } from "../attribute-text.js";
import { followTranslations } from "../follow-translations.js";
import { Memo } from "./memo.js";
import { SettingsReader } from "./settings.js";
import type { PropertyDeclaration } from "lit";
import type { Settings } from "./settings.js";

const text = { type: String, reflect: true };
const number = { type: Number, reflect: true };
const flag = { type: Boolean, reflect: true };

/** All that can be written as an attribute; what it means is documented in ../types.js. */
export class SurfaceAttributes extends LitElement {
  declare model: string;
  declare parts: string | null;
  declare height: string;
  declare up: string;
  declare shading: string;
  declare show: string;
  declare evaluation: string;
  declare label: string;
  declare theme: string;
  declare segments: number;
  declare tolerance: number | null;
  declare pixels: number | null;
  declare flatness: number | null;
  declare lines: number;
  declare u: number;
  declare v: number;
  declare step: number;
  declare patch: number | null;
  declare controls: string | boolean | null;
  declare turn: boolean;
  declare swept: boolean;
  declare probe: string | null;

  static properties = {
    model: text,
    parts: text,
    height: text,
    up: text,
    shading: text,
    show: text,
    evaluation: text,
    label: text,
    theme: { ...text, useDefault: true },
    probe: text,
    segments: number,
    tolerance: number,
    pixels: number,
    flatness: number,
    lines: number,
    u: number,
    v: number,
    step: number,
    patch: number,
    controls: CONTROLS,
    turn: flag,
    swept: flag,
  };

  static getPropertyDescriptor(name: PropertyKey, key: string | symbol, options: PropertyDeclaration) {
    // biome-ignore lint/complexity/noThisInStatic: Lit's method reads the prototype of the class it is called on
    return acceptAttributeText(super.getPropertyDescriptor(name, key, options), name, options);
  }

  #memo = new Memo();
  #reader = new SettingsReader((problem) => console.warn(`<${this.localName}> ${problem}`));

  constructor() {
    super();
    followTranslations(this);
    this.model = "teapot";
    this.parts = null;
    this.height = "squashed";
    this.up = "z";
    this.shading = "smooth";
    this.show = "surface";
    this.evaluation = "cpu";
    this.label = "";
    this.theme = "auto";
    this.segments = 12;
    this.tolerance = null;
    this.pixels = null;
    this.flatness = null;
    this.lines = 4;
    this.u = 0.5;
    this.v = 0.5;
    this.step = 4;
    this.patch = null;
    this.controls = null;
    this.turn = false;
    this.swept = false;
    this.probe = null;
  }

  /**
   * What they amount to; the same object as long as they are the same.
   *
   * @protected
   */
  settings(): Settings {
    const {
      model,
      parts,
      height,
      up,
      segments,
      tolerance,
      pixels,
      flatness,
      lines,
      shading,
      show,
      evaluation,
      u,
      v,
      step,
      swept,
      probe,
    } = this;
    const given = {
      model,
      parts,
      height,
      up,
      segments,
      tolerance,
      pixels,
      flatness,
      lines,
      shading,
      show,
      evaluation,
      u,
      v,
      step,
      swept,
      probe,
    };
    return this.#memo.get("settings", Object.values(given), () => this.#reader.read(given));
  }
}
