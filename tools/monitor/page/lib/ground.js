// The place on the ground that a pixel shows, from what the robot knows of its camera.

let focal = null;

/** Reads an output of the shown moment by names. */
function read(shown, component, name) {
  const place = shown.findInfo(component, name);
  return place ? shown.info_of(...place).now.value?.value ?? null : null;
}

/** Information that the place needs: list for `watch`. */
export function groundInfo(shown) {
  return ['camera_position', 'optical_axis', 'horizon'].map((name) => shown.findInfo('CameraPose', name)).filter(Boolean).map((place) => [...place, 3]);
}

/**
 * Returns {pan, down, x, y}: the ray in rad and the point in m, in the robot's frame; x and y are null above the horizon. Null if the
 * robot does not know its camera. The focal length is found from the row of the horizon, so it needs an image in which the camera
 * looks down.
 */
export function ground(shown, image, column, row) {
  const [position, axis, horizon] = ['camera_position', 'optical_axis', 'horizon'].map((name) => read(shown, 'CameraPose', name));
  if (!position || !axis) return null;
  const middle = image.height / 2;
  if (horizon !== null && Math.abs(axis.down) > 0.1) focal = (middle - horizon) / Math.tan(axis.down) / image.height;
  if (!focal) return null;
  const f = focal * image.height;
  // Camera frame: forward, left, down; then turned by the axis.
  const [left, down] = [(image.width / 2 - column) / f, (row - middle) / f];
  const [sin, cos] = [Math.sin(axis.down), Math.cos(axis.down)];
  const forward = cos - down * sin;
  const drop = sin + down * cos;
  const pan = axis.pan + Math.atan2(left, forward);
  const ray = { pan, down: Math.atan2(drop, Math.hypot(forward, left)), x: null, y: null };
  if (drop > 0.01) {
    const distance = (position[2] / drop) * Math.hypot(forward, left);
    ray.x = position[0] + distance * Math.cos(pan);
    ray.y = position[1] + distance * Math.sin(pan);
  }
  return ray;
}
