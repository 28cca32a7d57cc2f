// What templates may give to the elements, for the types of React, Vue and Svelte.
import type {
  BernsteinProperties,
  CompanionProperties,
  CoordinatesProperties,
  EasingProperties,
  EquationProperties,
  LinkProperties,
} from "./companions/types.js";
import type { AppletProperties, SurfaceProperties } from "./types.js";

type Method = (...values: never[]) => unknown;

/** Properties that a template may give: all but methods and those that are excluded; each by its value, or as the text of its attribute. */
type Given<Properties, Excluded extends keyof Properties = never> = {
  [Name in keyof Properties as Properties[Name] extends Method ? never : Exclude<Name, Excluded>]?:
    | Properties[Name]
    | ([Properties[Name]] extends [boolean] ? "" : [Properties[Name]] extends [string] ? never : string);
};

type AppletProps = Given<AppletProperties, "figure" | "state"> & Partial<Pick<AppletProperties, "state">>;
type SurfaceProps = Given<SurfaceProperties, "figure" | "surface" | "view"> &
  Partial<Pick<SurfaceProperties, "surface">> & {
    view?: Partial<SurfaceProperties["view"]>;
  };
type LinkProps = Given<CompanionProperties> & Given<LinkProperties, "target"> & { for?: string };
type EasingProps = Given<CompanionProperties> &
  Given<EasingProperties, "type" | "form" | "labels" | "validity" | "validationMessage" | "willValidate"> & {
    form?: string;
  };

/** The attributes and properties of each element in a template. */
export interface BezierElementProps {
  "bezier-applet": AppletProps;
  "bezier-bernstein": LinkProps & Given<BernsteinProperties>;
  "bezier-coordinates": LinkProps & Given<CoordinatesProperties>;
  "bezier-easing": EasingProps;
  "bezier-equation": LinkProps & Given<EquationProperties>;
  "bezier-surface": SurfaceProps;
}
