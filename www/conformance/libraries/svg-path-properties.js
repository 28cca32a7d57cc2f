// The answers of svg-path-properties: lengths, and points at a length, of SVG paths.
import { svgPathProperties } from "svg-path-properties";
import { tuple } from "../answers.js";

const COMMANDS = ["", "", "L", "Q", "C"];
const STEPS = 64;

/** @param {string} d */
const propertiesOf = (d) => new svgPathProperties(d);

/** @type {import("../answers.js").Answers} */
export const answers = {
  length: ({ points: [start, ...others] }) => {
    const command = COMMANDS[others.length + 1];
    return command && start.length === 2
      ? propertiesOf(`M${start}${command}${others.join(" ")}`).getTotalLength()
      : undefined;
  },
  svgpath: ({ d }) => {
    const path = propertiesOf(d);
    const length = path.getTotalLength();
    return Array.from({ length: STEPS + 1 }, (_, i) => tuple(path.getPointAtLength((i / STEPS) * length)));
  },
  "rational perimeter": ({ rx, ry }) =>
    propertiesOf(`M${rx} 0A${rx} ${ry} 0 0 1 ${-rx} 0A${rx} ${ry} 0 0 1 ${rx} 0`).getTotalLength(),
};
