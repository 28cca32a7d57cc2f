// The attributes of the element and their properties.
import { LitElement } from "lit";
import { acceptAttributeText, CONTROLS } from "../attribute-text.js";
import { followTranslations } from "../follow-translations.js";
import { Memo } from "./memo.js";
import { OPTIONS, SettingsReader } from "./settings.js";
import type { PropertyDeclaration, PropertyDeclarations } from "lit";
import type { Attributes, Settings } from "./settings.js";

const reflected = (type: unknown) => ({ type, reflect: true });

/** For each property: its declaration, and its value without the attribute. The last five do not change the scene. */
const PROPERTIES: Record<string, { declaration: unknown; value: unknown }> = {
  ...Object.fromEntries(
    Object.entries(OPTIONS).map(([name, { type, property }]) => [
      name,
      { declaration: reflected(type), value: property },
    ]),
  ),
  label: { declaration: reflected(String), value: "" },
  theme: { declaration: { ...reflected(String), useDefault: true }, value: "auto" },
  patch: { declaration: reflected(Number), value: null },
  controls: { declaration: CONTROLS, value: null },
  turn: { declaration: reflected(Boolean), value: false },
};
const SETTINGS = Object.keys(OPTIONS) as (keyof Attributes)[];

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

  static properties: PropertyDeclarations = Object.fromEntries(
    Object.entries(PROPERTIES).map(([name, { declaration }]) => [name, declaration as PropertyDeclaration]),
  );

  static getPropertyDescriptor(name: PropertyKey, key: string | symbol, options: PropertyDeclaration) {
    // biome-ignore lint/complexity/noThisInStatic: Lit's method reads the prototype of the class it is called on
    return acceptAttributeText(super.getPropertyDescriptor(name, key, options), name, options);
  }

  #memo = new Memo();
  #reader = new SettingsReader((problem) => console.warn(`<${this.localName}> ${problem}`));

  constructor() {
    super();
    followTranslations(this);
    for (const [name, { value }] of Object.entries(PROPERTIES)) Object.assign(this, { [name]: value });
  }

  /**
   * What they amount to; the same object as long as they are the same.
   *
   * @protected
   */
  settings(): Settings {
    const given = Object.fromEntries(SETTINGS.map((name) => [name, this[name]])) as Attributes;
    return this.#memo.get("settings", Object.values(given), () => this.#reader.read(given));
  }
}
