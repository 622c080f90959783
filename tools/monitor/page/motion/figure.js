// The chosen keyframe in space: limbs, soles, centre of mass, and handles that turn the joints.

import { Canvas, line } from '../lib/canvas.js';
import { html, useEffect, useRef, useSignal } from '../lib/dom.js';
import { IDENTITY, applied } from '../lib/frames.js';
import { css, curveColour } from '../lib/theme.js';
import { course, handlesOf, kept, moved, near, valueNear, wayOf } from './handles.js';
import { channel, draft, form, held, keys, row, rounded, setValue, shapes } from './model.js';

/** Directions of views: to where it looks, seen from above, and how far down, rad. */
const VIEWS = [['Oblique', [2.4, 0.25]], ['Right', [Math.PI / 2, 0]], ['Behind', [0, 0]], ['Above', [0, Math.PI / 2]]];
/** Turn by a drag of a pixel, rad. */
const TURN = 0.01;
/** Height of the buttons above the figure, px. */
const BUTTONS = 36;
/** Widths of trunk and limbs as shares of the figure’s radius. */
const [TRUNK, LIMB] = [0.13, 0.07];

/** A view of all keyframes: `to` projects a point to the canvas, with its distance as the third number. */
function viewOf([heading, down], width, height) {
  const points = shapes.value.flatMap(({ shape }) => [...shape.lines.flat(), ...shape.soles.flat()]);
  const [low, high] = [Math.min, Math.max].map((of) => [0, 1, 2].map((axis) => of(...points.map((point) => point[axis]))));
  const middle = low.map((value, axis) => (value + high[axis]) / 2);
  const radius = Math.max(...points.map((point) => Math.hypot(...point.map((value, axis) => value - middle[axis]))));
  const scale = (0.47 * Math.min(width, height - BUTTONS)) / radius;
  const [sin, cos, sinDown, cosDown] = [Math.sin(heading), Math.cos(heading), Math.sin(down), Math.cos(down)];
  const to = (point) => {
    const [x, y, z] = point.map((value, axis) => value - middle[axis]);
    const ahead = x * cos + y * sin;
    return [width / 2 + (x * sin - y * cos) * scale, (height + BUTTONS) / 2 - (ahead * sinDown + z * cosDown) * scale, ahead * cosDown - z * sinDown];
  };
  return { to, scale, radius };
}

/** Limbs as round lines, the farthest first. */
function drawBody(context, { to, scale, radius }, { lines, soles, centre, margin }) {
  const stroke = (points, colour, width) => {
    [context.strokeStyle, context.lineWidth] = [colour, width];
    context.beginPath();
    points.forEach(([x, y]) => context.lineTo(x, y));
    context.stroke();
  };
  context.lineCap = context.lineJoin = 'round';
  for (const sole of soles) stroke([...sole, sole[0]].map(to), css('--perceive'), 1.6);
  // Trunk, then arm and leg of the left, then of the right side.
  const limbs = lines.flatMap((points, index) => points.slice(1).map((point, at) => ({ ends: [points[at], point].map(to), index })));
  for (const { ends, index } of limbs.sort((a, b) => b.ends[0][2] + b.ends[1][2] - a.ends[0][2] - a.ends[1][2])) {
    const width = (index === 0 ? TRUNK : LIMB) * radius * scale;
    stroke(ends, css('--panel'), width + 3);
    stroke(ends, css(index === 0 ? '--dim' : index < 3 ? '--control' : '--machine'), width);
  }
  const [[x, y], below] = [to(centre), to([centre[0], centre[1], 0])];
  context.fillStyle = context.strokeStyle = css(margin > 0 ? '--ok' : '--error');
  context.lineWidth = 1;
  context.setLineDash([3, 3]);
  line(context, x, y, below[0], below[1]);
  context.setLineDash([]);
  context.beginPath();
  context.arc(x, y, 4, 0, 2 * Math.PI);
  context.fill();
}

/** The ways of a handle in the colours of their curves, and the names and values of their numbers beside it. */
function drawWays(context, { ways, points, at, values }, width, height) {
  points.forEach((list, index) => {
    [context.strokeStyle, context.lineWidth] = [curveColour(ways[index].channel), 2.5];
    context.beginPath();
    list.forEach(([, x, y]) => context.lineTo(x, y));
    context.stroke();
  });
  const texts = ways.map(({ channel: of }) => `${form.value.channels[of].name} ${values[of].toFixed(form.value.channels[of].step >= 1 ? 0 : form.value.channels[of].step >= 0.1 ? 1 : 3)}${form.value.channels[of].unit === '°' ? '°' : ` ${form.value.channels[of].unit}`}`);
  const wide = Math.max(...texts.map((text) => context.measureText(text).width)) + 22;
  const [left, top] = [Math.min(at[0] + 14, width - wide - 2), Math.max(2, Math.min(at[1] - 8 * texts.length, height - 16 * texts.length - 2))];
  context.fillStyle = css('--shade');
  context.fillRect(left, top, wide, 16 * texts.length);
  texts.forEach((text, index) => {
    context.fillStyle = curveColour(ways[index].channel);
    context.fillRect(left + 5, top + 16 * index + 4, 8, 8);
    context.fillStyle = css('--shade-text');
    context.fillText(text, left + 17, top + 16 * index + 12);
  });
}

function drawHandles(context, handles, to, radius = 5) {
  for (const { at } of handles) {
    const [x, y] = to(at);
    context.beginPath();
    context.arc(x, y, radius, 0, 2 * Math.PI);
    context.fillStyle = css('--panel');
    context.fill();
    [context.strokeStyle, context.lineWidth] = [css('--text'), 2];
    context.stroke();
  }
}

export function Figure({ visible }) {
  const direction = useSignal(VIEWS[0][1]);
  const pointed = useSignal(null);
  // What is dragged: a handle as it was at the press, or the view.
  const drag = useRef(null);
  const view = (canvas) => drag.current?.view ?? viewOf(direction.value, canvas.clientWidth, canvas.clientHeight);
  const handles = () => (held.value || !shapes.value[row.value] ? [] : handlesOf(shapes.value[row.value]));
  const valuesNow = () => keys.value[row.value].values;
  const draw = (context, width, height) => {
    const now = shapes.value[row.value];
    if (!now || !keys.value?.[row.value]) return;
    context.font = `11px ${css('--font')}`;
    const [seen, { handle, way, value, anchor } = {}] = [view(context.canvas), drag.current ?? {}];
    // What the handles are attached to stays where it is while one is dragged.
    const stays = handle ? kept(anchor, now.anchor) : IDENTITY;
    const [place, all] = [(points) => points.map((point) => applied(stays, point)), handles().map((one) => ({ ...one, at: applied(stays, one.at) }))];
    drawBody(context, seen, { ...now.shape, lines: now.shape.lines.map(place), soles: now.shape.soles.map(place), centre: applied(stays, now.shape.centre) });
    context.canvas.dataset.handles = JSON.stringify(all.map(({ at, ways }) => ({ at: seen.to(at).slice(0, 2), names: ways.map(({ channel: of }) => form.value.channels[of].name) })));
    const chosen = handle ?? (pointed.value && near(all, seen.to, pointed.value));
    const ways = way ? [way] : chosen?.ways ?? [];
    const points = ways.map((one) => course(chosen.at, one, form.value.channels[one.channel], value?.[one.channel] ?? valuesNow()[one.channel], seen.to));
    drawHandles(context, handle ? [] : all, seen.to);
    if (!chosen) return;
    const at = way ? moved({ at: chosen.at, way }, valuesNow()[way.channel] - value[way.channel]) : chosen.at;
    drawWays(context, { ways, points, at: seen.to(at), values: valuesNow() }, width, height);
    drawHandles(context, [{ at }], seen.to, 7);
  };
  const leaveDrag = () => {
    drag.current = null;
    window.removeEventListener('keydown', escape, true);
  };
  const end = () => {
    leaveDrag();
    draft.value = null;
  };
  const escape = useRef((event) => {
    if (event.key !== 'Escape') return;
    event.stopPropagation();
    end();
  }).current;
  useEffect(() => leaveDrag, []);
  const down = (event) => {
    if (event.button !== 0 || drag.current || !shapes.value[row.value]) return;
    event.target.setPointerCapture(event.pointerId);
    const from = [event.offsetX, event.offsetY];
    const seen = view(event.target);
    const handle = near(handles(), seen.to, from);
    drag.current = handle ? { from, handle, view: seen, value: valuesNow(), anchor: shapes.value[row.value].anchor, row: row.value } : { from, direction: direction.value };
    window.addEventListener('keydown', escape, true);
  };
  const move = (event) => {
    const at = [event.offsetX, event.offsetY];
    const { from, handle, value, view: seen, direction: before, row: of } = drag.current ?? {};
    if (!drag.current) {
      pointed.value = at;
      event.target.style.cursor = near(handles(), view(event.target).to, at) ? 'grab' : '';
    } else if (!handle) {
      direction.value = [before[0] - (at[0] - from[0]) * TURN, Math.min(Math.PI / 2, Math.max(-Math.PI / 2, before[1] + (at[1] - from[1]) * TURN))];
    } else {
      const by = [at[0] - from[0], at[1] - from[1]];
      const way = (drag.current.way ??= wayOf(handle, seen.to, by));
      if (!way) return;
      channel.value = way.channel;
      const own = form.value.channels[way.channel];
      const [x, y] = seen.to(handle.at);
      const points = course(handle.at, way, own, value[way.channel], seen.to);
      draft.value = { row: of, channel: way.channel, value: rounded(valueNear(points, draft.value?.value ?? value[way.channel], [x + by[0], y + by[1]]), own) };
    }
  };
  const up = async () => {
    const wanted = drag.current?.way && draft.value;
    leaveDrag();
    if (!wanted) return;
    await setValue(wanted.row, wanted.channel, wanted.value);
    if (draft.value === wanted) draft.value = null;
  };
  const leave = () => { if (!drag.current) pointed.value = null; };
  const now = shapes.value[row.value]?.shape;
  const margin = now && Number.isFinite(now.margin) ? `${Math.abs(now.margin * 1000).toFixed(0)} mm ${now.margin > 0 ? 'within' : 'beyond'} the edge of the soles on the ground` : 'no sole on the ground';
  const loads = (now?.load ?? []).toSorted((a, b) => b[1] - a[1]).slice(0, 3).map(([joint, load]) => `${joint} ${(load * 100).toFixed(0)} %`);
  const reads = () => { void [shapes.value, row.value, keys.value, form.value, held.value, pointed.value, direction.value]; };
  return html`<figure class="figure"><div class="space"><${Canvas} reads=${reads} draw=${draw} visible=${visible} label="Posture of the keyframe" onPointerDown=${down} onPointerMove=${move} onPointerUp=${up} onPointerCancel=${end} onPointerLeave=${leave} />
      <div class="views" role="group" aria-label="View of the posture">${VIEWS.map(([name, of]) => html`<button aria-pressed=${direction.value === of} class=${direction.value === of ? 'on' : ''} onClick=${() => { direction.value = of; }}>${name}</button>`)}</div></div>
    <figcaption><b class="left">left</b> and <b class="right">right</b> limbs · ● centre of mass: ${now ? margin : ''}${loads.length > 0 && html`<br /><span title="Current that holds the posture at rest, as a share of what the motor bears continuously">load at rest: ${loads.join(', ')}</span>`}</figcaption></figure>`;
}
