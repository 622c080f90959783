// The place on the ground that a pixel shows, from the calibration and the pose of the camera.

import { applied, flat, located, turned, visuals } from './frames.js';

/** The outputs that the place needs: the calibration of a camera, and the poses of frames in space. */
function needed(shown) {
  const calibration = visuals(shown.description.value, true).find(({ info }) => info.shape === 'CameraCalibration');
  return { calibration, poses: visuals(shown.description.value, false).filter(({ info }) => info.child && info.shape === 'Pose3') };
}

/** Outputs that the place needs: list for `watch`. */
export function groundInfo(shown) {
  const { calibration, poses } = needed(shown);
  return [calibration, ...poses].filter(Boolean).map(({ component, index }) => [component, index, 3]);
}

/**
 * Returns {x, y}, m, in the ground frame in which the camera has its pose; both are null above the horizon. Null if the robot does not
 * know its camera.
 */
export function ground(shown, column, row) {
  const { calibration, poses } = needed(shown);
  const read = ({ component, index }) => shown.output(component, index).now.value?.value;
  const [known] = flat(calibration && read(calibration));
  const { matrix, notes } = known ? located(poses, read)(calibration.info.frame) : { notes: ['no camera'] };
  if (notes.length > 0) return null;
  const [forward, left, up] = turned(matrix, [1, (known.centre_x - column) / known.focal_x, (known.centre_y - row) / known.focal_y]);
  const [x, y, height] = applied(matrix, [0, 0, 0]);
  return up < -0.01 ? { x: x - (height / up) * forward, y: y - (height / up) * left } : { x: null, y: null };
}
