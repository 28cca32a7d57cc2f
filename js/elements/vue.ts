// The elements in Vue's templates: `import "casteljau/vue"`. Only programs that import this need Vue.
import type { EmitFn, HTMLAttributes } from "vue";
import type { BezierElementTagNameMap } from "./tag-names.js";
import type { BezierElementProps } from "./template-props.js";

export type { BezierElementProps };

type Events = { input: (event: Event) => void; change: (event: Event) => void; update: (event: Event) => void };

/** An element as Vue's compiler describes components. */
type Described<Element, Properties> = new () => Element & {
  /** @deprecated For the template compiler only */
  $props: Properties & Omit<HTMLAttributes, keyof Properties>;
  /** @deprecated For the template compiler only */
  $emit: EmitFn<Events>;
};

type BezierComponents = {
  [Name in keyof BezierElementProps]: Described<BezierElementTagNameMap[Name], BezierElementProps[Name]>;
};

declare module "vue" {
  interface GlobalComponents extends BezierComponents {}
}
