// Trials of the open motion in a simulated body, or on the simulated robot of the session.

import { computed, html, signal, useSignal } from '../lib/dom.js';
import { jointsOf } from '../lib/frames.js';
import { act, command, notify, session, sessions } from '../lib/store.js';
import { chosen, form, keys, sent, tell } from './model.js';
import { model } from '../vicode/sources.js';

/** The last trial: {runs, joints, first, text} or {verdict, text}; `text` is that of the keyframes that were tried. */
export const result = signal(null);
/** Number of runs that are being computed; 0 if none. */
const running = signal(0);

/** Whether a trial on the robot of the session is to end. */
const cancelled = signal(false);
/** Whether such a trial goes on. */
const playing = signal(false);

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

/** What a channel measured when the keyframe with a number was to be reached; undefined if it is not known. */
export const reached = (index, at) => {
  const times = keys.value.map((_, key) => key + 1);
  return isCurrent.value ? measured(index, times).findLast(([time]) => time <= at + 1)?.[1] : undefined;
};

/** Keyframes of another motion of the file, as they are written. */
function written(key) {
  const [own, of] = [form.value, model.value.tables.find((one) => one.key === key)];
  return (of?.rows ?? []).map(({ cells }) => ({
    seconds: cells.find(({ name }) => name === own.time[0]).value * own.time[1],
    cells: Object.fromEntries(own.channels.flatMap(({ cell }) => cells.filter(({ name }) => name === cell).map(({ value }) => [cell, value]))),
  }));
}

/** Whether the session is a simulated world whose robot can be moved, with a form of that robot. */
const canPlay = (own, shown) => Boolean(jointsOf(shown) && shown.info.value.can.pause && shown.description.value.actions.some(({ name }) => name === own.plays));

/** Plays a motion on the robot of the session: actions of its world before one cycle. Returns what was measured; null if it ended early. */
async function play(request) {
  const shown = session.value;
  const { calls, before, ends, seconds, wanted, unwanted } = await tell('plan', request);
  if ((await command('pause')) === undefined) return null;
  let isPlanned = true;
  for (const [action, values] of calls) isPlanned &&= (await act('operate', { request: { type: 'world', action, arguments: values } })) !== undefined;
  const begin = shown.live.value.time_us + before * 1e6;
  const end = begin + (seconds - before) * 1e6;
  await act('resume');
  [cancelled.value, playing.value] = [false, true];
  while (isPlanned && shown.live.value?.time_us < end) {
    await new Promise((resolve) => { setTimeout(resolve, 100); });
    isPlanned = !cancelled.value && sessions.value.has(shown.id) && shown.live.value?.time_us > begin - before * 1e6 - 1e5;
  }
  playing.value = false;
  const { times, values } = shown.output(...jointsOf(shown));
  const of = (time) => (time > begin && time <= end ? [(time - begin) / 1e6] : []);
  const course = times.flatMap((time, at) => of(time).map((since) => [since, null, values[at].positions.map((angle) => (angle * 180) / Math.PI)]));
  const first = (event) => shown.lines.flatMap(({ source, text, time_us }) => (event && source === 'world' && text.startsWith(event) ? of(time_us) : []))[0] ?? null;
  const fell = first(unwanted);
  return isPlanned && course.length > 0 ? { joints: values[0].names, runs: [{ fell, stands: wanted ? first(wanted) !== null : fell === null, load: [], ends, course }] } : null;
}

async function attempt(world, runs, start) {
  const own = form.value;
  const [, parts] = own.sequences[chosen.value.key] ?? [null, [chosen.value.key]];
  const lists = parts.map((key) => (key === chosen.value.key ? sent(keys.value, own) : written(key)));
  const first = lists.slice(0, parts.indexOf(chosen.value.key)).flat().length;
  const [text, motion] = [textOf(), JSON.stringify(chosen.value)];
  running.value = runs;
  try {
    const [request, mujoco] = [{ form: own.name, keys: lists.flat(), start }, world === 'mujoco'];
    const answer = world === 'session' ? await play(request) : await tell('try', { ...request, motion: chosen.value.key, mujoco, runs });
    if (answer) result.value = { ...answer, first, text, motion, mujoco };
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
  const [chosenWorld, start] = [useSignal(null), useSignal(null)];
  const own = form.value;
  const [usual] = own.sequences[chosen.value.key] ?? ['stand'];
  const worlds = [...(own.only ? [['mujoco', own.only]] : [['built-in', 'built-in world'], ['mujoco', 'MuJoCo']]), ...(canPlay(own, session.value) ? [['session', 'robot of the session']] : [])];
  const world = worlds.some(([name]) => name === chosenWorld.value) ? chosenWorld.value : worlds[0][0];
  const go = (runs) => attempt(world, runs, start.value ?? usual);
  const last = result.value?.motion === JSON.stringify(chosen.value) ? result.value : null;
  const select = (label, value, list, set) => html`<select aria-label=${label} onChange=${(event) => set(event.target.value)}>${list.map(([name, text]) => html`<option value=${name} selected=${name === value}>${text}</option>`)}</select>`;
  return html`<div class="trial" role="group" aria-label="Trial">
    ${select('World of the trial', world, worlds, (name) => { chosenWorld.value = name; })}
    ${!own.only && select('Beginning of the trial', start.value ?? usual, [['stand', 'from the stand'], ['front', 'lying on the front'], ['back', 'lying on the back']], (name) => { start.value = name; })}
    <button class="primary" disabled=${running.value > 0 || !keys.value?.length} title=${world === 'session' ? 'Places the robot beside the way of the game; its program goes on afterwards' : ''} onClick=${() => go(1)}>Try</button>
    <button disabled=${running.value > 0 || !keys.value?.length || world === 'session'} title="Friction, gains, dead time, sensor noise and the zeros of the joints differ in each but the first" onClick=${() => go(20)}>20 tries</button>
    ${playing.value && html`<button onClick=${() => { cancelled.value = true; }} title="Wait no longer; the robot ends its motion when the world goes on">Cancel</button>`}
    <span role="status" aria-label="Result of the trial">${playing.value && session.value?.info.value.paused && html`<b class="warn">The world is paused: continue it (key ,)</b> `}${running.value > 0 ? `${running.value === 1 ? 'trying' : `${running.value} tries`}…` : last && html`${last.verdict ? html`<${Verdict} ...${last.verdict} />` : html`<${Runs} runs=${last.runs} mujoco=${last.mujoco} />`}
      ${!isCurrent.value && html` <span class="warn">of an earlier version: try again</span>`}`}</span></div>`;
}
