// What sessions have to draw on a map: layers of their outputs and of what their worlds state.

import { effect, useEffect, useSignal } from '../../lib/dom.js';
import { request } from '../../lib/connection.js';
import { applied, colourOf, flat, inverse, located, matrixOf, times, visuals } from '../../lib/frames.js';
import { partsOf } from '../../lib/shapes.js';
import { cursor, visibleRange } from '../../lib/store.js';
import { css, curveColour } from '../../lib/theme.js';

const DASHED = [3, 3];
const HALO = '#ffffffa0';
/** Points of the track of a recording. */
const TRACK = 400;
/** Time before a track is read while the interval changes, ms. */
const SETTLED_MS = 200;

export const keyOf = ({ name, info }) => `${name}.${info.name}`;

/** The outputs of a session that have a place, and how they are read at the shown moment. `main` is the frame of most of them: the robot's. */
export function sourceOf(shown) {
  const outputs = visuals(shown.description.value, false);
  const count = (frame) => outputs.filter(({ info }) => info.frame === frame).length;
  const main = outputs.reduce((best, { info }) => (best === undefined || count(info.frame) > count(best) ? info.frame : best), undefined);
  const read = ({ component, index }) => shown.output(component, index).now.value?.value;
  const truth = () => shown.truth.value?.truth ?? [];
  return { shown, outputs, main, read, truth, place: () => located(outputs, read, truth()), pose: outputs.find(({ info }) => info.child === main), key: shown.id };
}

/** What places a frame in a view: a function from its name to its matrix; null for a frame that has no place in the view. */
export const toViewOf = (place, view) => {
  const { matrix: own, root } = place(view);
  const back = inverse(own);
  return (frame) => {
    const { matrix, root: other } = place(frame);
    return other === root ? times(back, matrix) : null;
  };
};

/** The same for another session: roots of one name are one place. */
export const toViewBeside = (other, ownPlace, view) => {
  const [place, toView] = [other.place(), toViewOf(ownPlace, view)];
  return (frame) => {
    const { matrix, root } = place(frame);
    const base = root === ownPlace(view).root ? toView(root) : null;
    return base && times(base, matrix);
  };
};

/**
 * What a session draws, the lowest first: {parts, matrix, style, trail}; nothing of a frame that has no place in the view. `own` is the
 * colour that all of another session has, `group` the one that the outputs of each session have.
 */
export function layersOf(source, toView, { seen, hidden, sceneryShown, truthShown, own = null, group = null }) {
  const { shown, outputs, main, read } = source;
  const layer = (frame, shape, value, style, key) => {
    const matrix = toView(frame);
    const parts = matrix ? flat(value).flatMap((one) => partsOf(shape, one)) : [];
    return { parts, matrix, style, trail: key && seen.trails(`${source.key} ${key}`) };
  };
  // Of the true places of frames only that of the robot is drawn.
  const states = (plain) => ({ name, frame, shape, value, child, colour, line_width: width }) => (child && child !== main ? [] : [layer(frame, shape, value,
    colour && !own ? { colour, width, fill: width === undefined } : { ...plain, width }, shape === 'Pose2' && name)]);
  const scenery = sceneryShown && !own ? shown.scenery.value.flatMap(states({ colour: css('--dim'), fill: true })) : [];
  const found = outputs.map((output) => layer(output.info.frame, output.info.shape, hidden.has(keyOf(output)) ? null : read(output), {
    colour: group ?? own ?? curveColour(colourOf(shown.description.value, output.component)), halo: own ? css('--panel') : HALO,
    faint: !shown.moment.value?.components?.[output.component]?.[0],
  }, output.info.child === main && output.info.child));
  return { scenery, found, stated: truthShown ? source.truth().flatMap(states({ colour: own ?? css('--truth'), halo: css('--panel'), dash: DASHED })) : [] };
}

/** The tracks of the robots in the visible interval while the past is shown: Map from the key of a source to points in the frame of its pose. */
export function useTracks(sources, visible) {
  const tracks = useSignal(new Map());
  useEffect(() => {
    let timer = null;
    const read = async () => {
      const [from, until] = visibleRange.peek();
      const found = new Map();
      for (const { shown, pose, key, shift } of sources) {
        if (!pose) continue;
        const [begin, end] = [from, until].map((at) => Math.max(0, Math.round(at + shift)));
        const samples = await request('series', { session: shown.id, component: pose.component, info: pose.index, from_us: begin, until_us: end, points: TRACK }).catch(() => []);
        found.set(key, samples.flatMap(([, value]) => flat(value).map((one) => applied(matrixOf(one), [0, 0, 0]))));
      }
      tracks.value = found;
    };
    const stop = effect(() => {
      void visibleRange.value;
      clearTimeout(timer);
      if (cursor.value !== null && visible.value) timer = setTimeout(read, SETTLED_MS);
      else if (tracks.peek().size > 0) tracks.value = new Map();
    });
    return () => {
      stop();
      clearTimeout(timer);
    };
  }, [sources]);
  return tracks;
}
