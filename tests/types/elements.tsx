// The elements in TypeScript: by tag name, by class and in JSX of React 19; mistakes are type errors.
import { Surface as WholeSurface } from "casteljau";
import { type AppletFigure, type BezierAppletElement, type BezierEasingElement, loadElement } from "casteljau/elements";
import { BezierApplet } from "casteljau/elements/applet";
import "casteljau/react";
import { Surface } from "casteljau/surfaces";
import { useRef } from "react";

const applet = document.createElement("bezier-applet");
applet.points = [
  [0, 0],
  [1, 1],
];
export const shown: AppletFigure = applet.figure;
const surfaceElement = document.querySelector("bezier-surface");
if (surfaceElement) surfaceElement.surface = WholeSurface.teapot();
export const field: BezierEasingElement | null = document.querySelector("bezier-easing");
export const surface: Surface | null | undefined = document.querySelector("bezier-surface")?.surface;
export const degrees: [number | undefined, number | null | undefined] = [
  document.querySelector("bezier-bernstein")?.degree,
  document.querySelector("bezier-equation")?.degree,
];
export const pairs: number[][] | undefined = document.querySelector("bezier-coordinates")?.points;
export const made: BezierAppletElement = new BezierApplet();
export const defined: Promise<void> = loadElement("bezier-applet");
// @ts-expect-error
void loadElement("bezier-sphere");
applet.theme = "dark";
applet.appendPoint([3, 4]);
// @ts-expect-error
applet.basis = "cubic";
document.body.append(applet, made);

export function Page() {
  const ref = useRef<BezierAppletElement>(null);
  return (
    <main>
      <bezier-applet
        ref={ref}
        id="a"
        points="70,330 200,40"
        joints="c1"
        t={0.5}
        degree={3}
        readonly
        controls=""
        onupdate={() => {}}
      />
      <bezier-applet points={[[0, 0]]} joints={["g1"]} style={{ width: 300 }} onInput={() => ref.current?.undo()} />
      <bezier-surface
        model="teapot"
        segments="24"
        pixels={0.5}
        autoRotate
        view={{ zoom: 2 }}
        surface={Surface.teapot()}
      />
      <bezier-bernstein for="a" degree={3} />
      <bezier-equation htmlFor="a" editable form="matrix" />
      <bezier-coordinates points="0,0 1,1" className="table" />
      <bezier-easing
        name="easing"
        required
        value="ease-in"
        form="f"
        oninput={() => {}}
        onchange={(event) => event.target}
      />
    </main>
  );
}

export const mistakes = [
  // @ts-expect-error
  <bezier-applet points={3} key="1" />,
  // @ts-expect-error
  <bezier-surface model="cup" key="0" />,
  // @ts-expect-error
  <bezier-applet joints={["c7"]} key="2" />,
  // @ts-expect-error
  <bezier-applet readonly="yes" key="3" />,
  // @ts-expect-error
  <bezier-surface surface="teapot" key="4" />,
  // @ts-expect-error
  <bezier-easing validity={{}} key="5" />,
  // @ts-expect-error
  <bezier-sphere key="6" />,
];
// @ts-expect-error
applet.figure.tt;
