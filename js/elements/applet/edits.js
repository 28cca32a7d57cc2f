// What can be done to the points: each function returns a new state. Where joints are held, the core does it.
import { Curve, Spline } from "../../paths.js";
import { generator, randomChain, randomPlaces } from "../../applet/random.js";
import { pairs } from "../../applet/state.js";
import { degreeOf, figureOf } from "./figure.js";
import { MODES, MOST_POINTS, numberIn, placeIn, wholeIn, wordIn } from "./state.js";

/** @typedef {import("./state.js").State} State */
/** @typedef {import("./state.js").Place} Place */
/** @typedef {import("./state.js").JointMode} JointMode */

/**
 * All points that fill Bézier segments, also the hidden ones, as a chain whose joints can be held; null where there is
 * none.
 *
 * @param {State} state
 * @returns {{ spline: Spline, degree: number, rest: readonly Place[] } | null}
 */
export function chainOf(state) {
  if (state.basis !== "bezier") return null;
  const degree = degreeOf(state);
  const whole = state.degree === "n" ? state.shown : state.points.length;
  const segments = Math.floor((whole - 1) / degree);
  if (segments < 1) return null;
  const used = segments * degree + 1;
  return {
    spline: new Spline(state.points.slice(0, used), { degree, dimension: 2 }),
    degree,
    rest: state.points.slice(used),
  };
}

/**
 * The mode of each inner joint of the shown chain.
 *
 * @param {State} state
 * @returns {JointMode[]}
 */
export function modesOf(state) {
  const chain = chainOf({ ...state, points: state.points.slice(0, state.shown) });
  return chain ? modesFor(state, chain.spline) : [];
}

/**
 * @param {State} state
 * @param {Spline} spline
 * @returns {JointMode[]} of the joints 1, 2 …
 */
function modesFor({ joints }, spline) {
  return Array.from({ length: spline.segmentCount - 1 }, (_, k) => joints[Math.min(k, joints.length - 1)] ?? "free");
}

/**
 * @param {State} state
 * @param {Spline} spline
 * @param {readonly Place[]} rest
 * @returns {State} with other points; where all were shown, all are
 */
function withChain(state, spline, rest) {
  return withList(state, [...pairs(spline.controlPoints()), ...rest]);
}

/**
 * @param {State} state
 * @param {readonly Place[]} points
 * @returns {State}
 */
function withList(state, points) {
  if (points.length > MOST_POINTS)
    throw new RangeError(`points: expected at most ${MOST_POINTS}, got ${points.length}`);
  const change = points.length - state.points.length;
  const shown =
    state.shown === state.points.length ? points.length : Math.min(Math.max(state.shown + change, 2), points.length);
  return { ...state, points, shown };
}

/**
 * A copy of a list with some of its items replaced by others.
 *
 * @template Item
 * @param {readonly Item[]} list
 * @param {number} from
 * @param {number} count
 * @param {Item[]} items
 * @returns {Item[]}
 */
function spliced(list, from, count, ...items) {
  return [...list.slice(0, from), ...items, ...list.slice(from + count)];
}

/**
 * One point moved, the joints held.
 *
 * @param {State} state
 * @param {unknown} index
 * @param {unknown} to
 * @returns {State}
 */
export function withPointAt(state, index, to) {
  const at = wholeIn(index, "index", 0, state.points.length - 1);
  const place = placeIn(to, "point");
  const chain = chainOf(state);
  if (!chain || at >= state.points.length - chain.rest.length)
    return { ...state, points: spliced(state.points, at, 1, place) };
  const { spline, rest } = chain;
  return withChain(state, spline.movePoint(at, place, { joints: ["free", ...modesFor(state, spline)] }), rest);
}

/**
 * Other modes; each is enforced at once, from the first joint to the last.
 *
 * @param {State} state
 * @param {readonly JointMode[]} joints
 * @param {number} [from] the first joint that is another
 * @returns {State}
 */
export function withJoints(state, joints, from = 1) {
  const next = { ...state, joints };
  const chain = chainOf(next);
  if (!chain) return next;
  let { spline } = chain;
  modesFor(next, spline).forEach((mode, k) => {
    if (k + 1 >= from) spline = spline.setJoint(k + 1, mode);
  });
  return withChain(next, spline, chain.rest);
}

/**
 * @param {State} state
 * @param {number} joint from 1
 * @param {unknown} mode
 * @returns {State}
 */
export function withJoint(state, joint, mode) {
  const known = wordIn(mode, "joint", MODES);
  const modes = allModes(state);
  return withJoints(state, spliced(modes, wholeIn(joint, "joint", 1, modes.length) - 1, 1, known), joint);
}

/**
 * One mode for each joint, also the hidden ones.
 *
 * @param {State} state
 */
function allModes(state) {
  const chain = chainOf(state);
  return chain ? modesFor(state, chain.spline) : [];
}

/**
 * The joints next to a point let go of it, so that it can be moved alone.
 *
 * @param {State} state
 * @param {number} index
 * @returns {State}
 */
export function broken(state, index) {
  const degree = degreeOf(state);
  const modes = allModes(state);
  const near = modes.map((mode, k) => (Math.abs((k + 1) * degree - index) <= 1 ? "free" : mode));
  return near.some((mode, k) => mode !== modes[k]) ? { ...state, joints: near } : state;
}

/**
 * A matrix of one's own begins with that of the basis before.
 *
 * @param {State} state
 * @param {State} before
 * @returns {State}
 */
export function withOwnMatrix(state, before) {
  const { matrix } = figureOf(before);
  return matrix ? { ...state, matrix } : state;
}

/** Segments can be cut where their halves have points of the same kind. @param {State} state */
export function canInsert({ basis }) {
  return basis === "bezier" || basis === "hermite";
}

/**
 * The selected segment cut at t; the curve stays as it is.
 *
 * @param {State} state
 * @param {unknown} [t]
 * @returns {State}
 */
export function inserted(state, t = state.t) {
  if (!canInsert(state))
    throw new RangeError(`insert: expected the basis bezier or hermite, whose segments can be cut, got ${state.basis}`);
  const at = numberIn(t, "t", 0, 1);
  const { pieces, degree } = figureOf(state);
  const segment = Math.min(state.segment, pieces.length - 1);
  if (segment < 0) throw new RangeError("insert: expected a curve, got too few points for one");
  const halves = pieces[segment].curve.split(at).map((half) => pointsOf(half, state.basis));
  const from = segment * degree;
  const middle = [...halves[0], ...halves[1].slice(1)];
  const modes = allModes(state);
  const points = [...state.points.slice(0, from), ...middle, ...state.points.slice(from + degree + 1)];
  return {
    ...withList(state, points),
    degree: state.degree === "n" ? degree : state.degree,
    joints: spliced(modes, segment, 0, "g1"),
  };
}

/**
 * @param {Curve} curve
 * @param {"bezier" | "hermite" | string} basis
 * @returns {Place[]}
 */
function pointsOf(curve, basis) {
  const [a, b, c, d, ...more] = pairs(curve.controlPoints());
  const far = (/** @type {Place} */ end, /** @type {Place} */ near) =>
    /** @type {Place} */ (end.map((x, i) => x + 3 * (near[i] - x)));
  return basis === "hermite"
    ? [a, far(a, b), far(d, c), d]
    : /** @type {Place[]} */ ([a, b, c, d, ...more].filter(Boolean));
}

/**
 * Without a point. In a chain of Bézier curves it heals: a joint goes with its two handles, an end with its segment, and a
 * point off the curve returns to the chord. In every other figure, and with `bare`, the point is taken out of the list.
 *
 * @param {State} state
 * @param {unknown} index
 * @param {boolean} [bare]
 * @returns {State}
 */
export function removed(state, index, bare = false) {
  const at = wholeIn(index, "index", 0, state.points.length - 1);
  const chain = chainOf(state);
  const inside = chain && state.degree !== "n" && at < state.points.length - chain.rest.length;
  if (!bare && inside) return healed(state, chain, at);
  if (state.points.length <= 2) throw new RangeError("remove: expected more than 2 points, got 2");
  return withList(state, spliced(state.points, at, 1));
}

/**
 * @param {State} state
 * @param {NonNullable<ReturnType<typeof chainOf>>} chain
 * @param {number} at
 * @returns {State}
 */
function healed(state, { spline, degree, rest }, at) {
  const [joint, last] = [at / degree, spline.segmentCount];
  if (!Number.isInteger(joint)) return onChord(state, degree, at);
  if (last === 1) throw new RangeError("remove: expected a joint or a handle, got an end of the only segment");
  const points = pairs(spline.controlPoints());
  const shorter =
    joint === 0
      ? points.slice(degree)
      : joint === last
        ? points.slice(0, -degree)
        : pairs(spline.remove(joint).controlPoints());
  const joints = spliced(allModes(state), Math.min(Math.max(joint, 1), last - 1) - 1, 1);
  return { ...withList(state, [...shorter, ...rest]), joints: joints.length ? joints : ["free"], segment: 0 };
}

/**
 * @param {State} state
 * @param {number} degree
 * @param {number} at
 */
function onChord(state, degree, at) {
  const from = at - (at % degree);
  const [a, b] = [state.points[from], state.points[from + degree]];
  return withPointAt(
    state,
    at,
    a.map((x, i) => x + ((b[i] - x) * (at % degree)) / degree),
  );
}

/**
 * One more segment that ends at a point, its handles automatic; where points wait, or there are no segments, one more
 * point. Then all are shown.
 *
 * @param {State} state
 * @param {unknown} point
 * @returns {State}
 */
export function appended(state, point) {
  const place = placeIn(point, "point");
  const chain = state.degree === "n" ? null : chainOf({ ...state, shown: state.points.length });
  const next =
    chain && !chain.rest.length
      ? withChain(state, longer(state, chain.spline, place), [])
      : withList(state, [...state.points, place]);
  return { ...next, shown: next.points.length };
}

/**
 * @param {State} state
 * @param {Spline} spline
 * @param {Place} place
 */
function longer(state, spline, place) {
  const joint = spline.segmentCount;
  return spline.append(place).setJoint(joint, state.joints[Math.min(joint, state.joints.length) - 1] ?? "free");
}

/**
 * All points at random places inside, the joints held.
 *
 * @param {State} state
 * @param {number} seed
 * @returns {State}
 */
export function randomized(state, seed) {
  const random = generator(wholeIn(seed, "seed", -(2 ** 53), 2 ** 53));
  const chain = chainOf(state);
  if (chain?.degree !== 3)
    return withJoints({ ...state, points: randomPlaces(state.box, state.points.length, random) }, state.joints);
  const modes = modesFor(state, chain.spline);
  const spline = randomChain(state.box, chain.spline.segmentCount, (joint) => modes[joint - 1], random);
  return withChain(state, spline, randomPlaces(state.box, chain.rest.length, random));
}
