// The properties of the element, each with its attribute.
import { attributeName, CONTROLS } from "../attribute-text.js";
import { ATTRIBUTE_NAMES, OPTIONS } from "./settings.js";
import type { PropertyDeclaration } from "lit";

const reflected = (type: unknown) => ({ type, reflect: true }) as PropertyDeclaration;

/** For each property: its declaration, and its value without the attribute. Only the last five are no part of the state. */
export const PROPERTIES: Record<string, { declaration: PropertyDeclaration; value: unknown }> = {
  ...Object.fromEntries(
    ATTRIBUTE_NAMES.map((name) => {
      const { type, property } = OPTIONS[name];
      return [name, { declaration: reflected(type), value: property }];
    }),
  ),
  label: { declaration: reflected(String), value: "" },
  theme: { declaration: { ...reflected(String), useDefault: true }, value: "auto" },
  patch: { declaration: reflected(Number), value: null },
  controls: { declaration: CONTROLS, value: null },
  autoRotate: {
    declaration: { ...reflected(Boolean), attribute: attributeName("autoRotate") },
    value: false,
  },
};
