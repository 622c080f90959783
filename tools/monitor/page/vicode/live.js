// The machine as it runs: the lit state, its time, conditions, timers and counts, written to the elements of the canvas.

import { signal } from '../lib/dom.js';
import { listen } from '../lib/connection.js';
import { duration } from '../lib/format.js';
import { session } from '../lib/store.js';
import { stage } from './canvas/stage.js';
import { machine } from './sources.js';
import { hit, place, writtenWith } from './stops.js';

/** Times that each way was taken, by session: Map from `component:from:to`. */
const counts = new Map();
const last = new Map();
const counted = signal(0);

listen((message) => {
  if (message?.type === 'described' || message?.type === 'closed') {
    counts.delete(message.session);
    last.delete(message.session);
  } else if (message?.type === 'update') count(message);
});

function count({ session: id, changes, components }) {
  if (!counts.has(id)) {
    counts.set(id, new Map());
    last.set(id, new Map(components.map((one, index) => [index, one[2]])));
  }
  const [ways, states] = [counts.get(id), last.get(id)];
  for (const [component, , , state] of changes) {
    const before = states.get(component);
    if (state !== null && before !== state && before !== null && before !== undefined) {
      const way = `${component}:${before}:${state}`;
      ways.set(way, (ways.get(way) ?? 0) + 1);
    }
    states.set(component, state);
  }
  if (changes.length > 0) counted.value += 1;
}

const write = (element, text) => {
  if (element && element.textContent !== text) element.textContent = text;
};

/** Whether something was written that may have to be taken back. */
let written = false;

/** Writes what runs now; called by an effect and after each rendering. */
export function writeLive() {
  const shown = session.value;
  const index = place.value;
  const described = shown?.description.value?.components[index];
  const now = described ? shown.moment.value?.components?.[index] : null;
  const own = machine.value;
  void counted.value;
  // What does not run here is drawn as it is.
  if (!own || (!described && !written)) return;
  written = true;
  const current = now && now[2] !== null && now[2] !== undefined ? described.states[now[2]]?.name : null;
  for (const state of own.states) {
    const element = stage.elements.get(state.key);
    if (!element) continue;
    const lit = state.name === current;
    for (const chip of element.querySelectorAll('.link-chip.modulation')) chip.classList.toggle('several', Boolean(writtenWith(chip.dataset.child)));
    element.classList.toggle('lit', lit && Boolean(now[0]));
    element.classList.toggle('resting', lit && !now[0]);
    const still = state.initial ? 'initial' : state.last ? 'last' : '';
    write(element.querySelector('text.live'), lit ? duration(Math.max(0, shown.moment.value.time_us - now[4])) : still);
  }
  writeArrows({ shown, index, described, now, current, own });
  for (const element of stage.elements.values()) element.classList.toggle('hit', false);
  if (hit.value && hit.value.session === shown?.id && hit.value.component === index) markHit(described);
}

function markHit(described) {
  const { state = null, transition = null } = hit.value;
  if (state !== null) stage.elements.get(`s:${described.states[state]?.name}`)?.classList.add('hit');
  else {
    const { name, from, to } = described.transitions[transition] ?? {};
    const arrow = stage.arrows.find((one) => one.name === name && one.to === described.states[to]?.name && (one.any || one.from === described.states[from]?.name));
    if (arrow) stage.elements.get(arrow.key)?.classList.add('hit');
  }
}

function mark({ classList }, leaves, condition) {
  classList.toggle('leaves', leaves);
  classList.toggle('holds', condition?.holds === true);
  classList.toggle('fails', condition?.holds === false);
}

function writeArrows({ shown, index, described, now, current, own }) {
  const conditions = described ? shown.conditions_of(index).value?.conditions : null;
  const ways = counts.get(shown?.id);
  const names = new Map();
  const places = new Map(described?.states.map(({ name }, at) => [name, at]));
  const stateAt = (name) => places.get(name) ?? -1;
  const between = Map.groupBy(described?.transitions ?? [], ({ from, to }) => `${from}:${to}`);
  for (const arrow of own.arrows) {
    const element = stage.elements.get(arrow.key);
    if (!element) continue;
    const leaves = Boolean(now?.[0]) && current !== null && (arrow.any ? current !== arrow.to : arrow.from === current);
    const taken = leaves && between.get(`${stateAt(current)}:${stateAt(arrow.to)}`)?.find(({ name }) => name === arrow.name);
    const condition = taken ? conditions?.[described.transitions.indexOf(taken)] : undefined;
    mark(element, leaves, condition);
    // A bundle has one name, which says what is so of the arrow that can be taken.
    const owner = stage.courses.get(arrow.key)?.owner ?? arrow.key;
    if (leaves || !names.has(owner)) names.set(owner, { leaves, condition, text: textOf({ shown, condition, arrow, ways, index, stateAt, between }) });
  }
  for (const [owner, { leaves, condition, text }] of names) {
    const label = stage.labels.get(owner);
    if (!label) continue;
    mark(label, leaves, condition);
    write(label.querySelector('text.live'), text);
  }
}

function textOf({ shown, condition, arrow, ways, index, stateAt, between }) {
  const parts = [];
  if (condition && condition.holds !== null) {
    const since = shown.moment.value ? Math.max(0, shown.moment.value.time_us - condition.since_us) : null;
    parts.push(`${condition.holds}${since !== null && condition.since_us > 0 ? ` for ${duration(since)}` : ''}`);
  }
  if (condition?.remaining_ms > 0) parts.push(`${(condition.remaining_ms / 1000).toFixed(1)} s left`);
  if (ways && !arrow.any) {
    const way = `${stateAt(arrow.from)}:${stateAt(arrow.to)}`;
    const same = between.get(way)?.length ?? 0;
    const times = ways.get(`${index}:${way}`);
    // Of several transitions between the same states it is not known which one was taken.
    if (times) parts.push(same > 1 ? `${times}× all` : `${times}×`);
  }
  return parts.join(' · ');
}
