// The size of a canvas in device pixels.

/**
 * Keeps the canvas as sharp as the display, and the overlay over it.
 *
 * @param resized called with the size in CSS pixels after every change of size, and once at the start
 * @returns ends it
 */
export function followSize(
  canvas: HTMLCanvasElement,
  overlay: HTMLElement,
  resized: (width: number, height: number) => void,
): () => void {
  const observer = new ResizeObserver((entries) => {
    const { width, height } = devicePixels(canvas, entries[entries.length - 1]);
    if (canvas.width !== width) canvas.width = width;
    if (canvas.height !== height) canvas.height = height;
    coverCanvas(canvas, overlay);
    resized(canvas.clientWidth, canvas.clientHeight);
  });
  observeDevicePixels(observer, canvas);
  return () => observer.disconnect();
}

/** Observes the size in device pixels where the browser knows it: then a window that moves to another display is noticed, too. */
function observeDevicePixels(observer: ResizeObserver, canvas: HTMLCanvasElement) {
  try {
    observer.observe(canvas, { box: "device-pixel-content-box" });
  } catch {
    observer.observe(canvas); // Safari before 26
  }
}

/** The factor of `zoom` in the styles around an element: of two positions of pointers, it is in their distance. */
export const cssZoom = (element: Element): number => (element as any).currentCSSZoom ?? 1;

/**
 * The exact number of device pixels, where the browser reports it. While developer tools emulate another display, Chromium
 * reports CSS pixels: a number that differs from the ratio by more than rounding is not used.
 */
function devicePixels(canvas: HTMLCanvasElement, entry: ResizeObserverEntry): { width: number; height: number } {
  const ratio = (canvas.ownerDocument.defaultView?.devicePixelRatio ?? 1) * cssZoom(canvas);
  const [width, height] = [entry.contentRect.width * ratio, entry.contentRect.height * ratio];
  const reported = entry.devicePixelContentBoxSize?.[0];
  const exact = reported && Math.abs(reported.inlineSize - width) <= 1 && Math.abs(reported.blockSize - height) <= 1;
  return {
    width: Math.max(1, exact ? reported.inlineSize : Math.round(width)),
    height: Math.max(1, exact ? reported.blockSize : Math.round(height)),
  };
}

/** The canvas lies at the stage's upper left corner; the overlay leaves a border of it free. */
function coverCanvas({ clientLeft, clientTop, clientWidth, clientHeight }: HTMLCanvasElement, overlay: HTMLElement) {
  overlay.style.left = `${clientLeft}px`;
  overlay.style.top = `${clientTop}px`;
  overlay.style.width = `${clientWidth}px`;
  overlay.style.height = `${clientHeight}px`;
}
