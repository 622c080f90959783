// Outputs and expressions that a panel shows by name: of the chosen session, and of those beside it at the same times.

import { effect, useEffect } from './dom.js';
import { request } from './connection.js';
import { resolve, resolved, samples } from './curves.js';
import { companions, notify, range, visibleRange, watch } from './store.js';

/** Samples that are read of the time before a name was added. */
const POINTS = 3000;

/** The curves of names: those of the chosen session, then those of others; each with its session `of`, `shift`, `colour` and, of another one, `beside`. */
export function curvesOf(shown, names) {
  const of = (one, more) => names.flatMap((name, colour) => {
    const curve = resolved(one, name);
    return curve ? [{ ...curve, of: one, colour, ...more }] : [];
  });
  const own = of(shown, { shift: 0 });
  const beside = own.length === 0 ? [] : companions.value.flatMap(({ of: other, shift, place }) => of(other, { shift, beside: place }));
  return { own, beside, key: [...own, ...beside].map((curve) => `${curve.name} ${curve.of.id} ${curve.shift}`).join() };
}

/** A curve's name, with its session if that is not the chosen one. */
export const titleOf = ({ name, of, beside }) => (beside === undefined ? name : `${name} · ${of.title}`);

/** Reads the signals that change with the samples of curves. */
export function readVersions(curves) {
  for (const { of, inputs } of curves) for (const { place } of inputs) void of.output(...place).version.value;
}

/** Samples of a curve at the times of the chosen session. */
export function samplesAt(curve, [from, until]) {
  const { of, shift } = curve;
  const found = samples(of, curve, [from + shift, until + shift]);
  return shift === 0 ? found : new Map([...found].map(([at, value]) => [at - shift, value]));
}

/** What is wrong with a text that should name a curve; empty if it does. It becomes a notice. */
export function faultOf(shown, name) {
  try {
    resolve(shown, name);
    return '';
  } catch ({ message }) {
    notify('error', message, 'write Component.output, as in the list of the field, or an expression such as hypot(A.x, A.y) or rate(A.x)');
    return message;
  }
}

/** Reads when components were active within an interval. */
async function readActivity(of, curves, [from, until]) {
  try {
    const rows = await request('timeline', { session: of.id, from_us: from, until_us: until, resolution_us: Math.round((until - from) / POINTS) });
    // What goes on at the end of the interval has not ended: the root does.
    const last = Math.max(...rows.flatMap(({ bars }) => bars.map(([, end]) => end)));
    for (const { component, bars } of rows) {
      const ends = bars.filter(([, end], index) => end < last && bars[index + 1]?.[0] !== end).map(([, end]) => end);
      of.activityOf(component).add(bars[0]?.[0] === from ? ends : [from, ...ends], bars.map(([begin]) => begin));
    }
    for (const { place } of curves.flatMap(({ inputs }) => inputs)) of.output(...place).version.value += 1;
  } catch {
    // Samples are shown without it.
  }
}

/** Watches curves, and reads their samples of the visible interval that are older. */
export function useCurves(curves, shown, visible, key) {
  useEffect(() => {
    if (!visible.value) return undefined;
    const ends = [...Map.groupBy(curves, ({ of }) => of)].map(([of, all]) => watch({ info: all.flatMap(({ inputs }) => inputs.map(({ place }) => [...place, 2])) }, of === shown ? null : of));
    return () => ends.forEach((end) => end());
  }, [visible.value, shown, shown?.description.value, key]);
  useEffect(() => {
    if (curves.length === 0) return undefined;
    let timer = null;
    const read = async () => {
      await Promise.all([...Map.groupBy(curves, ({ of }) => of)].map(([of, all]) => readActivity(of, all, visibleRange.peek().map((at) => Math.max(0, Math.round(at + all[0].shift))))));
      for (const { of, shift, place } of curves.flatMap(({ of, shift, inputs }) => inputs.map(({ place }) => ({ of, shift, place })))) {
        const output = of.output(...place);
        const [from, until] = visibleRange.peek().map((at) => Math.max(0, Math.round(at + shift)));
        if (output.times.length > 0 && output.times[0] <= from) continue;
        try {
          output.prepend(await request('series', { session: of.id, component: place[0], info: place[1], from_us: from, until_us: until, points: POINTS }));
        } catch {
          // A recording may lack it; live samples are sent in any case.
        }
      }
    };
    const stop = effect(() => {
      void [range.value, visible.value];
      clearTimeout(timer);
      timer = setTimeout(read, 150);
    });
    return () => {
      stop();
      clearTimeout(timer);
    };
  }, [shown, shown?.description.value, key]);
}
