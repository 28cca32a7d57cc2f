// Points that are dragged with the pointer or moved with the arrow keys: the circles with the class "handle" of an SVG.

const KEY_STEP = 5;
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

/** The position of a pointer event in the units of the SVG's viewBox. */
export const positionIn = (svg, { clientX, clientY }) =>
  new DOMPoint(clientX, clientY).matrixTransform(svg.getScreenCTM().inverse());

/** Calls onMove after each movement, and returns a function that gives the points as [x, y]. */
export function draggablePoints(svg, onMove) {
  const handles = [...svg.querySelectorAll("circle.handle")];
  for (const [i, handle] of handles.entries()) makeDraggable(svg, handle, `Point ${i}`, onMove);
  return () => handles.map(({ cx, cy }) => [cx.baseVal.value, cy.baseVal.value]);
}

function makeDraggable(svg, handle, name, onMove) {
  const moveTo = (x, y) => {
    const { width, height } = svg.viewBox.baseVal;
    handle.cx.baseVal.value = Math.min(Math.max(x, 0), width);
    handle.cy.baseVal.value = Math.min(Math.max(y, 0), height);
    onMove();
  };
  const attributes = { tabindex: 0, role: "button", "aria-roledescription": "draggable point" };
  for (const [key, value] of Object.entries(attributes)) handle.setAttribute(key, value);
  if (!handle.querySelector("title")) handle.setAttribute("aria-label", name);
  handle.addEventListener("pointerdown", (event) => handle.setPointerCapture(event.pointerId));
  handle.addEventListener("pointermove", (event) => {
    if (!handle.hasPointerCapture(event.pointerId)) return;
    const { x, y } = positionIn(svg, event);
    moveTo(x, y);
  });
  handle.addEventListener("keydown", (event) => {
    const [dx, dy] = ARROWS[event.key] ?? [];
    if (dx === undefined) return;
    event.preventDefault();
    moveTo(handle.cx.baseVal.value + dx * KEY_STEP, handle.cy.baseVal.value + dy * KEY_STEP);
  });
}
