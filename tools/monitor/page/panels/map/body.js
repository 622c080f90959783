// The body of the robot in three dimensions: an extension of the program has its links, an output the positions of its joints.

import { useEffect, useSignal } from '../../lib/dom.js';
import { jointsOf, matrixOf, times } from '../../lib/frames.js';
import { watch } from '../../lib/store.js';

const turnOf = ([x, y, z], angle) => {
  const [sin, cos] = [Math.sin(angle / 2), Math.cos(angle / 2)];
  return matrixOf({ position: { x: 0, y: 0, z: 0 }, orientation: { x: sin * x, y: sin * y, z: sin * z, w: cos } });
};

/** The pose of each link in the frame of the first one. */
function posed(links, { names, positions }) {
  const poses = [];
  for (const { parent, pose, joint, axis } of links) {
    const own = joint === null ? pose : times(pose, turnOf(axis, positions[names.indexOf(joint)]));
    poses.push(parent === null ? own : times(poses[parent], own));
  }
  return poses;
}

/**
 * The body of the robot of a session: `joints()` reads the positions, and `placed(toView)` is its links with their poses,
 * {links, matrices}, or null.
 */
export function useBody(shown, description, wanted) {
  const body = useSignal(null);
  const place = jointsOf(shown);
  const joints = () => (place ? shown.output(...place).now.value?.value : undefined);
  useEffect(() => (place && wanted ? watch({ info: [[...place, 3]] }) : undefined), [shown, description, wanted]);
  const names = wanted && body.value?.of !== shown ? joints()?.names : undefined;
  useEffect(() => {
    const ask = async () => {
      // Imported here: panels of an extension import the map.
      const { EXTENSIONS } = await import('../../extensions.js');
      const found = await EXTENSIONS.find(({ body: has }) => has)?.body(shown, names);
      body.value = { of: shown, found };
    };
    if (names) ask();
  }, [Boolean(names)]);
  const placed = (toView) => {
    const [known, now] = [body.value?.of === shown ? body.value.found : null, joints()];
    const at = known && now && toView(known.frame);
    return at ? { links: known.links, matrices: posed(known.links, now).map((pose) => times(at, pose)) } : null;
  };
  return { joints, placed };
}
