// The elements in JSX of React 19: `import "casteljau/react"`. Only programs that import this need @types/react.
import type { DetailedHTMLProps, HTMLAttributes } from "react";
import type { BezierElementTagNameMap } from "./tag-names.js";
import type { BezierElementProps } from "./template-props.js";

export type { BezierElementProps };

/** Events of custom elements: React listens to the name after "on", as it is written. */
type Events = Partial<Record<"oninput" | "onchange" | "onupdate", (event: Event) => void>>;

type Props<Element, Properties> = DetailedHTMLProps<
  Omit<HTMLAttributes<Element>, keyof Properties> & Properties,
  Element
>;

type BezierIntrinsicElements = {
  [Name in keyof BezierElementProps]: Props<BezierElementTagNameMap[Name], BezierElementProps[Name] & Events>;
};

declare module "react" {
  namespace JSX {
    interface IntrinsicElements extends BezierIntrinsicElements {}
  }
}
