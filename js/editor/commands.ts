// What can be done to the points: each function returns a new state. Where joints are held, the core does it.
import { Curve } from "../geometry/curve/curve.js";
import { numberIn, wholeIn, wordIn } from "./check.js";
import { generator, randomChain, randomPlaces } from "./random.js";
import { pairs } from "./plane.js";
import { degreeOf, figureOf, keepSpline, splineOf } from "./figure.js";
import { MODES, MAX_POINTS, placeIn, resizedWeights, weightsOf } from "./state.js";
import type { Spline } from "../geometry/spline/spline.js";
import type { State } from "./state.js";
import type { Point2 } from "./state.js";
import type { JointMode } from "./state.js";

/**
 * All points that fill Bézier segments, also the hidden ones, as a chain whose joints can be held; null where there is
 * none.
 */
export function chainOf(state: State): { spline: Spline; degree: number; rest: readonly Point2[] } | null {
  if (state.basis !== "bezier" || weightsOf(state)) return null; // joints of rational curves are not held
  const degree = degreeOf(state);
  const whole = state.degree === "n" ? state.shown : state.points.length;
  const segments = Math.floor((whole - 1) / degree);
  if (segments < 1) return null;
  const used = segments * degree + 1;
  return {
    spline: splineOf(state.points, degree, segments),
    degree,
    rest: state.points.slice(used),
  };
}

/** The mode of each inner joint of the shown chain. */
export function modesOf(state: State): JointMode[] {
  const chain = chainOf(state.shown < state.points.length ? shownOf(state) : state);
  return chain ? modesFor(state, chain.spline) : [];
}

/** Without the points that are not shown. */
const shownOf = (state: State): State => ({ ...state, points: state.points.slice(0, state.shown) });

/**
 * @returns of the joints 1, 2 …
 */
function modesFor({ joints }: State, spline: Spline): JointMode[] {
  return Array.from({ length: spline.segmentCount - 1 }, (_, k) => joints[Math.min(k, joints.length - 1)] ?? "free");
}

/**
 * @returns with other points; where all were shown, all are
 */
function withChain(state: State, spline: Spline, rest: readonly Point2[]): State {
  const points = [...pairs(spline.controlPoints()), ...rest];
  keepSpline(points, spline, degreeOf(state));
  return withList(state, points);
}

function withList(state: State, points: readonly Point2[]): State {
  if (points.length > MAX_POINTS) throw new RangeError(`points: expected at most ${MAX_POINTS}, got ${points.length}`);
  const change = points.length - state.points.length;
  const shown =
    state.shown === state.points.length ? points.length : Math.min(Math.max(state.shown + change, 2), points.length);
  return { ...state, points, shown, weights: resizedWeights(state.weights, points.length) };
}

/** A copy of a list with some of its items replaced by others. */
function spliced<Item>(list: readonly Item[], from: number, count: number, ...items: Item[]): Item[] {
  return [...list.slice(0, from), ...items, ...list.slice(from + count)];
}

/** One point moved, the joints held. */
export function withPointAt(state: State, index: unknown, to: unknown): State {
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
 * @param from the first joint that is another
 */
export function withJoints(state: State, joints: readonly JointMode[], from = 1): State {
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
 * @param joint from 1
 */
export function withJoint(state: State, joint: number, mode: unknown): State {
  const known = wordIn(mode, "joint", MODES);
  const modes = allModes(state);
  return withJoints(state, spliced(modes, wholeIn(joint, "joint", 1, modes.length) - 1, 1, known), joint);
}

/** One mode for each joint, also the hidden ones. */
function allModes(state: State) {
  const chain = chainOf(state);
  return chain ? modesFor(state, chain.spline) : [];
}

/** The joints next to a point let go of it, so that it can be moved alone. */
export function broken(state: State, index: number): State {
  const degree = degreeOf(state);
  const modes = allModes(state);
  const near = modes.map((mode, k) => (Math.abs((k + 1) * degree - index) <= 1 ? "free" : mode));
  return near.some((mode, k) => mode !== modes[k]) ? { ...state, joints: near } : state;
}

/** A matrix of one's own begins with that of the basis before. */
export function withOwnMatrix(state: State, before: State): State {
  const { matrix } = figureOf(before);
  return matrix ? { ...state, matrix } : state;
}

/** Segments can be cut where their halves have points of the same kind. */
export function canInsert({ basis }: State) {
  return basis === "bezier" || basis === "hermite";
}

/** The selected segment cut at t; the curve stays as it is. */
export function inserted(state: State, t: unknown = state.t): State {
  if (!canInsert(state))
    throw new RangeError(`insert: expected the basis bezier or hermite, whose segments can be cut, got ${state.basis}`);
  const at = numberIn(t, "t", 0, 1);
  if (weightsOf(state)) return insertedRational(state, at);
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

/** The selected segment of points with weights cut at t: de Casteljau's algorithm on the points (wP, w). */
function insertedRational(state: State, at: number): State {
  const { points, weights, shown } = state;
  const degree = degreeOf(state);
  const count = Math.floor((shown - 1) / degree);
  if (count < 1) throw new RangeError("insert: expected a curve, got too few points for one");
  const from = Math.min(state.segment, count - 1) * degree;
  const homogeneous = points.slice(from, from + degree + 1).map(([x, y], i) => {
    const w = weights[from + i];
    return [w * x, w * y, w];
  });
  const [first, second] = new Curve(homogeneous, { dimension: 3 }).split(at);
  const inner = [...first.points(), ...second.points().slice(1)].slice(1, -1); // the ends stay as they are
  return {
    ...withList(
      { ...state, weights: spliced(weights, from + 1, degree - 1, ...inner.map(({ z }) => z)) },
      spliced(points, from + 1, degree - 1, ...inner.map(({ x, y, z }): Point2 => [x / z, y / z])),
    ),
    degree,
  };
}

function pointsOf(curve: Curve, basis: "bezier" | "hermite" | string): Point2[] {
  const [a, b, c, d, ...more] = pairs(curve.controlPoints());
  const far = (end: Point2, near: Point2) => end.map((x, i) => x + 3 * (near[i] - x)) as Point2;
  return basis === "hermite" ? [a, far(a, b), far(d, c), d] : ([a, b, c, d, ...more].filter(Boolean) as Point2[]);
}

/**
 * Without a point. In a chain of Bézier curves it heals: a joint goes with its two handles, an end with its segment, and a
 * point off the curve returns to the chord. In every other figure, and with `bare`, the point is taken out of the list.
 */
export function removed(state: State, index: unknown, bare = false): State {
  const at = wholeIn(index, "index", 0, state.points.length - 1);
  const chain = chainOf(state);
  const inside = chain && state.degree !== "n" && at < state.points.length - chain.rest.length;
  if (!bare && inside) return healed(state, chain, at);
  if (state.points.length <= 2) throw new RangeError("remove: expected more than 2 points, got 2");
  const weights = state.weights.length ? spliced(state.weights, at, 1) : state.weights;
  return withList({ ...state, weights }, spliced(state.points, at, 1));
}

function healed(state: State, { spline, degree, rest }: NonNullable<ReturnType<typeof chainOf>>, at: number): State {
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

function onChord(state: State, degree: number, at: number) {
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
 */
export function appended(state: State, point: unknown): State {
  const place = placeIn(point, "point");
  const chain = state.degree === "n" ? null : chainOf({ ...state, shown: state.points.length });
  const next =
    chain && !chain.rest.length
      ? withChain(state, longer(state, chain.spline, place), [])
      : withList(state, [...state.points, place]);
  return { ...next, shown: next.points.length };
}

function longer(state: State, spline: Spline, place: Point2) {
  const joint = spline.segmentCount;
  return spline.append(place).setJoint(joint, state.joints[Math.min(joint, state.joints.length) - 1] ?? "free");
}

/** All points at random places inside, the joints held. */
export function randomized(state: State, seed: number): State {
  const random = generator(wholeIn(seed, "seed", -(2 ** 53), 2 ** 53));
  const chain = chainOf(state);
  if (chain?.degree !== 3)
    return withJoints({ ...state, points: randomPlaces(state.box, state.points.length, random) }, state.joints);
  const modes = modesFor(state, chain.spline);
  const spline = randomChain(state.box, chain.spline.segmentCount, (joint) => modes[joint - 1], random);
  return withChain(state, spline, randomPlaces(state.box, chain.rest.length, random));
}
