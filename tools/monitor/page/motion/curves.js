// The timeline: a curve for each channel through the keyframes, and after a trial what was measured.

import { Canvas, line } from '../lib/canvas.js';
import { html, useRef } from '../lib/dom.js';
import { ticks } from '../lib/format.js';
import { css, curveColour } from '../lib/theme.js';
import { channel, draft, form, held, keys, row, setSeconds, shapes } from './model.js';
import { measured } from './trial.js';

const [LEFT, RIGHT, TOP, BOTTOM] = [44, 14, 18, 20];
/** Distance within which a keyframe is taken with the pointer, px. */
const NEAR = 7;

/** Times at which the keyframes are reached, s. */
const timesOf = (list) => list.reduce((times, { seconds }) => [...times, (times.at(-1) ?? 0) + seconds], []);

const eased = (share, linear) => (linear ? share : share * share * (3 - 2 * share));

/** Channels that the motion moves, and the chosen one. */
export function moved() {
  const own = form.value;
  return own.channels.map((_, index) => index).filter((index) => index === channel.value || keys.value.some(({ values }) => Math.abs(values[index] - own.channels[index].rest) > own.channels[index].step));
}

/** The vertical axis: degrees, or shares of the range if the channels have several units. */
function axis(own, shown) {
  const units = new Set(shown.map((index) => own.channels[index].unit));
  if (units.size > 1) return { low: 0, high: 100, of: (index, value) => ((value - own.channels[index].min) / (own.channels[index].max - own.channels[index].min)) * 100, unit: '% of range' };
  const all = keys.value.flatMap(({ values }) => shown.map((index) => values[index])).concat(shown.map((index) => own.channels[index].rest));
  const [low, high] = [Math.min(...all), Math.max(...all)];
  const edge = Math.max((high - low) * 0.08, own.channels[shown[0]]?.step ?? 1);
  return { low: low - edge, high: high + edge, of: (_, value) => value, unit: [...units][0] ?? '' };
}

export function Curves({ visible }) {
  const pressed = useRef(null);
  const scale = useRef({ total: 1, width: 1 });
  const x = (time) => LEFT + (time / scale.current.total) * scale.current.width;
  const near = (event) => {
    const times = timesOf(keys.value);
    const at = event.offsetX;
    const found = times.map((time, index) => [Math.abs(x(time) - at), index]).sort((a, b) => a[0] - b[0])[0];
    return { index: found?.[1] ?? -1, distance: found?.[0] ?? Infinity };
  };
  const draw = (context, width, height) => {
    const [own, list] = [form.value, keys.value];
    if (!own || !list) return;
    const times = timesOf(list);
    scale.current = { total: pressed.current?.total ?? Math.max(times.at(-1) ?? 1, 0.1), width: width - LEFT - RIGHT };
    const shown = moved();
    const { low, high, of, unit } = axis(own, shown);
    const y = (index, value) => height - BOTTOM - ((of(index, value) - low) / (high - low)) * (height - TOP - BOTTOM);
    context.font = '11px system-ui, sans-serif';
    context.fillStyle = css('--dim');
    context.textAlign = 'right';
    const texts = ticks([low, (low + high) / 2, high]);
    for (const part of [0, 0.5, 1]) context.fillText(texts[2 * part], LEFT - 5, height - BOTTOM - part * (height - TOP - BOTTOM) + 4);
    context.textAlign = 'left';
    context.fillText(unit, 4, 11);
    context.textAlign = 'center';
    let last = -Infinity;
    times.forEach((time, index) => {
      const limits = shapes.value[index]?.limits;
      const isWrong = limits && (limits.beyond.length > 0 || limits.fast.length > 0);
      context.strokeStyle = css(index === row.value ? '--control' : isWrong ? '--warn' : '--line');
      context.lineWidth = index === row.value ? 2 : 1;
      line(context, x(time), TOP, x(time), height - BOTTOM);
      context.fillStyle = css(index === row.value ? '--control' : isWrong ? '--warn' : '--dim');
      context.fillText(isWrong ? `${index + 1} !` : index + 1, x(time), TOP - 6);
      const place = Math.min(x(time), width - 22);
      if (place - last < 46) return;
      context.fillText(`${time.toFixed(2)} s`, place, height - 6);
      last = place;
    });
    for (const index of shown) {
      context.strokeStyle = curveColour(index);
      context.globalAlpha = index === channel.value ? 1 : 0.55;
      context.lineWidth = index === channel.value ? 3 : 1.4;
      context.beginPath();
      let [from, begin] = [own.channels[index].rest, 0];
      context.moveTo(x(0), y(index, from));
      list.forEach(({ values, seconds }) => {
        for (let step = 1; step <= 12; step += 1) context.lineTo(x(begin + (seconds * step) / 12), y(index, from + eased(step / 12, own.linear) * (values[index] - from)));
        [from, begin] = [values[index], begin + seconds];
      });
      context.stroke();
      const course = measured(index, times);
      if (course.length > 0) {
        context.setLineDash([3, 3]);
        context.lineWidth = index === channel.value ? 2 : 1.2;
        context.beginPath();
        for (const [time, value] of course) context.lineTo(x(time), y(index, value));
        context.stroke();
        context.setLineDash([]);
      }
    }
    context.globalAlpha = 1;
  };
  const down = (event) => {
    if (!keys.value?.length) return;
    const { index, distance } = near(event);
    if (index < 0) return;
    row.value = index;
    if (distance > NEAR || !form.value.time || held.value) return;
    event.target.setPointerCapture(event.pointerId);
    pressed.current = { index, from: event.offsetX, seconds: keys.value[index].seconds, total: scale.current.total };
  };
  const move = (event) => {
    const drag = pressed.current;
    if (!drag) {
      event.target.style.cursor = keys.value?.length && form.value?.time && near(event).distance <= NEAR ? 'ew-resize' : '';
      return;
    }
    const seconds = drag.seconds + ((event.offsetX - drag.from) / scale.current.width) * drag.total;
    draft.value = { row: drag.index, seconds: Math.max(0.02, Math.round(seconds * 100) / 100) };
  };
  const up = async () => {
    const wanted = draft.value;
    pressed.current = null;
    if (wanted?.seconds) await setSeconds([[wanted.row, wanted.seconds]]);
    draft.value = null;
  };
  const reads = () => { void [keys.value, form.value, row.value, channel.value, shapes.value]; measured(0, []); };
  return html`<${Canvas} reads=${reads} draw=${draw} visible=${visible} label="Curves of the motion over time" onPointerDown=${down} onPointerMove=${move} onPointerUp=${up} onPointerCancel=${up} />`;
}
