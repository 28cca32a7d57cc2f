// The elements in JSX of React 19: `import type {} from "casteljau/react"`. Only programs that import this need @types/react.
import type { DetailedHTMLProps, HTMLAttributes } from "react";
import type {
  BernsteinProperties,
  CompanionProperties,
  CoordinatesProperties,
  EasingProperties,
  EquationProperties,
  LinkProperties,
} from "./companions/types.js";
import type { BezierElementTagNameMap } from "./tag-names.js";
import type { AppletProperties, SurfaceProperties } from "./types.js";

type Method = (...values: never[]) => unknown;

/** Properties that a template may give: all but methods and those that are excluded; each by its value, or as the text of its attribute. */
type Given<Properties, Excluded extends keyof Properties = never> = {
  [Name in keyof Properties as Properties[Name] extends Method ? never : Exclude<Name, Excluded>]?:
    | Properties[Name]
    | ([Properties[Name]] extends [boolean] ? "" : [Properties[Name]] extends [string] ? never : string);
};

/** Events of custom elements: React listens to the name after "on", as it is written. */
type Events = Partial<Record<"oninput" | "onchange" | "onupdate", (event: Event) => void>>;

type Props<Element, Properties> = DetailedHTMLProps<
  Omit<HTMLAttributes<Element>, keyof Properties> & Properties,
  Element
>;

type AppletProps = Given<
  AppletProperties,
  "figure" | "state" | "mode" | "degree" | "segment" | "tolerance" | "segments" | "offset" | "ticks"
> &
  Partial<Record<"mode" | "degree" | "segment" | "tolerance" | "segments" | "offset" | "ticks", string | number>> & {
    state?: AppletProperties["state"];
  };
type SurfaceProps = Given<SurfaceProperties, "figure" | "surface" | "view"> &
  Partial<Pick<SurfaceProperties, "surface">> & {
    view?: Partial<SurfaceProperties["view"]>;
  };
type LinkProps = Given<CompanionProperties> & Given<LinkProperties, "target"> & { for?: string };
type EasingProps = Given<CompanionProperties> &
  Given<EasingProperties, "type" | "form" | "labels" | "validity" | "validationMessage" | "willValidate"> & {
    form?: string;
  };

/** What JSX may give to each element. */
export interface BezierElementProps {
  "bezier-applet": AppletProps;
  "bezier-bernstein": LinkProps & Given<BernsteinProperties>;
  "bezier-coordinates": LinkProps & Given<CoordinatesProperties>;
  "bezier-easing": EasingProps;
  "bezier-equation": LinkProps & Given<EquationProperties>;
  "bezier-surface": SurfaceProps;
}

type BezierIntrinsicElements = {
  [Name in keyof BezierElementProps]: Props<BezierElementTagNameMap[Name], BezierElementProps[Name] & Events>;
};

declare module "react" {
  namespace JSX {
    interface IntrinsicElements extends BezierIntrinsicElements {}
  }
}
