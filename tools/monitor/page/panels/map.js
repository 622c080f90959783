// The map: the scenery and true state of a world, and all outputs that have a place, in one frame.

import { html, useEffect, useMemo, useRef, useSignal } from '../lib/dom.js';
import { Canvas } from '../lib/canvas.js';
import { number, words } from '../lib/format.js';
import { IDENTITY, applied, colourOf, headingOf, inverse, matrixOf, times, visuals } from '../lib/frames.js';
import { groupsOf, labelOf, shownText, useLabels } from '../lib/group.js';
import { drawPart, pointsOf } from '../lib/shapes.js';
import { companions, cursor, session, watch } from '../lib/store.js';
import { besideColour, css, curveColour } from '../lib/theme.js';
import { Bar, Empty, Menu, Toggle } from '../lib/ui.js';
import { ActionsMenu, onGround, useActions } from './actions.js';
import { keyOf, layersOf, sourceOf, toViewBeside, toViewOf, useTracks } from './map/layers.js';
import { useBody } from './map/body.js';
import { drawLabels, written } from './map/labels.js';
import { drawLegend } from './map/legend.js';
import { useDrag } from './map/place.js';
import { Space, calibrations, framesOf, viewsOf } from './map/space.js';

const TRAIL = 400;
/** Distance around everything that is drawn, m, without a scenery. */
const MARGIN = 1;

/** Whether the map has something to draw. */
export const hasMap = (shown) => Boolean(shown?.description.value) && (shown.info.value.can.truth || shown.scenery.value.length > 0 || visuals(shown.description.value, false).length > 0);

/**
 * `params`: whether it is `deep`; and of robots of a group the outputs that are `shown` at first, of which the first one is their place, a `label`
 * (lib/group.js), a `short` one for a map with little room, and the output that names the `group`, which has a colour.
 */
export function GroundMap({ visible, params, remember }) {
  const { shown: first, group, label, short = label } = params;
  const shown = session.value;
  const description = shown?.description.value;
  const own = useMemo(() => description && { ...sourceOf(shown), shift: 0 }, [shown, description]);
  const others = useMemo(() => companions.value.map(({ of, shift, place }) => ({ ...sourceOf(of), shift, beside: place })), [companions.value]);
  const sources = useMemo(() => (own ? [own, ...others] : []), [own, others]);
  const tracks = useTracks(sources, visible);
  const cameras = useMemo(() => calibrations(description), [description]);
  const deep = useSignal(params.deep ?? false);
  const body = useBody(shown, description, visible.value && deep.value);
  useLabels(sources.map((source) => source.shown), label ? [label, short] : [], group, visible);
  const truthShown = useSignal(true);
  const sceneryShown = useSignal(true);
  const turned = useSignal(false);
  /** Outputs that are shown, or not, other than at first. */
  const changed = useSignal(new Set());
  const hidden = { has: (key) => (first ? !first.includes(key) : false) !== changed.value.has(key) };
  const fixed = useSignal(null);
  const seen = useMemo(() => newMemory(), [shown, description, fixed.value]);
  const mapIn = (width, height) => mapOf(seen.bounds ?? [-MARGIN, -MARGIN, MARGIN, MARGIN], width, height - Math.min(seen.low, height / 3), turned.value);
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
  const toDragged = useRef(null);
  const { dragged, handlers } = useDrag({ shown, mapOf: (element) => mapIn(element.clientWidth, element.clientHeight), toView: (frame) => toDragged.current(frame), visible: truthShown.value && isFixed });
  useEffect(() => {
    if (!visible.value || !own) return undefined;
    const ends = sources.map((source) => watch({
      truth: source.shown.info.value.can.truth, info: [...source.outputs, ...(deep.value && source === own ? cameras : [])].map(({ component, index }) => [component, index, 3]),
    }, source === own ? null : source.shown));
    return () => ends.forEach((end) => end());
  }, [visible.value, sources, deep.value]);

  if (!description) return html`<${Empty} what="No map yet" help="Open a world, a robot or a recording." />`;
  if (!hasMap(shown)) return html`<${Empty} what="This tree has nothing that a map can draw" help='Return a type of bica::visual from an output, and name its frame: #[output(frame = "robot")].' />`;
  const { outputs, main, read, truth } = own;
  const place = own.place();
  const frames = [...new Set([...shown.scenery.value, ...truth(), ...outputs.map(({ info }) => info)].flatMap(({ frame, child }) => (child ? [frame, child] : [frame])))];
  const colour = (component) => curveColour(colourOf(description, component));
  const root = place(shown.scenery.value[0]?.frame ?? truth()[0]?.frame ?? main).root;
  const view = frames.includes(fixed.value) ? fixed.value : root;
  toDragged.current = (frame) => toViewOf(own.place(), view)(frame);
  /** What a point of the view is in the frame of an argument; nothing in a frame that has no place in the view. */
  geometry.current = (point) => (of) => {
    const now = own.place();
    const { matrix, root: top } = now(of.frame);
    const [x, y] = applied(times(inverse(matrix), now(view).matrix), point);
    return top === now(view).root ? { x, y }[of.axis] : undefined;
  };
  /** Where the item is that an action moves. */
  const here = ({ axis, frame }, { moves }) => truth().find((item) => item.name === moves && item.frame === frame)?.value?.[axis];
  const reads = () => {
    void [shown.scenery.value, sceneryShown.value, truthShown.value, turned.value, cursor.value, dragged.value, changed.value, tracks.value];
    cameras.forEach((output) => read(output));
    if (label) sources.forEach((source) => labelOf(source.shown, label));
    if (deep.value) void body.placed(() => null);
    for (const { shown: of, outputs: all, read: readOf, truth: stated } of sources) void [of.moment.value, stated(), all.map((output) => readOf(output))];
  };
  /** What is drawn: of other sessions, `others`, all in one colour. */
  const layers = () => {
    const now = own.place();
    const groups = group ? groupsOf(sources.map((source) => source.shown), group) : null;
    const groupOf = (source) => groups?.get(shownText(source.shown, group));
    const shows = { seen, hidden, sceneryShown: sceneryShown.value };
    const toView = toViewOf(now, view);
    const track = ({ key, pose }, toFrame, colour) => {
      const [points, matrix] = [tracks.value.get(key), pose && toFrame(pose.info.frame)];
      return points?.length > 1 && matrix ? [{ parts: [{ line: points }], matrix, style: { colour, faint: true } }] : [];
    };
    const labels = [];
    const write = (source, toFrame) => {
      const pose = source.outputs.find((output) => keyOf(output) === first?.[0]);
      const [matrix, at] = label && pose ? [toFrame(pose.info.frame), source.read(pose)] : [];
      if (matrix && at) labels.push({ full: labelOf(source.shown, label) || source.shown.title, short: labelOf(source.shown, short) || source.shown.title, colour: groupOf(source) ?? css('--dim'), point: applied(matrix, [at.x, at.y]) });
    };
    const drawn = others.map((source) => {
      const [toFrame, group] = [toViewBeside(source, now, view), groupOf(source)];
      const own = group ?? besideColour(source.beside);
      write(source, toFrame);
      // Robots of a group are in one world.
      const { found, stated } = layersOf(source, toFrame, { ...shows, truthShown: truthShown.value && !groups, own, group });
      return [...track(source, toFrame, own), ...found, ...stated];
    });
    write(own, toView);
    const ownTrack = track(own, toView, groupOf(own) ?? (own.pose ? colour(own.pose.component) : ''));
    return { toView, labels, groups, ...layersOf(own, toView, { ...shows, truthShown: truthShown.value, group: groupOf(own) }), others: [...ownTrack, ...drawn.flat()] };
  };
  const draw = (context, width, height) => {
    const { scenery, found, stated, others: beside, labels, groups } = layers();
    const all = [...scenery, ...beside, ...found, ...stated];
    seen.bounds = scenery.length > 0 ? extent(scenery, null, 0) : extent(all, seen.bounds, MARGIN);
    const map = mapIn(width, height);
    for (const trail of trails(all)) for (const part of trail.parts) drawPart(context, map, part, IDENTITY, trail.style);
    for (const { parts, matrix, style } of all) for (const part of parts) drawPart(context, map, part, matrix, style);
    if (dragged.value) drawPart(context, map, { dots: [dragged.value] }, IDENTITY, { colour: css('--truth') });
    drawLabels(context, written(labels, map.area).map(({ point: [x, y], ...rest }) => ({ ...rest, at: [map.x(x), map.y(y)] })), width, height - seen.low);
    const low = legend(context, width, height, found, stated, groups);
    // The map is above its legend. It does not move when an output is missing for a while.
    if (seen.width !== width) [seen.width, seen.low] = [width, 0];
    if (low <= seen.low) return;
    seen.low = context.canvas.dataset.legend = low;
    context.clearRect(0, 0, width, height);
    draw(context, width, height);
  };
  const legend = (context, width, height, found, stated, groups) => {
    const drawn = new Map(groups ? [...groups].map(([value, colour]) => [`${words(group.split('.').at(-1))} ${value}`, colour]) : outputs.filter((_, number) => found[number].parts.length > 0).map(({ component, name }) => [name, colour(component)]));
    if (stated.length > 0) drawn.set('truth (dashed)', css('--truth'));
    if (!groups) for (const { shown: of, beside } of others) drawn.set(of.title, besideColour(beside));
    return drawLegend(context, width, height, [...drawn]);
  };
  /** The trails of layers that have one, at the newest time, as layers. */
  const trails = (all) => (cursor.value === null ? all.flatMap(trailOf) : []);
  const content = () => {
    const { toView, scenery, found, stated, others: beside, labels, groups } = layers();
    const all = [...scenery, ...beside, ...found, ...stated];
    // A place of a frame in space is drawn as its axes.
    const isFrame = (one) => outputs[found.indexOf(one)]?.info.shape === 'Pose3';
    return {
      layers: [...all.filter((one) => !isFrame(one)), ...trails(all)], frames: framesOf(outputs, toView),
      body: body.placed(toView), views: viewsOf(cameras, { read, toView, colour }), follow: main === view ? null : toView(main),
      legend: [found, stated, groups], labels,
    };
  };
  const show = (on) => {
    deep.value = on;
    remember({ deep: on });
  };
  const toggle = (layer) => {
    const next = new Set(changed.value);
    if (!next.delete(layer)) next.add(layer);
    changed.value = next;
  };
  return html`<${Bar} label="Map">
      <span class="dim place"><${Where} ...${{ place, frame: main, root, truth: truth(), others: group ? [] : others }} /></span><span class="grow"></span>
      ${shown.info.value.can.truth && html`<${Toggle} on=${truthShown.value} label="Truth" title="The simulator's state, dashed. The robot never gets it." colour=${css('--truth')} onChange=${(on) => { truthShown.value = on; }} />`}
      <${Toggle} on=${deep.value} label="3D" title="Show the map in three dimensions" onChange=${show} />
      <${ActionsMenu} ...${{ shown, list, known: here }} />
      <${Menu} label="Layers" title="What the map shows">
        <label>Fixed frame <select aria-label="Fixed frame" onChange=${(event) => { fixed.value = event.target.value; }}>${frames.map((frame) => html`<option selected=${frame === view}>${frame}</option>`)}</select></label>
        ${outputs.map((output) => html`<${Toggle} on=${!hidden.has(keyOf(output))} label=${`${output.name} · ${words(output.info.name)}`} title=${`${output.info.doc} Frame: ${output.info.frame}.`} colour=${colour(output.component)} onChange=${() => toggle(keyOf(output))} />`)}
        ${shown.scenery.value.length > 0 && html`<${Toggle} on=${sceneryShown.value} label="Scenery" title="What does not move in the world" onChange=${(on) => { sceneryShown.value = on; }} />`}
        <${Toggle} on=${turned.value} label="Turned by 180°" title="Turn the map by 180°" onChange=${(on) => { turned.value = on; }} />
        <button class="item" onClick=${seen.clear}>Clear the trails</button><//>
    <//>
    <div class="fill field">${deep.value
      ? html`<${Space} ...${{ content, overlay: legend, reads, visible, ground, flatten: () => show(false), ...opens }} />`
      : html`<${Canvas} reads=${reads} draw=${draw} visible=${visible} label="Map of the ground" ...${{ ...handlers, ...opens }} />`}${menu}</div>`;
}

function Where({ place, frame, root, truth, others }) {
  if (frame === undefined) return '';
  const { matrix, root: own, notes } = place(frame);
  if (own !== root) return `${frame} has no place in ${root}`;
  if (frame === root) return frame;
  const stated = truth.find(({ child }) => child === frame);
  const above = stated?.value && place(stated.frame);
  const away = above?.root === root ? [`${apart(times(above.matrix, matrixOf(stated.value)), matrix)} from the truth`] : [];
  const between = others.flatMap((other) => {
    const { matrix: there, root: top } = other.place()(frame);
    return top === root ? [`${apart(there, matrix)} from ${other.shown.title}`] : [];
  });
  return [`${frame} in ${root} · ${number(matrix[3])}, ${number(matrix[7])} m · ${degrees(headingOf(matrix))}°`, ...between, ...away, ...notes].join(' · ');
}

const degrees = (angle) => Math.round((angle * 180) / Math.PI) + 0;

/** How far one place is from another one, as a text. */
const apart = (one, other) => `${number(Math.hypot(one[3] - other[3], one[7] - other[7]))} m, ${degrees(Math.abs(headingOf(times(inverse(one), other))))}°`;

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
    area: scale * (right - left) * scale * (top - bottom),
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
  return { bounds: null, width: 0, low: 0, trails: of, clear: () => trails.clear() };
}

/** Adds the place of a pose to its trail; the trail as a layer. */
function trailOf({ parts: [part], matrix, style: { colour, dash }, trail: points }) {
  if (!points || !part) return [];
  const [at] = pointsOf(part, matrix);
  if (points.length === 0 || Math.hypot(points.at(-1)[0] - at[0], points.at(-1)[1] - at[1]) > 0.01) points.push(at);
  if (points.length > TRAIL) points.shift();
  return [{ parts: [{ line: points }], matrix: IDENTITY, style: { colour, dash: dash && [2, 4], faint: true } }];
}
