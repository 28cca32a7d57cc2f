// A carefully hand-written baseline: grids of bicubic patches in one JavaScript loop, with typed arrays, with indices
// and weights computed once per grid and rows of the net combined once per v, and without allocations in the loop.

/** @typedef {{ positions: Float32Array, normals: Float32Array, indices: Uint32Array }} Buffers */

/**
 * @param {number} patches
 * @param {number} segments
 * @returns {Buffers}
 */
export function buffers(patches, segments) {
  const vertices = patches * (segments + 1) ** 2;
  const indices = new Uint32Array(6 * patches * segments ** 2);
  fillIndices(patches, segments, indices);
  return { positions: new Float32Array(3 * vertices), normals: new Float32Array(3 * vertices), indices };
}

/**
 * The values of the cubic Bernstein polynomials at k / segments (four each), and of their derivatives.
 *
 * @param {number} segments
 */
export function weights(segments) {
  const values = new Float64Array(4 * (segments + 1));
  const slopes = new Float64Array(4 * (segments + 1));
  for (let k = 0; k <= segments; k++) {
    const t = k / segments;
    const s = 1 - t;
    values.set([s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t], 4 * k);
    slopes.set([-3 * s * s, 3 * s * (s - 2 * t), 3 * t * (2 * s - t), 3 * t * t], 4 * k);
  }
  return { values, slopes };
}

/**
 * Positions and normals of bicubic patches.
 *
 * @param {Float64Array} nets 48 numbers per patch, u along the fast index
 * @param {number} segments
 * @param {{ values: Float64Array, slopes: Float64Array }} weights
 * @param {Buffers} out
 */
export function grid(nets, segments, { values, slopes }, { positions, normals }) {
  const row = new Float64Array(24);
  const line = 3 * (segments + 1);
  let at = 0;
  for (let net = 0; net < nets.length; net += 48) {
    for (let v = 0; v < values.length; v += 4) {
      blendRows(nets, net, values, slopes, v, row);
      fillLine(row, values, slopes, positions, normals, at);
      at += line;
    }
  }
}

/**
 * The patch at one v: four control points in u of the position, then four of the derivative along v.
 *
 * @param {Float64Array} nets
 * @param {number} net
 * @param {Float64Array} values
 * @param {Float64Array} slopes
 * @param {number} v
 * @param {Float64Array} row
 */
function blendRows(nets, net, values, slopes, v, row) {
  for (let k = 0; k < 12; k++) {
    const a = nets[net + k];
    const b = nets[net + 12 + k];
    const c = nets[net + 24 + k];
    const d = nets[net + 36 + k];
    row[k] = values[v] * a + values[v + 1] * b + values[v + 2] * c + values[v + 3] * d;
    row[12 + k] = slopes[v] * a + slopes[v + 1] * b + slopes[v + 2] * c + slopes[v + 3] * d;
  }
}

/**
 * One line of vertices.
 *
 * @param {Float64Array} row
 * @param {Float64Array} values
 * @param {Float64Array} slopes
 * @param {Float32Array} positions
 * @param {Float32Array} normals
 * @param {number} at
 */
function fillLine(row, values, slopes, positions, normals, at) {
  const x0 = row[0],
    y0 = row[1],
    z0 = row[2];
  const x1 = row[3],
    y1 = row[4],
    z1 = row[5];
  const x2 = row[6],
    y2 = row[7],
    z2 = row[8];
  const x3 = row[9],
    y3 = row[10],
    z3 = row[11];
  const p0 = row[12],
    q0 = row[13],
    r0 = row[14];
  const p1 = row[15],
    q1 = row[16],
    r1 = row[17];
  const p2 = row[18],
    q2 = row[19],
    r2 = row[20];
  const p3 = row[21],
    q3 = row[22],
    r3 = row[23];
  for (let u = 0; u < values.length; u += 4, at += 3) {
    const b0 = values[u],
      b1 = values[u + 1],
      b2 = values[u + 2],
      b3 = values[u + 3];
    const d0 = slopes[u],
      d1 = slopes[u + 1],
      d2 = slopes[u + 2],
      d3 = slopes[u + 3];
    const x = b0 * x0 + b1 * x1 + b2 * x2 + b3 * x3;
    const y = b0 * y0 + b1 * y1 + b2 * y2 + b3 * y3;
    const z = b0 * z0 + b1 * z1 + b2 * z2 + b3 * z3;
    const ux = d0 * x0 + d1 * x1 + d2 * x2 + d3 * x3;
    const uy = d0 * y0 + d1 * y1 + d2 * y2 + d3 * y3;
    const uz = d0 * z0 + d1 * z1 + d2 * z2 + d3 * z3;
    const vx = b0 * p0 + b1 * p1 + b2 * p2 + b3 * p3;
    const vy = b0 * q0 + b1 * q1 + b2 * q2 + b3 * q3;
    const vz = b0 * r0 + b1 * r1 + b2 * r2 + b3 * r3;
    const nx = uy * vz - uz * vy;
    const ny = uz * vx - ux * vz;
    const nz = ux * vy - uy * vx;
    const square = nx * nx + ny * ny + nz * nz;
    positions[at] = x;
    positions[at + 1] = y;
    positions[at + 2] = z;
    if (square > 1e-20) {
      const factor = 1 / Math.sqrt(square);
      normals[at] = nx * factor;
      normals[at + 1] = ny * factor;
      normals[at + 2] = nz * factor;
    } else {
      // The collapsed edges of the teapot are at its top and bottom.
      normals[at] = 0;
      normals[at + 1] = 0;
      normals[at + 2] = z > 1 ? 1 : -1;
    }
  }
}

/**
 * Two triangles per cell.
 *
 * @param {number} patches
 * @param {number} segments
 * @param {Uint32Array} indices
 */
function fillIndices(patches, segments, indices) {
  const line = segments + 1;
  let at = 0;
  for (let patch = 0, vertex = 0; patch < patches; patch++, vertex += line) {
    for (let v = 0; v < segments; v++, vertex++) {
      for (let u = 0; u < segments; u++, vertex++, at += 6) {
        indices[at] = vertex;
        indices[at + 1] = vertex + 1;
        indices[at + 2] = vertex + line + 1;
        indices[at + 3] = vertex;
        indices[at + 4] = vertex + line + 1;
        indices[at + 5] = vertex + line;
      }
    }
  }
}
