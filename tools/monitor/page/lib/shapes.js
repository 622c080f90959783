// Visual types on a map: each is a list of lines, dots and poses in its own frame.

import { applied, headingOf, matrixOf, times } from './frames.js';

const point = ({ x, y, z = 0 }) => [x, y, z];

/** Points around a place; the axes are those of a unit circle. */
function around({ x, y }, ahead, left, count = 40) {
  const angles = Array.from({ length: count }, (_, index) => (2 * Math.PI * index) / count);
  return angles.map((angle) => [x + ahead[0] * Math.cos(angle) + left[0] * Math.sin(angle), y + ahead[1] * Math.cos(angle) + left[1] * Math.sin(angle)]);
}

/** The ellipse of one standard deviation. */
function deviation({ x, y, xx, xy, yy }) {
  const [turn, half, mean] = [0.5 * Math.atan2(2 * xy, xx - yy), Math.hypot((xx - yy) / 2, xy), (xx + yy) / 2];
  const [long, short] = [mean + half, mean - half].map((variance) => Math.sqrt(Math.max(variance, 0)));
  const [sin, cos] = [Math.sin(turn), Math.cos(turn)];
  return around({ x, y }, [long * cos, long * sin], [-short * sin, short * cos]);
}

function rectangle({ x, y, heading, length, width }) {
  const matrix = matrixOf({ x, y, heading });
  return [[1, 1], [-1, 1], [-1, -1], [1, -1]].map(([ahead, left]) => applied(matrix, [(ahead * length) / 2, (left * width) / 2]));
}

function scanned({ angle_min, angle_increment, range_max, ranges }) {
  const rays = ranges.map((range, index) => [range, angle_min + index * angle_increment]);
  // A distance that is not finite is null.
  return rays.filter(([range]) => range !== null && range <= range_max).map(([range, angle]) => [range * Math.cos(angle), range * Math.sin(angle)]);
}

const PARTS = {
  Point2: (value) => [{ dots: [point(value)] }],
  Point3: (value) => [{ dots: [point(value)] }],
  Pose2: (value) => [{ pose: matrixOf(value) }],
  Pose3: (value) => [{ pose: matrixOf(value) }],
  PoseWithCovariance2: (value) => [{ pose: matrixOf(value) }, { line: deviation(value), closed: true }],
  Ellipse: (value) => [{ dots: [point(value)] }, { line: deviation(value), closed: true }],
  Circle: (value) => [{ line: around(value, [value.radius, 0], [0, value.radius]), closed: true }],
  Rectangle: (value) => [{ line: rectangle(value), closed: true }],
  Segment: ({ start, end }) => [{ line: [point(start), point(end)] }],
  Polyline: ({ points }) => [{ line: points.map(point) }],
  Scan: (value) => [{ dots: scanned(value), small: true }],
};

/** The parts of a value; nothing for a type that this page does not know. */
export const partsOf = (shape, value) => PARTS[shape]?.(value) ?? [];

/** The points of a part in the frame to which the transformation leads. */
export function pointsOf({ dots, line, pose }, matrix) {
  if (pose) return [applied(matrix, [pose[3], pose[7], pose[11]])];
  return (dots ?? line).map((at) => applied(matrix, at));
}

/**
 * Draws a part. `style` has the colour, that of a halo, dash, fill, width, m, of lines, and whether
 * the part is faint.
 */
export function drawPart(context, map, part, matrix, { colour, halo, dash = [], fill, width, faint }) {
  const points = pointsOf(part, matrix).map(([x, y]) => [map.x(x), map.y(y)]);
  context.globalAlpha = faint ? 0.35 : 1;
  [context.strokeStyle, context.fillStyle] = [colour, colour];
  [context.lineCap, context.lineJoin] = [dash.length > 0 ? 'butt' : 'round', 'round'];
  context.setLineDash(dash);
  context.lineWidth = width ? Math.max(1.2, width * map.scale) : 1.8;
  context.beginPath();
  if (part.pose) {
    const [[x, y]] = points;
    const [size, angle] = [Math.max(0.13 * map.scale, 6), map.angle(headingOf(times(matrix, part.pose)))];
    context.arc(x, y, size, 0, 2 * Math.PI);
    context.moveTo(x, y);
    context.lineTo(x + 1.7 * size * Math.cos(angle), y + 1.7 * size * Math.sin(angle));
  } else if (part.dots) {
    for (const [x, y] of points) {
      context.moveTo(x, y);
      context.arc(x, y, part.small ? 1.5 : 4, 0, 2 * Math.PI);
    }
    context.fill();
  } else {
    points.forEach(([x, y]) => context.lineTo(x, y));
    if (part.closed) context.closePath();
  }
  if (fill && part.closed) context.fill();
  else if (halo && !part.small && !faint) {
    const { lineWidth } = context;
    [context.strokeStyle, context.lineWidth] = [halo, lineWidth + 2.5];
    context.setLineDash([]);
    context.stroke();
    [context.strokeStyle, context.lineWidth] = [colour, lineWidth];
    context.setLineDash(dash);
  }
  if (!fill || !part.closed) context.stroke();
  context.setLineDash([]);
  context.globalAlpha = 1;
}
