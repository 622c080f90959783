// The map in three dimensions: frames, what cameras see, and the views. The library is loaded when it is needed first.

import { html, useEffect, useRef, useSignal } from '../../lib/dom.js';
import { Canvas } from '../../lib/canvas.js';
import { applied, flat, visuals } from '../../lib/frames.js';
import { css } from '../../lib/theme.js';
import { Empty, Toggle } from '../../lib/ui.js';

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

/** Writes names at points of the canvas; one that would cover another is left out. */
function drawNames(context, names) {
  context.font = `11px ${css('--font')}`;
  context.textBaseline = 'middle';
  const taken = [];
  for (const [name, at] of names.toReversed()) {
    if (!at || taken.some(([x, y]) => Math.abs(x - at[0]) < 60 && Math.abs(y - at[1]) < 16)) continue;
    taken.push(at);
    context.fillStyle = css('--shade');
    context.fillRect(at[0] + 5, at[1] - 8, context.measureText(name).width + 6, 16);
    context.fillStyle = css('--shade-text');
    context.fillText(name, at[0] + 8, at[1]);
  }
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
    const named = [...all.frames.map(({ name, matrix }) => [name, applied(matrix, [0, 0, 0])]), ...all.labels.map(({ text, point }) => [text, point])];
    drawNames(context, named.map(([name, point]) => [name, space.current.project(point, width, height)]));
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
