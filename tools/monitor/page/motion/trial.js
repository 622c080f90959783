// Trials of the open motion in a simulated body.

import { computed, html, signal, useSignal } from '../lib/dom.js';
import { notify } from '../lib/store.js';
import { chosen, form, keys, sent, tell } from './model.js';
import { model } from '../vicode/sources.js';

/** The last trial: {runs, joints, first, text} or {verdict, text}; `text` is that of the keyframes that were tried. */
export const result = signal(null);
/** Number of runs that are being computed; 0 if none. */
const running = signal(0);

const textOf = () => JSON.stringify([chosen.value, keys.value]);
/** Whether the shown keyframes are those of the last trial. */
const isCurrent = computed(() => result.value?.text === textOf());

/** What a channel measured in the last trial, at the times of the timeline: [[time, value]]. */
export function measured(index, times) {
  const last = result.value;
  const [own, joint] = [form.value?.channels[index], form.value?.channels[index]?.moves[0]];
  if (!last?.runs || last.motion !== JSON.stringify(chosen.value) || !joint || own.unit !== '°') return [];
  const at = last.joints.indexOf(joint);
  const { course, ends } = last.runs[0];
  // The motion was slower where motors are: each part of the course is shown in the part of the timeline that it is of.
  const [begins, shown] = [[ends[last.first - 1] ?? 0, ...ends.slice(last.first, last.first + times.length)], [0, ...times]];
  return course.flatMap(([time, , angles]) => {
    const part = begins.findIndex((begin, place) => place < times.length && time > begin && time <= begins[place + 1]);
    if (part < 0) return [];
    const share = (time - begins[part]) / (begins[part + 1] - begins[part]);
    return [[shown[part] + share * (shown[part + 1] - shown[part]), angles[at]]];
  });
}

/** Keyframes of another motion of the file, as they are written. */
function written(key) {
  const [own, of] = [form.value, model.value.tables.find((one) => one.key === key)];
  return (of?.rows ?? []).map(({ cells }) => ({
    seconds: cells.find(({ name }) => name === own.time[0]).value * own.time[1],
    cells: Object.fromEntries(own.channels.flatMap(({ cell }) => cells.filter(({ name }) => name === cell).map(({ value }) => [cell, value]))),
  }));
}

async function attempt(mujoco, runs, start) {
  const own = form.value;
  const [, parts] = own.sequences[chosen.value.key] ?? [null, [chosen.value.key]];
  const lists = parts.map((key) => (key === chosen.value.key ? sent(keys.value, own) : written(key)));
  const first = lists.slice(0, parts.indexOf(chosen.value.key)).flat().length;
  const [text, motion] = [textOf(), JSON.stringify(chosen.value)];
  running.value = runs;
  try {
    const answer = await tell('try', { form: own.name, motion: chosen.value.key, keys: lists.flat(), start, mujoco, runs });
    result.value = { ...answer, first, text, motion, mujoco };
  } catch (error) {
    notify('error', error.text ?? String(error), error.help ?? '');
  } finally {
    running.value = 0;
  }
}

const Verdict = ({ good, title, text }) => html`<b class=${good ? 'fine' : 'bad'}>${title}</b> <span>${text}</span>`;

function Runs({ runs, mujoco }) {
  const bad = runs.filter(({ fell, stands }) => fell !== null || !stands);
  // In the built-in world nothing has weight.
  const loads = (mujoco ? runs[0].load : []).filter(([, load]) => load > 0).sort((a, b) => b[1] - a[1]).slice(0, 3);
  const first = bad[0]?.fell;
  return html`<b class=${bad.length === 0 ? 'fine' : 'bad'}>${runs.length === 1 ? (bad.length === 0 ? 'stands' : first ? `fell at ${first.toFixed(2)} s` : 'lies at the end') : `${bad.length} of ${runs.length} fell or lie`}</b>
    ${loads.length > 0 && html` <span>load: ${loads.map(([joint, load]) => `${joint} ${(load * 100).toFixed(0)} %`).join(', ')} of the continuous current</span>`}`;
}

export function Trial() {
  const [mujoco, start] = [useSignal(false), useSignal(null)];
  const own = form.value;
  const [usual] = own.sequences[chosen.value.key] ?? ['stand'];
  const go = (runs) => attempt(mujoco.value, runs, start.value ?? usual);
  const last = result.value?.motion === JSON.stringify(chosen.value) ? result.value : null;
  return html`<div class="trial" role="group" aria-label="Trial">
    ${own.only ? html`<span class="dim">${own.only}</span>` : html`<select aria-label="World of the trial" onChange=${(event) => { mujoco.value = event.target.value === 'mujoco'; }}><option value="built-in">built-in world</option><option value="mujoco" selected=${mujoco.value}>MuJoCo</option></select>
    <select aria-label="Beginning of the trial" onChange=${(event) => { start.value = event.target.value; }}>${[['stand', 'from the stand'], ['front', 'lying on the front'], ['back', 'lying on the back']].map(([value, name]) => html`<option value=${value} selected=${value === (start.value ?? usual)}>${name}</option>`)}</select>`}
    <button class="primary" disabled=${running.value > 0 || !keys.value?.length} onClick=${() => go(1)}>Try</button>
    <button disabled=${running.value > 0 || !keys.value?.length} title="Friction, gains, dead time, sensor noise and the zeros of the joints differ in each but the first" onClick=${() => go(20)}>20 tries</button>
    <span role="status" aria-label="Result of the trial">${running.value > 0 ? `${running.value === 1 ? 'trying' : `${running.value} tries`}…` : last && html`${last.verdict ? html`<${Verdict} ...${last.verdict} />` : html`<${Runs} runs=${last.runs} mujoco=${last.mujoco} />`}
      ${!isCurrent.value && html` <span class="warn">of an earlier version: try again</span>`}`}</span></div>`;
}
