// The elements in Svelte's templates: `import "casteljau/svelte"`. Only programs that import this need Svelte.
import type { HTMLAttributes } from "svelte/elements";
import type { BezierElementTagNameMap } from "./tag-names.js";
import type { BezierElementProps } from "./template-props.js";

export type { BezierElementProps };

type Events = { onupdate?: (event: Event) => void };

type Described<Element extends EventTarget, Properties> = Properties &
  Events &
  Omit<HTMLAttributes<Element>, keyof Properties>;

type BezierElements = {
  [Name in keyof BezierElementProps]: Described<BezierElementTagNameMap[Name], BezierElementProps[Name]>;
};

declare module "svelte/elements" {
  interface SvelteHTMLElements extends BezierElements {}
}
