// Counts pixels of pictures.

/**
 * How many pixels of a canvas are nearly of a colour, or of any; in all of it, or within so many CSS pixels of a place.
 *
 * @param {import("playwright-core").Locator} canvas
 * @param {{ colour?: number[], at?: number[], reach?: number, alpha?: number }} [what] alpha: the least that counts
 * @returns {Promise<number>}
 */
export const countPixels = (canvas, { colour = [], at = [], reach = 0, alpha = 100 } = {}) =>
  canvas.evaluate(
    (/** @type {HTMLCanvasElement} */ canvas, { colour, at: [x, y], reach, alpha }) => {
      const { width, height } = canvas;
      const copy = Object.assign(document.createElement("canvas"), { width, height });
      const context = /** @type {CanvasRenderingContext2D} */ (copy.getContext("2d", { willReadFrequently: true }));
      context.drawImage(canvas, 0, 0);
      const scale = width / canvas.clientWidth;
      const [left, top, size] = [x - reach, y - reach, 2 * reach].map((length) => Math.round(length * scale));
      const { data } =
        x === undefined ? context.getImageData(0, 0, width, height) : context.getImageData(left, top, size, size);
      let count = 0;
      for (let i = 0; i < data.length; i += 4) {
        const far = colour.reduce((sum, value, k) => sum + Math.abs(data[i + k] - value), 0);
        if (data[i + 3] > alpha && far < 40) count++;
      }
      return count;
    },
    { colour, at, reach, alpha },
  );
