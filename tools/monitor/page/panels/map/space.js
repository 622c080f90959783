// The map in three dimensions: frames, what cameras see, and the views. The library is loaded when it is needed first.

import { html, useEffect, useRef, useSignal } from '../../lib/dom.js';
import { Canvas } from '../../lib/canvas.js';
import { applied, flat, visuals } from '../../lib/frames.js';
import { css } from '../../lib/theme.js';
import { Empty, Toggle } from '../../lib/ui.js';
import { drawLabels, written } from './labels.js';

/** Length of a frustum, m. */
const DEPTH = 0.4;

/** The calibrations of cameras, which are outputs in their images. */
export const calibrations = (description) => visuals(description, true).filter(({ info }) => info.shape === 'CameraCalibration');

/** Frames in space that outputs place: {name, matrix, above}, with the place of the frame above each; `toView(frame)` is null for one without a place. */
export function framesOf(outputs, toView) {
  const all = outputs.filter(({ info }) => info.child && info.shape === 'Pose3');
  return all.map(({ info }) => ({ name: info.child, matrix: toView(info.child), above: toView(info.frame) })).filter(({ matrix }) => matrix);
}

/** Fields of view of cameras: {matrix, corners, colour}. The middle of an image is the centre of its calibration. */
export function viewsOf(cameras, { read, toView, colour }) {
  return cameras.flatMap((camera) => flat(read(camera)).map((known) => {
    const [aside, up] = [(DEPTH * known.centre_x) / known.focal_x, (DEPTH * known.centre_y) / known.focal_y];
    return { matrix: toView(camera.info.frame), corners: [[DEPTH, aside, up], [DEPTH, -aside, up], [DEPTH, -aside, -up], [DEPTH, aside, -up]], colour: colour(camera.component) };
  })).filter(({ matrix }) => matrix);
}

const hasWebGl = () => Boolean(document.createElement('canvas').getContext('webgl2'));

/**
 * The scene: `content()` gives what `Space.draw` draws, `overlay(context, width, height, ...legend)` draws the legend above it. `ground` takes how a
 * point of the element is turned into one of the ground.
 */
export function Space({ content, overlay, reads, visible, ground, flatten, ...handlers }) {
  const space = useRef(null);
  const canvas = useRef(null);
  const schedule = useRef(() => {});
  const state = useSignal('loading');
  const follows = useSignal(true);
  useEffect(() => () => space.current?.dispose(), []);
  const ready = async (element, redraw) => {
    schedule.current = redraw;
    if (!hasWebGl()) {
      state.value = 'none';
      return;
    }
    try {
      const { Space: Kind } = await import('./scene.js');
      if (!element.isConnected) return;
      space.current = new Kind(canvas.current, element, redraw);
      ground.current = (event) => space.current.at(event.offsetX, event.offsetY, element.clientWidth, element.clientHeight);
      state.value = 'shown';
    } catch ({ message }) {
      state.value = message;
    }
    redraw();
  };
  const draw = (context, width, height) => {
    if (!space.current) return;
    const all = content();
    space.current.draw(width, height, { ...all, follow: follows.value ? all.follow : null });
    const frames = all.frames.map(({ name, matrix }) => ({ text: name, colour: css('--dim'), point: applied(matrix, [0, 0, 0]) }));
    const named = [...frames, ...written(all.labels, Math.min(width, height) ** 2)].map((one) => ({ ...one, at: space.current.project(one.point, width, height) ?? [] }));
    drawLabels(context, named.filter(({ at: [x, y] }) => x >= 0 && x <= width && y >= 0 && y <= height), width, height);
    overlay(context, width, height, ...all.legend);
  };
  const look = (above) => () => {
    follows.value = false;
    space.current?.fit(above);
    schedule.current();
  };
  if (state.value !== 'loading' && state.value !== 'shown') {
    return html`<div class="fill"><${Empty} what="This browser shows nothing in three dimensions" help=${html`${state.value === 'none' ? 'WebGL 2 is missing: turn on the graphics acceleration in its settings, or use another browser.' : state.value} <button onClick=${flatten}>Show the map in 2D</button>`} /></div>`;
  }
  return html`<canvas class="fill" ref=${canvas} aria-hidden="true"></canvas>
    <${Canvas} reads=${() => { reads(); void follows.value; }} draw=${draw} visible=${visible} label="Scene in three dimensions" onReady=${ready} ...${handlers} />
    <div class="views" role="group" aria-label="View of the scene"><${Toggle} on=${follows.value} label="Follow" title="The camera moves with the robot; drag to turn around it" onChange=${(on) => { follows.value = on; }} />
      <button onClick=${look(false)}>All</button><button onClick=${look(true)}>Top</button></div>`;
}
