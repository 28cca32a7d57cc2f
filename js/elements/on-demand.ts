// Fetches the code of each kind of element when the page has one close to its visible part.
import { loader } from "./loader.js";
import { once } from "./loading.js";
import type { BezierElementTagNameMap } from "./tag-names.js";

type Name = keyof BezierElementTagNameMap;

/** What defines each element. */
const LOADERS: Record<Name, () => Promise<unknown>> = {
  "bezier-applet": once(() => import("./define/applet.js"), "BezierApplet"),
  "bezier-bernstein": once(() => import("./define/bernstein.js"), "BezierBernstein"),
  "bezier-coordinates": once(() => import("./define/coordinates.js"), "BezierCoordinates"),
  "bezier-easing": once(() => import("./define/easing.js"), "BezierEasing"),
  "bezier-equation": once(() => import("./define/equation.js"), "BezierEquation"),
  "bezier-surface": once(() => import("./define/surface.js"), "BezierSurface"),
};
const NAMES = Object.keys(LOADERS) as Name[];
/** Form fields are loaded wherever they are: a form may be sent before they are seen. */
const FIELD = "bezier-easing";

/** Root margin for lazy loading. */
const NEAR = "300px";

/** Elements take the space that they will need before they are defined. Every rule of the page has precedence over these. */
const SHEET = `
:where(${NAMES.map((name) => `${name}:not(:defined, [hidden])`).join()}) { display: block; box-sizing: border-box; min-block-size: 3rem; }
:where(bezier-applet:not(:defined)) { inline-size: 670px; max-inline-size: 100%; aspect-ratio: 670 / 480; }
:where(bezier-surface:not(:defined)) { aspect-ratio: var(--bz-aspect, 4 / 3); }
@media (max-width: 420px) { :where(bezier-surface:not(:defined)) { aspect-ratio: var(--bz-aspect, 1); } }
`;

const isName = (name: string): name is Name => Object.hasOwn(LOADERS, name);
const isDefined = ({ localName }: Element) => Boolean(customElements.get(localName));

/**
 * Loads the code of an element and defines it. `casteljau/elements` does so by itself for elements of the document that are
 * close to its visible part, and for every `<bezier-easing>`. Call this for elements in shadow trees, and before you use
 * properties and methods of an element that may not be defined yet.
 *
 * @param name for example "bezier-applet"
 * @returns resolves when all elements with this name are defined. If the code cannot be fetched it rejects, and the next
 *   call tries again.
 * @throws {TypeError} if the package has no such element
 */
export async function loadElement(name: keyof BezierElementTagNameMap): Promise<void> {
  if (!isName(name)) throw new TypeError(`name: expected one of ${NAMES.join(", ")}, got ${String(name)}`);
  await LOADERS[name]();
}

/** Like `loadElement`, where no one waits for the result. */
async function request(name: string) {
  if (isName(name)) await LOADERS[name]().catch((error) => console.warn(`<${name}> could not be loaded:`, error));
}

/** Loads what comes near in a document, now and later. */
export function observe(page: Document) {
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(SHEET);
  page.adoptedStyleSheets = [...page.adoptedStyleSheets, sheet];

  const near = new IntersectionObserver(
    (entries) => {
      for (const { target, isIntersecting } of entries) {
        if (isDefined(target)) near.unobserve(target);
        else if (isIntersecting) void request(target.localName);
      }
    },
    { rootMargin: NEAR },
  );
  const selector = NAMES.join();
  const follow = (element: Element) => {
    if (isDefined(element)) return;
    if (element.localName === FIELD) void request(FIELD);
    else near.observe(element);
  };
  const followAll = (parent: ParentNode) => parent.querySelectorAll(selector).forEach(follow);
  const changes = new MutationObserver((records) => {
    for (const { addedNodes } of records)
      for (const node of addedNodes) {
        if (!(node instanceof Element)) continue;
        if (node.matches(selector)) follow(node);
        followAll(node);
      }
  });
  changes.observe(page, { subtree: true, childList: true });
  followAll(page);

  loader.request = (name) => {
    void request(name);
    return isName(name);
  };
}
