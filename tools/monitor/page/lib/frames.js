// Frames: an output that is the place of a frame links it to another frame, as tf does.

/** A rotation and a translation: three rows of four numbers. */
export const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];

/** The transformation of a `Pose2` or `Pose3`. */
export function matrixOf(pose) {
  if (!pose.orientation) {
    const [sin, cos] = [Math.sin(pose.heading), Math.cos(pose.heading)];
    return [cos, -sin, 0, pose.x, sin, cos, 0, pose.y, 0, 0, 1, 0];
  }
  const { position: at, orientation: { x, y, z, w } } = pose;
  return [
    1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), at.x,
    2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x), at.y,
    2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y), at.z,
  ];
}

/** Where a transformation puts a point. */
export const applied = (m, [x, y, z = 0]) => [0, 4, 8].map((row) => m[row] * x + m[row + 1] * y + m[row + 2] * z + m[row + 3]);

/** The direction to which it turns one, without the translation. */
export const turned = (m, [x, y, z]) => [0, 4, 8].map((row) => m[row] * x + m[row + 1] * y + m[row + 2] * z);

/** `b`, then `a`. */
export function times(a, b) {
  const column = (index) => turned(a, [b[index], b[index + 4], b[index + 8]]);
  const [x, y, z, at] = [column(0), column(1), column(2), applied(a, [b[3], b[7], b[11]])];
  return [0, 1, 2].flatMap((row) => [x[row], y[row], z[row], at[row]]);
}

export function inverse(m) {
  const turn = [m[0], m[4], m[8], 0, m[1], m[5], m[9], 0, m[2], m[6], m[10], 0];
  const at = turned(turn, [m[3], m[7], m[11]]);
  return [0, 1, 2].flatMap((row) => [...turn.slice(4 * row, 4 * row + 3), -at[row]]);
}

/** Heading of the x axis on the ground. */
export const headingOf = (m) => Math.atan2(m[4], m[0]);

const IN_IMAGE = /^(Image|CameraCalibration)/;
/** Types with a frame that are numbers, not drawings. */
const NUMBERS = /^(Joints|Imu)$/;

/** The outputs that can be drawn on a map, or in an image: [{component, name, index, info}] with the component's number and name. */
export function visuals(description, inImage) {
  return (description?.components ?? []).flatMap(({ name, info: infos }, component) => infos
    .map((info, index) => ({ component, name, index, info }))
    .filter(({ info }) => info.frame && !NUMBERS.test(info.shape) && IN_IMAGE.test(info.shape) === inImage));
}

/** The output with measured joints: [component, output]; null if the tree has none. */
export function jointsOf(shown) {
  for (const [component, { info }] of (shown?.description.value?.components ?? []).entries()) {
    const index = info.findIndex(({ shape }) => shape === 'Joints');
    if (index >= 0) return [component, index];
  }
  return null;
}

/** Number of the colour of a component, the same on the map and in the image. */
export const colourOf = (description, component) => [...new Set([...visuals(description, true), ...visuals(description, false)].map((one) => one.component))].indexOf(component);

/** A value as the list of what it contains: options and lists are taken apart. */
export const flat = (value) => (value === null || value === undefined ? [] : Array.isArray(value) ? value.flatMap(flat) : [value]);

/**
 * The frames at the shown moment: a function that returns the place of a frame, {matrix, root, notes}, in the root of its tree.
 * `read(output)` is the value of an output; `truth` lists what a world states.
 */
export function located(outputs, read, truth = []) {
  const places = new Map(outputs.filter(({ info }) => info.child).map((output) => [output.info.child, output]));
  const known = new Map();
  const place = (frame) => {
    if (known.has(frame)) return known.get(frame);
    const output = places.get(frame);
    const given = truth.find(({ child }) => child === frame);
    let at = { matrix: IDENTITY, root: frame, notes: [] };
    // Until it is known, a frame that lies in itself ends here.
    known.set(frame, at);
    if (output || given) {
      const found = flat(output && read(output))[0];
      const above = place(found || !given ? output.info.frame : given.frame);
      const pose = found ?? given?.value;
      const note = output && !found ? [given ? `${frame} placed by the truth` : `place of ${frame} unknown`] : [];
      at = { matrix: pose ? times(above.matrix, matrixOf(pose)) : above.matrix, root: above.root, notes: [...above.notes, ...note] };
      known.set(frame, at);
    }
    return at;
  };
  return place;
}
