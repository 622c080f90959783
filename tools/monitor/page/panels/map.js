// The map: the scenery and true state of a world, and all outputs that have a place, in one frame.

import { html, useEffect, useMemo, useRef, useSignal } from '../lib/dom.js';
import { Canvas } from '../lib/canvas.js';
import { number, words } from '../lib/format.js';
import { IDENTITY, applied, colourOf, flat, headingOf, inverse, located, matrixOf, times, visuals } from '../lib/frames.js';
import { drawPart, partsOf, pointsOf } from '../lib/shapes.js';
import { cursor, session, watch } from '../lib/store.js';
import { css, curveColour } from '../lib/theme.js';
import { Bar, Empty, Menu, Toggle } from '../lib/ui.js';
import { ActionsMenu, onGround, useActions } from './actions.js';
import { drawLegend } from './map/legend.js';
import { useDrag } from './map/place.js';
import { Space, calibrations, framesOf, toViewOf, viewsOf } from './map/space.js';

const TRAIL = 400;
/** Distance around everything that is drawn, m, without a scenery. */
const MARGIN = 1;
const DASHED = [3, 3];
const HALO = '#ffffffa0';

/** Whether the map has something to draw. */
export const hasMap = (shown) => Boolean(shown?.description.value) && (shown.info.value.can.truth || shown.scenery.value.length > 0 || visuals(shown.description.value, false).length > 0);

export function GroundMap({ visible, params, remember }) {
  const shown = session.value;
  const description = shown?.description.value;
  const outputs = useMemo(() => visuals(description, false), [description]);
  const cameras = useMemo(() => calibrations(description), [description]);
  const deep = useSignal(params.deep ?? false);
  const truthShown = useSignal(true);
  const sceneryShown = useSignal(true);
  const turned = useSignal(false);
  const hidden = useSignal(new Set());
  const fixed = useSignal(null);
  const seen = useMemo(() => newMemory(), [shown, description, fixed.value]);
  const mapIn = (width, height) => mapOf(seen.bounds ?? [-MARGIN, -MARGIN, MARGIN, MARGIN], width, height, turned.value);
  // What a world lets place is in its frame.
  const isFixed = fixed.value === null || fixed.value === shown?.scenery.value[0]?.frame;
  const geometry = useRef(null);
  const ground = useRef(null);
  const list = onGround(shown);
  const at = (event) => {
    const point = deep.value ? ground.current?.(event) : mapIn(event.currentTarget.clientWidth, event.currentTarget.clientHeight).at(event.offsetX, event.offsetY);
    return point && geometry.current?.(point);
  };
  const { handlers: opens, menu } = useActions({ shown, list, at });
  const { dragged, handlers } = useDrag({ shown, mapOf: (element) => mapIn(element.clientWidth, element.clientHeight), visible: truthShown.value && isFixed });
  useEffect(() => {
    if (!visible.value || !description) return undefined;
    return watch({ truth: shown.info.value.can.truth, info: [...outputs, ...(deep.value ? cameras : [])].map(({ component, index }) => [component, index, 3]) });
  }, [visible.value, shown, description, deep.value]);

  if (!description) return html`<${Empty} what="No map yet" help="Open a world, a robot or a recording." />`;
  if (!hasMap(shown)) return html`<${Empty} what="This tree has nothing that a map can draw" help="Return a type of bica::visual from an output, and name its frame: #[info(frame = &quot;robot&quot;)]." />`;
  const read = ({ component, index }) => shown.info_of(component, index).now.value?.value;
  const truth = () => shown.truth.value?.truth ?? [];
  const place = located(outputs, read, truth());
  const frames = [...new Set([...shown.scenery.value, ...truth(), ...outputs.map(({ info }) => info)].flatMap(({ frame, child }) => (child ? [frame, child] : [frame])))];
  const main = busiest(outputs);
  const colour = (component) => curveColour(colourOf(description, component));
  const root = place(shown.scenery.value[0]?.frame ?? truth()[0]?.frame ?? main).root;
  const view = frames.includes(fixed.value) ? fixed.value : root;
  /** What a point of the view is in the frame of an argument; nothing in a frame that has no place in the view. */
  geometry.current = (point) => (of) => {
    const now = located(outputs, read, truth());
    const { matrix, root: own } = now(of.frame);
    const [x, y] = applied(times(inverse(matrix), now(view).matrix), point);
    return own === now(view).root ? { x, y }[of.axis] : undefined;
  };
  /** Where the item is that an action moves. */
  const here = ({ axis, frame }, { moves }) => truth().find((item) => item.name === moves && item.frame === frame)?.value?.[axis];
  const reads = () => {
    void [shown.truth.value, shown.scenery.value, sceneryShown.value, truthShown.value, turned.value, cursor.value, dragged.value, hidden.value];
    [...outputs, ...cameras].forEach((output) => read(output));
  };
  /** What is drawn, the lowest first: {parts, matrix, style, trail}; nothing of a frame that has no place in the view. */
  const layers = () => {
    const now = located(outputs, read, truth());
    const toView = toViewOf(now, view);
    const layer = (frame, shape, value, style, key) => {
      const matrix = toView(frame);
      const parts = matrix ? flat(value).flatMap((one) => partsOf(shape, one)) : [];
      return { parts, matrix, style, trail: key && seen.trails(key) };
    };
    // Of the true places of frames only that of the robot is drawn.
    const states = (plain) => ({ name, frame, shape, value, child, colour, line_width: width }) => (child && child !== main ? [] : [layer(frame, shape, value,
      colour ? { colour, width, fill: width === undefined } : { ...plain, width }, shape === 'Pose2' && name)]);
    const scenery = sceneryShown.value ? shown.scenery.value.flatMap(states({ colour: css('--dim'), fill: true })) : [];
    const found = outputs.map(({ component, info, index }, number) => layer(info.frame, info.shape, hidden.value.has(number) ? null : read({ component, index }),
      { colour: colour(component), halo: HALO, faint: !shown.moment.value?.components?.[component]?.[0] }, info.child === main && info.child));
    return { toView, scenery, found, stated: truthShown.value ? truth().flatMap(states({ colour: css('--truth'), halo: css('--panel'), dash: DASHED })) : [] };
  };
  const draw = (context, width, height) => {
    const { scenery, found, stated } = layers();
    const all = [...scenery, ...found, ...stated];
    seen.bounds = scenery.length > 0 ? extent(scenery, null, 0) : extent(all, seen.bounds, MARGIN);
    const map = mapIn(width, height);
    for (const trail of trails(all)) for (const part of trail.parts) drawPart(context, map, part, IDENTITY, trail.style);
    for (const { parts, matrix, style } of all) for (const part of parts) drawPart(context, map, part, matrix, style);
    if (dragged.value) drawPart(context, map, { dots: [dragged.value] }, IDENTITY, { colour: css('--truth') });
    legend(context, width, height, found, stated);
  };
  const legend = (context, width, height, found, stated) => {
    const drawn = new Map(outputs.filter((_, number) => found[number].parts.length > 0).map(({ component, name }) => [name, colour(component)]));
    if (stated.length > 0) drawn.set('truth (dashed)', css('--truth'));
    drawLegend(context, width, height, [...drawn]);
  };
  /** The trails of layers that have one, at the newest time, as layers. */
  const trails = (all) => (cursor.value === null ? all.flatMap(trailOf) : []);
  const content = () => {
    const { toView, scenery, found, stated } = layers();
    const all = [...scenery, ...found, ...stated];
    // A place of a frame in space is drawn as its axes.
    const isFrame = (one) => outputs[found.indexOf(one)]?.info.shape === 'Pose3';
    return {
      layers: [...all.filter((one) => !isFrame(one)), ...trails(all)], frames: framesOf(outputs, toView),
      views: viewsOf(cameras, { read, toView, colour }), follow: main === view ? null : toView(main),
      legend: [found, stated],
    };
  };
  const show = (on) => {
    deep.value = on;
    remember({ deep: on });
  };
  const toggle = (layer) => {
    const next = new Set(hidden.value);
    if (!next.delete(layer)) next.add(layer);
    hidden.value = next;
  };
  return html`<${Bar} label="Map">
      <span class="dim place"><${Where} ...${{ place, frame: main, root, truth: truth() }} /></span><span class="grow"></span>
      ${shown.info.value.can.truth && html`<${Toggle} on=${truthShown.value} label="Truth" title="The simulator's state, dashed. The robot never gets it." colour=${css('--truth')} onChange=${(on) => { truthShown.value = on; }} />`}
      <${Toggle} on=${deep.value} label="3D" title="Show the map in three dimensions" onChange=${show} />
      <${ActionsMenu} ...${{ shown, list, known: here }} />
      <${Menu} label="Layers" title="What the map shows">
        <label>Fixed frame <select aria-label="Fixed frame" onChange=${(event) => { fixed.value = event.target.value; }}>${frames.map((frame) => html`<option selected=${frame === view}>${frame}</option>`)}</select></label>
        ${outputs.map(({ component, name, info }, number) => html`<${Toggle} on=${!hidden.value.has(number)} label=${`${name} · ${words(info.name)}`} title=${`${info.doc} Frame: ${info.frame}.`} colour=${colour(component)} onChange=${() => toggle(number)} />`)}
        ${shown.scenery.value.length > 0 && html`<${Toggle} on=${sceneryShown.value} label="Scenery" title="What does not move in the world" onChange=${(on) => { sceneryShown.value = on; }} />`}
        <${Toggle} on=${turned.value} label="Turned by 180°" title="Turn the map by 180°" onChange=${(on) => { turned.value = on; }} />
        <button class="item" onClick=${seen.clear}>Clear the trails</button><//>
    <//>
    <div class="fill field">${deep.value
      ? html`<${Space} ...${{ content, overlay: legend, reads, visible, ground, flatten: () => show(false), ...opens }} />`
      : html`<${Canvas} reads=${reads} draw=${draw} visible=${visible} label="Map of the ground" ...${{ ...handlers, ...opens }} />`}${menu}</div>`;
}

/** The frame in which most outputs are given: the robot's. */
function busiest(outputs) {
  const count = (frame) => outputs.filter(({ info }) => info.frame === frame).length;
  return outputs.reduce((best, { info }) => (best === undefined || count(info.frame) > count(best) ? info.frame : best), undefined);
}

function Where({ place, frame, root, truth }) {
  if (frame === undefined) return '';
  const { matrix, root: own, notes } = place(frame);
  if (own !== root) return `${frame} has no place in ${root}`;
  if (frame === root) return frame;
  const away = distanceTo(truth.find(({ child }) => child === frame), place, matrix, root);
  return [`${frame} in ${root} · ${number(matrix[3])}, ${number(matrix[7])} m · ${degrees(headingOf(matrix))}°`, ...away, ...notes].join(' · ');
}

const degrees = (angle) => ((angle * 180) / Math.PI).toFixed(0);

/** How far a place is from the true one, as a list with a text; empty if that is unknown. */
function distanceTo(stated, place, matrix, root) {
  const above = stated && place(stated.frame);
  if (!above || above.root !== root || !stated.value) return [];
  const truth = times(above.matrix, matrixOf(stated.value));
  const turn = headingOf(times(inverse(truth), matrix));
  return [`${number(Math.hypot(matrix[3] - truth[3], matrix[7] - truth[7]))} m, ${degrees(Math.abs(turn))}° from the truth`];
}

/** The extent of what is drawn, and of `known`: [left, bottom, right, top], m. */
function extent(layers, known, margin) {
  const points = layers.flatMap(({ parts, matrix }) => parts.flatMap((part) => pointsOf(part, matrix))).filter(([x, y]) => Number.isFinite(x + y));
  const all = [known, ...points.map(([x, y]) => [x - margin, y - margin, x + margin, y + margin])].filter(Boolean);
  return all.length === 0 ? null : all.reduce(([a, b, c, d], [e, f, g, h]) => [Math.min(a, e), Math.min(b, f), Math.max(c, g), Math.max(d, h)]);
}

function mapOf([left, bottom, right, top], width, height, turned) {
  const scale = Math.min((width - 8) / (right - left), (height - 8) / (top - bottom));
  const [sign, middleX, middleY] = [turned ? -1 : 1, (left + right) / 2, (bottom + top) / 2];
  return {
    scale,
    x: (x) => width / 2 + sign * (x - middleX) * scale,
    y: (y) => height / 2 - sign * (y - middleY) * scale,
    /** The position, m, of a point of the canvas. */
    at: (x, y) => [middleX + (x - width / 2) / (sign * scale), middleY + (height / 2 - y) / (sign * scale)],
    angle: (heading) => (turned ? Math.PI - heading : -heading),
  };
}

/** The extent of the map, and the trails by names. */
function newMemory() {
  const trails = new Map();
  const of = (key) => trails.get(key) ?? trails.set(key, []).get(key);
  return { bounds: null, trails: of, clear: () => trails.clear() };
}

/** Adds the place of a pose to its trail; the trail as a layer. */
function trailOf({ parts: [part], matrix, style: { colour, dash }, trail: points }) {
  if (!points || !part) return [];
  const [at] = pointsOf(part, matrix);
  if (points.length === 0 || Math.hypot(points.at(-1)[0] - at[0], points.at(-1)[1] - at[1]) > 0.01) points.push(at);
  if (points.length > TRAIL) points.shift();
  return [{ parts: [{ line: points }], matrix: IDENTITY, style: { colour, dash: dash && [2, 4], faint: true } }];
}
