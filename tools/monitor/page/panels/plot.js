// Curves of outputs over time. Rows of a component tab are dropped here, or chosen by name.

import uPlot from '../vendor/uplot.js';
import { effect, html, useEffect, useRef, useSignal } from '../lib/dom.js';
import { resolved, valueNow } from '../lib/curves.js';
import { minus } from '../lib/expression.js';
import { exact, number, numbers, text, ticks, time, valueAt } from '../lib/format.js';
import { line } from '../lib/canvas.js';
import { on } from '../lib/listen.js';
import { marks, shownTime, showRange } from '../lib/axis.js';
import { curvesOf, faultOf, readVersions, samplesAt, titleOf, useCurves } from '../lib/series.js';
import { cursor, newest, range, seek, session, visibleRange } from '../lib/store.js';
import { besideColour, css, curveColour, theme } from '../lib/theme.js';
import { choose, span, statistics } from '../lib/span.js';
import { Bar, Empty, download } from '../lib/ui.js';
import { open } from '../lib/dock.js';
import { draft, findings, threshold, watches } from '../lib/watches.js';

/** Shortest time between two drawings of a live plot, ms. */
const FRAME_MS = 30;
/** Lines of other sessions. */
const DASHES = [[6, 4], [2, 3], [9, 3, 2, 3], [12, 6]];

export function Plot({ visible, params, remember }) {
  const names = useSignal(params.curves ?? []);
  const shown = session.value;
  const description = shown?.description.value;
  const typed = useSignal('');
  const fault = useSignal('');
  const over = useSignal(false);
  // Those of other sessions are dashed.
  const { own, beside, key } = curvesOf(shown, names.value);
  const curves = [...own, ...beside];
  const set = (list) => {
    names.value = list;
    remember({ curves: list });
  };
  const add = (name) => {
    const fault = faultOf(shown, name);
    if (!fault && !names.value.includes(name)) set([...names.value, name]);
    return fault;
  };
  // A struct becomes one curve for each of its numbers, as soon as a value of it is known.
  useEffect(() => effect(() => {
    const all = own.flatMap((curve) => expand(shown, curve));
    if (all.length > own.length) setTimeout(() => set([...new Set(all)]));
  }), [shown, description, names.value.join()]);
  useCurves(curves, shown, visible, key);

  if (!description) return html`<${Empty} what="Nothing to plot yet" help="Open a world, a robot or a recording." />`;
  const drop = (event) => {
    event.preventDefault();
    over.value = false;
    const name = event.dataTransfer.getData('application/x-jmanager-curve');
    if (name) add(name);
  };
  const submit = (event) => {
    event.preventDefault();
    fault.value = typed.value.trim() && add(typed.value.trim());
    if (!fault.value) typed.value = '';
  };
  const all = description.components.flatMap((component) => component.info.map((info) => `${component.name}.${info.name}`));
  return html`<div class=${`plot ${over.value ? 'over' : ''}`} onDragOver=${(event) => { event.preventDefault(); over.value = true; }} onDragLeave=${() => { over.value = false; }} onDrop=${drop}>
    <${Bar} label="Plot">
      <form class="join" onSubmit=${submit}><input list="all-outputs" placeholder="Output or f(x)…" aria-label="Output to plot" aria-invalid=${fault.value !== ''} title=${fault.value} value=${typed.value} onInput=${(event) => { [typed.value, fault.value] = [event.target.value, '']; }} /><button>Add</button></form>
      <datalist id="all-outputs">${all.map((name) => html`<option value=${name}></option>`)}</datalist>
      <button disabled=${curves.length === 0} onClick=${() => csv(curves)}>CSV</button>
      ${shown.info.value.kind !== 'recording' && range.value.end !== null && html`<button class="live" onClick=${() => seek(null)}>Live</button>`}
      <div class="legend" role="list" aria-label="Curves">${names.value.map((name, index) => html`<${Curve} key=${name} ...${{ name, index, shown, beside: beside.filter((one) => one.name === name), remove: () => set(names.value.filter((one) => one !== name)) }} />`)}</div>
    <//>
    ${curves.length === 0
      ? html`<${Empty} what=${names.value.length > 0 ? 'This tree has none of these curves' : 'No curve yet'} help="Drag an output from a component tab onto this panel, or choose one above." />`
      : html`<${Chart} key=${key + theme.value} ...${{ curves, visible }} />`}
    ${span.value && curves.length > 0 && html`<${Statistics} ...${{ curves, visible }} />`}
  </div>`;
}

/** Names of the curves of a value: of a struct, one for each of its numbers. */
function expand(shown, { name, place, path }) {
  if (!place) return [name];
  const output = shown.output(...place);
  void output.version.value;
  const value = valueAt(output.now.value?.value ?? output.values.findLast((one) => one !== null), path);
  const parts = value !== null && typeof value === 'object' ? numbers(value) : [];
  return parts.length > 0 ? parts.slice(0, 6).map(([one]) => name + one) : [name];
}

function Curve({ name, index, shown, beside, remove }) {
  const curve = resolved(shown, name);
  const now = curve?.place ? shown.output(...curve.place).now.value?.value : null;
  const watch = () => {
    draft.value = `${name} > ${number((curve && valueNow(shown, curve)) ?? 0)} for 1 s`;
    open('watches');
  };
  return html`<span class="curve" role="listitem"><i class="dot" ref=${(dot) => { if (dot) dot.style.background = curveColour(index); }}></i>${name}
    <b>${curve ? number(valueNow(shown, curve) ?? (curve.place ? text(valueAt(now, curve.path)) : null)) : '–'}</b> <span class="unit">${curve?.unit?.includes(',') ? '' : curve?.unit ?? ''}</span>
    ${beside.map((other) => html`<b title=${other.of.title} ref=${(one) => { if (one) one.style.color = besideColour(other.beside); }}>${number(valueNow(other.of, other))}</b>`)}<button aria-label=${`Watch ${name}`} title="Watch this curve" onClick=${watch}>▲</button><button aria-label=${`Remove ${name}`} onClick=${remove}>×</button></span>`;
}

/** Times, s, and values of curves in an interval, with some more at both ends. */
function dataOf(curves, [from, until], margin = 1e6) {
  const times = new Set();
  const columns = curves.map((curve) => samplesAt(curve, [from - margin, until + margin]));
  for (const column of columns) for (const at of column.keys()) times.add(at);
  // No curve is drawn through a time in which nothing was received.
  for (const [begin, end] of curves[0].of.info.value.gaps) {
    if (end < from || begin > until) continue;
    times.add((begin + end) / 2);
    for (const column of columns) column.set((begin + end) / 2, null);
  }
  const sorted = Float64Array.from(times).sort();
  // A gap lasts until the next value, also where other curves have samples.
  const filled = (column) => {
    let last;
    return Array.from(sorted, (at) => {
      if (column.has(at)) last = column.get(at);
      return column.has(at) || last === null ? last : undefined;
    });
  };
  return [Array.from(sorted, (at) => at / 1e6), ...columns.map(filled)];
}

/** What is subtracted of the values of an axis, so that values that differ little beside their size remain apart: a round number, mostly 0. */
export function baseOf(columns) {
  let [low, high] = [null, null];
  for (const value of columns.flat()) {
    if (value === null || value === undefined) continue;
    if (low === null || value < low) low = value;
    if (high === null || value > high) high = value;
  }
  const span = Math.abs(Number(minus(high ?? 0, low ?? 0)));
  const isBig = [low, high].some((one) => typeof one === 'bigint');
  if (low === null || (!isBig && (span === 0 || Math.abs(low) < 1e4 * span))) return 0;
  const step = 10 ** Math.ceil(Math.log10(span || 1));
  if (!isBig) return Math.floor(low / step) * step;
  return BigInt(step) > (low < 0 ? -BigInt(low) : BigInt(low)) ? 0 : BigInt(low) - (BigInt(low) % BigInt(step));
}

/** The bases of the axes of curves, by their scales; 0 of one without values. */
function basesOf(curves, columns, scaleOf) {
  const groups = Map.groupBy(columns, (_, index) => scaleOf(curves[index]));
  return new Map([...groups].map(([scale, own]) => [scale, baseOf(own)]));
}

/** Curves of another unit than the first one have the axis at the right. */
const scaleIn = (curves) => ({ unit }) => (unit === curves[0].unit ? 'y' : 'right');

function Chart({ curves, visible }) {
  const box = useRef(null);
  useEffect(() => {
    const chart = new uPlot(options(box.current, curves), [[]], box.current);
    let [frame, last] = [0, 0];
    const paint = (now) => {
      frame = 0;
      if (!visible.peek() || box.current.clientWidth === 0) return;
      if (now - last < FRAME_MS) {
        frame = requestAnimationFrame(paint);
        return;
      }
      last = now;
      const interval = visibleRange.peek();
      chart.batch(() => {
        const [times, ...columns] = dataOf(curves, interval);
        chart.columns = columns;
        chart.bases = basesOf(curves, columns, scaleIn(curves));
        const less = (base) => (value) => (value === null || value === undefined ? value : Number(minus(value, base)));
        chart.setData([times, ...columns.map((column, index) => column.map(less(chart.bases.get(scaleIn(curves)(curves[index])))))], false);
        chart.setScale('x', { min: interval[0] / 1e6, max: interval[1] / 1e6 });
      });
    };
    const schedule = () => { frame ||= requestAnimationFrame(paint); };
    const stop = effect(() => {
      readVersions(curves);
      void [visibleRange.value, cursor.value, visible.value, findings.value, span.value];
      schedule();
    });
    const observer = new ResizeObserver(() => {
      chart.setSize({ width: box.current.clientWidth, height: box.current.clientHeight });
      schedule();
    });
    observer.observe(box.current);
    return () => {
      stop();
      observer.disconnect();
      cancelAnimationFrame(frame);
      chart.destroy();
    };
  }, []);
  return html`<div class="fill chart" ref=${box} role="img" aria-label=${`Plot of ${curves.map(({ name }) => name).join(', ')}`}></div>`;
}

function options(box, curves) {
  const font = `11px ${css('--font')}`;
  const grid = { stroke: css('--line'), width: 1 };
  const scaleOf = scaleIn(curves);
  const range = (chart, low, high) => (low === null ? [0, 1] : padded(low, high));
  const axis = (scale, more) => {
    const own = curves.filter((curve) => curve.beside === undefined && scaleOf(curve) === scale);
    const colour = own.length === 1 ? curveColour(own[0].colour) : css('--dim');
    return { scale, stroke: colour, grid, ticks: grid, font, size: (_, texts) => Math.max(52, 18 + 6.5 * Math.max(0, ...(texts ?? []).map((one) => one.length))), incrs, splits, values: (_, splits) => ticks(splits), ...more };
  };
  // A drag with Shift chooses a span.
  let shift = false;
  const hasRight = curves.some((curve) => scaleOf(curve) === 'right');
  return {
    width: Math.max(box.clientWidth, 50),
    height: Math.max(box.clientHeight, 50),
    legend: { show: false },
    scales: { x: { time: false, auto: false }, y: { range }, ...(hasRight && { right: { range } }) },
    series: [{}, ...curves.map((curve) => ({ label: curve.name, scale: scaleOf(curve), stroke: curveColour(curve.colour), dash: DASHES[curve.beside % DASHES.length], width: 1.5, paths: held, points: { show: false } }))],
    axes: [
      { stroke: css('--dim'), grid, ticks: grid, font, size: 26, splits: (chart) => marks(chart.scales.x.min * 1e6, chart.scales.x.max * 1e6, chart.width).times.map((at) => at / 1e6), values: (chart, splits) => {
        const { digits } = marks(chart.scales.x.min * 1e6, chart.scales.x.max * 1e6, chart.width);
        return splits.map((at) => time(at * 1e6, digits));
      } },
      axis('y'),
      ...(hasRight ? [axis('right', { side: 1, grid: { show: false } })] : []),
    ],
    cursor: { drag: { x: true, y: false, setScale: false }, points: { size: 6 } },
    hooks: {
      setSelect: [(chart) => {
        const { left, width } = chart.select;
        if (width > 3) (shift ? choose : showRange)(chart.posToVal(left, 'x') * 1e6, chart.posToVal(left + width, 'x') * 1e6);
        chart.setSelect({ left: 0, width: 0, top: 0, height: 0 }, false);
      }],
      ready: [(chart) => on(chart.over, {
        mousedown: (event) => { shift = event.shiftKey; },
        click: () => chart.cursor.left >= 0 && seek(chart.posToVal(chart.cursor.left, 'x') * 1e6),
      })],
      draw: [(chart) => {
        const { ctx, bbox } = chart;
        const x = Math.round(chart.valToPos(shownTime.peek() / 1e6, 'x', true));
        if (x >= bbox.left && x <= bbox.left + bbox.width) {
          ctx.fillStyle = css('--cursor');
          ctx.fillRect(x, bbox.top, Math.max(1, devicePixelRatio), bbox.height);
        }
        drawSpan(chart);
        drawBases(chart);
        drawThresholds(chart, curves);
        drawValues(chart, curves);
      }],
      setCursor: [(chart) => chart.redraw(false, false)],
    },
  };
}

/** A value holds until the next one. */
const held = uPlot.paths.stepped({ align: 1, alignGaps: 1 });

/** Steps between marks of an axis that suit any interval. */
const incrs = (chart, axis, min, max) => [-2, -1, 0].flatMap((power) => [1, 2, 2.5, 5].map((factor) => factor * 10 ** (Math.floor(Math.log10(max - min)) + power)));
const splits = (chart, axis, min, max, step) => (step > 0 ? Array.from({ length: Math.floor(max / step) - Math.ceil(min / step) + 1 }, (_, index) => (Math.ceil(min / step) + index) * step) : []);

/** The interval of an axis: it has a length, also around equal and around very large values. */
function padded(low, high) {
  const margin = high > low ? Math.min(high - low, 1e307) * 0.08 : Math.abs(low) * 0.1 || 0.5;
  return [Math.max(low - margin, -8e307), Math.min(high + margin, 8e307)];
}

/** What must be added to the numbers of an axis. */
function drawBases({ ctx, bbox, bases = new Map() }) {
  const scale = devicePixelRatio;
  [ctx.font, ctx.textBaseline, ctx.fillStyle] = [`${11 * scale}px ${css('--font')}`, 'top', css('--dim')];
  for (const [axis, base] of bases) {
    ctx.textAlign = axis === 'y' ? 'left' : 'right';
    if (base) ctx.fillText(`+ ${typeof base === 'bigint' ? base : exact(Number(base.toPrecision(15)))}`, axis === 'y' ? bbox.left + 4 * scale : bbox.left + bbox.width - 4 * scale, bbox.top + 2 * scale);
  }
}

function drawSpan({ ctx, bbox, valToPos }) {
  if (!span.peek()) return;
  const [left, right] = span.peek().map((at) => Math.min(Math.max(valToPos(at / 1e6, 'x', true), bbox.left), bbox.left + bbox.width));
  ctx.fillStyle = css('--selection');
  ctx.fillRect(left, bbox.top, right - left, bbox.height);
}

/** What is measured of the curves in the span. */
function Statistics({ curves, visible }) {
  if (!visible.value) return null;
  readVersions(curves);
  const rows = curves.map((curve) => [curve, statistics(samplesAt(curve, [0, span.value[1]]), span.value)]);
  return html`<table class="stats" aria-label="Statistics of the span"><thead><tr><th>${time(span.value[0])} – ${time(span.value[1])}</th>${['least', 'largest', 'mean', 'deviation', 'change'].map((name) => html`<th class="n">${name}</th>`)}</tr></thead>
    <tbody>${rows.map(([curve, found]) => html`<tr><td><i class="dot" ref=${(dot) => { if (dot) dot.style.background = curveColour(curve.colour); }}></i>${titleOf(curve)}</td>${['min', 'max', 'mean', 'deviation', 'change'].map((part) => html`<td class="n">${found ? number(found[part]) : '–'}</td>`)}</tr>`)}</tbody></table>`;
}

/** The limits of watches of these curves, the times in which they hold, and the moments at which they fired. */
function drawThresholds(chart, curves) {
  const { ctx, bbox } = chart;
  const scale = devicePixelRatio;
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  [ctx.font, ctx.textBaseline, ctx.textAlign, ctx.lineWidth] = [`${11 * scale}px ${css('--font')}`, 'bottom', 'left', scale];
  for (const { text } of watches.peek()) {
    const limit = threshold(text);
    const index = curves.findIndex(({ name }) => name === limit?.name);
    if (index < 0) continue;
    const { scale: axis } = chart.series[index + 1];
    const y = chart.valToPos(Number(minus(limit.limit, chart.bases?.get(axis) ?? 0)), axis, true);
    const { spans = [], fired = [] } = findings.peek().get(text) ?? {};
    const x = (at) => chart.valToPos((at ?? newest.peek()) / 1e6, 'x', true);
    [ctx.fillStyle, ctx.strokeStyle] = [css('--attn'), css('--attn')];
    ctx.globalAlpha = 0.14;
    for (const [begin, end] of spans) ctx.fillRect(x(begin), bbox.top, x(end) - x(begin), bbox.height);
    ctx.globalAlpha = 1;
    ctx.setLineDash([5 * scale, 4 * scale]);
    line(ctx, bbox.left, y, bbox.left + bbox.width, y);
    ctx.setLineDash([]);
    for (const at of fired) {
      ctx.beginPath();
      for (const [dx, dy] of [[0, -2], [6, -12], [-6, -12]]) ctx.lineTo(x(at) + dx * scale, y + dy * scale);
      ctx.fill();
    }
    ctx.fillText(text, bbox.left + 6 * scale, y - 2 * scale);
  }
  ctx.restore();
}

/** Values under the pointer, in the corner. */
function drawValues(chart, curves) {
  const { idx, left } = chart.cursor;
  if (idx === null || idx === undefined || left < 0) return;
  const { ctx, bbox } = chart;
  const scale = devicePixelRatio;
  const lines = [time(chart.data[0][idx] * 1e6, 3), ...curves.map((curve, index) => `${titleOf({ ...curve, name: curve.place ? curve.name.split('.').slice(1).join('.') : curve.name })} ${number(nearest(chart.columns[index], idx))}`)];
  ctx.save();
  ctx.font = `${11 * scale}px ${css('--font')}`;
  const width = Math.max(...lines.map((line) => ctx.measureText(line).width)) + 16 * scale;
  const x = bbox.left + bbox.width - width - 4 * scale;
  ctx.fillStyle = css('--tip');
  ctx.fillRect(x, bbox.top + 4 * scale, width, (lines.length * 16 + 8) * scale);
  ctx.textAlign = 'left';
  ctx.textBaseline = 'top';
  lines.forEach((line, index) => {
    ctx.fillStyle = index === 0 ? css('--dim') : curveColour(curves[index - 1].colour);
    ctx.fillText(line, x + 8 * scale, bbox.top + (8 + index * 16) * scale);
  });
  ctx.restore();
}

/** The last sample that is not later: curves have different rates. */
function nearest(column, index) {
  return column.slice(0, index + 1).findLast((value) => value !== undefined) ?? null;
}

function csv(curves) {
  const [times, ...columns] = dataOf(curves, span.value ?? [-Infinity, Infinity], 0);
  const lines = [['time_s', ...curves.map((curve) => [titleOf(curve), curve.unit]).map(([name, unit]) => `${name.replaceAll(',', ';')}${unit ? ` (${unit.replaceAll(',', ';')})` : ''}`)].join(',')];
  times.forEach((at, row) => lines.push([at, ...columns.map((column) => column[row] ?? '')].join(',')));
  download('plot.csv', new Blob([lines.join('\n')], { type: 'text/csv' }));
}
