// Handles of the figure: points of limbs, each with the ways on which numbers of the keyframe move it.

import { applied, inverse, times, turned } from '../lib/frames.js';

/** Distance within which a handle is taken with the pointer, px, and of a drag from where its direction counts. */
const [REACH, BEGIN] = [13, 4];
/** Number of points on a way, from the least to the largest value. */
const SAMPLES = 400;
/** Share of a way along itself by which a point counts as farther: of two equally near ones the next is meant. */
const NEXT = 0.02;

const plus = (a, b, factor = 1) => a.map((value, index) => value + factor * b[index]);
const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
const length = (a) => Math.hypot(...a);

/** Where a handle is after a change of its number. */
export function moved({ at, way: { origin, turn, along } }, change) {
  const rate = length(turn);
  const from = plus(at, origin, -1);
  if (rate === 0) return plus(at, along, change);
  const axis = turn.map((value) => value / rate);
  const [sin, cos] = [Math.sin(rate * change), Math.cos(rate * change)];
  const dot = axis.reduce((sum, value, index) => sum + value * from[index], 0);
  const turnedBy = plus(plus(from.map((value) => value * cos), cross(axis, from), sin), axis, dot * (1 - cos));
  return plus(plus(origin, turnedBy), along, change);
}

/** The handles of a keyframe in its figure: [{at, ways}]. */
export const handlesOf = ({ handles, anchor }) => handles.map(({ at, ways }) => ({
  at: applied(anchor, at),
  ways: ways.map((way) => ({ ...way, origin: applied(anchor, way.origin), turn: turned(anchor, way.turn), along: turned(anchor, way.along) })),
}));

/** What keeps the frame of the handles where it was in another posture. */
export const kept = (before, now) => times(before, inverse(now));

/** The nearest handle to a point of the canvas, of those that nearly coincide the one in front; undefined if none is near. */
export function near(handles, to, [x, y]) {
  const far = ({ at }) => Math.hypot(to(at)[0] - x, to(at)[1] - y);
  const place = (one) => Math.round(far(one) / BEGIN);
  return handles.filter((one) => far(one) < REACH).sort((a, b) => place(a) - place(b) || to(a.at)[2] - to(b.at)[2])[0];
}

/** The points of a way on the canvas, with the values: [[value, x, y]]. `value` is where the handle is. */
export function course(at, way, { min, max }, value, to) {
  return Array.from({ length: SAMPLES + 1 }, (_, index) => min + ((max - min) * index) / SAMPLES).map((one) => [one, ...to(moved({ at, way }, one - value))]);
}

/** The number whose way goes most nearly in the direction of a drag; undefined while the drag is short. */
export function wayOf({ at, ways }, to, [x, y]) {
  if (Math.hypot(x, y) < BEGIN) return undefined;
  const begin = to(at);
  const along = ({ origin, turn, along: way }) => {
    const speed = plus(cross(turn, plus(at, origin, -1)), way);
    // A step that is small for the figure: what a way does not show in this view is short there.
    const [toX, toY] = to(plus(at, speed, 0.01 / length(speed)));
    return Math.abs((toX - begin[0]) * x + (toY - begin[1]) * y);
  };
  return ways.toSorted((a, b) => along(b) - along(a))[0];
}

/** The value of the point of a way that is nearest to a point of the canvas, from the present value on. */
export function valueNear(points, value, [x, y]) {
  const start = points.reduce((best, [one], index) => (Math.abs(one - value) < Math.abs(points[best][0] - value) ? index : best), 0);
  const cost = new Float64Array(points.length);
  for (const step of [1, -1]) {
    for (let [index, way] = [start, 0]; index >= 0 && index < points.length; index += step) {
      const [, toX, toY] = points[index];
      if (index !== start) way += Math.hypot(toX - points[index - step][1], toY - points[index - step][2]);
      cost[index] = (toX - x) ** 2 + (toY - y) ** 2 + NEXT * way ** 2;
    }
  }
  return points[cost.indexOf(Math.min(...cost))][0];
}
