// The figures of the API reference: a change of an input changes the picture and what the sample prints. That dragging a point
// changes an input is tested in Chromium (tests/page/api-figures.test.js).
import assert from "node:assert/strict";
import { test } from "node:test";
import { entryFolders, readEntries } from "../../www/api/build/entries.js";
import { firstPicture } from "../../www/api/build/figure.js";
import { runEntry } from "../../www/api/build/run.js";
import { Projection } from "../../www/api/live/projection.js";
import { pointsOf } from "./reference.js";

/** Where a point is dragged, in units of the picture; some figures need several for another result. */
const MOVES = pointsOf("30,10 -30,25 10,-40 60,40 -70,-30 90,-60 -20,80 120,10 -120,40 0,-110");

/** Other values of the inputs, one at a time, as the figure's handles and controls give them. */
function* changes({ inputs, values, handles, view }) {
  for (const { input, index, point } of handles) {
    for (const [dx, dy] of MOVES) {
      const [x, y, z = 0] = point;
      const moved = new Projection(view).moved([x, y, z], dx, dy).slice(0, point.length);
      yield { [input]: index === undefined ? moved : values[input].with(index, moved) };
    }
  }
  for (const { name, kind, min, max, options } of inputs) {
    if (kind === "number") for (let k = 0; k <= 10; k++) yield { [name]: min + (k / 10) * (max - min) };
    if (kind === "choice") for (const value of options) yield { [name]: value };
  }
}

/** Whether a change of an input changes both the picture and the printed lines. */
async function followsInputs(entry) {
  const first = await firstPicture(entry);
  const picture = first.drawing.toSVG(first.view);
  for (const values of changes(first)) {
    try {
      const { drawing, printed } = await runEntry(entry, undefined, values);
      if (drawing.toSVG(first.view) !== picture && printed.join() !== first.printed.join()) return true;
    } catch {} // the figure prints the error; another change may show more
  }
  return false;
}

for (const folder of entryFolders()) {
  const live = [...readEntries(folder)].filter(([, entry]) => entry.draw);
  test(`${folder}: every figure follows its inputs`, async () => {
    const still = [];
    for (const [name, entry] of live) if (!(await followsInputs(entry))) still.push(name);
    assert.deepEqual(still, [], "no input of these changes both the picture and the printed lines");
  });
}
