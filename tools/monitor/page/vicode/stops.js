// Breakpoints at states and transitions of the selected session.

import { computed, signal } from '../lib/dom.js';
import { listen } from '../lib/connection.js';
import { ask, notify, seek, session } from '../lib/store.js';
import { parsed, stateKey } from './machine.js';
import { component, machine } from './sources.js';

/** Breakpoints by session: [{component, state} or {component, transition}], indices of its description. */
const known = signal(new Map());
/** The last hit: {session, time_us, component, state, transition, paused}. */
export const hit = signal(null);

export const stops = computed(() => known.value.get(session.value?.id) ?? []);

/** Index of the shown component in the session; -1 if it has none of the name. */
export const place = computed(() => (machine.value ? session.value?.find(machine.value.component.name.text.split('<')[0]) ?? -1 : -1));

/** Keys in the canvas with a breakpoint. */
export const stopKeys = computed(() => new Set(stops.value.filter((stop) => stop.component === place.value).flatMap(keysOf)));

function keysOf({ component: index, state = null, transition = null }) {
  const described = session.value?.description.value?.components[index];
  if (!described) return [];
  if (state !== null) return [stateKey(described.states[state]?.name)];
  const { name, from, to } = described.transitions[transition] ?? {};
  const [source, target] = [described.states[from]?.name, described.states[to]?.name];
  return (machine.value?.arrows ?? []).filter((arrow) => arrow.name === name && arrow.to === target && (arrow.any || arrow.from === source)).map((arrow) => arrow.key);
}

/** The breakpoints that a key stands for: of an arrow from any state, one for each state. */
function stopsOf(key) {
  const described = session.value?.description.value?.components[place.value];
  if (!described) return [];
  const { kind, name, from } = parsed(key);
  if (kind === 'state') {
    const state = described.states.findIndex((one) => one.name === name);
    return state < 0 ? [] : [{ component: place.value, state }];
  }
  const target = machine.value?.byKey.get(key)?.to;
  return described.transitions.flatMap((one, transition) => (one.name === name && described.states[one.to]?.name === target && (from === '*' || described.states[one.from]?.name === from) ? [{ component: place.value, transition }] : []));
}

const same = (a, b) => a.component === b.component && (a.state ?? null) === (b.state ?? null) && (a.transition ?? null) === (b.transition ?? null);

export function toggleStop(key) {
  const own = stopsOf(key);
  if (own.length === 0) {
    notify('error', session.value ? `${session.value.info.value.name} does not run this ${key.startsWith('s:') ? 'state' : 'transition'}` : 'no session is open', session.value ? 'press Run to build it and run it' : 'open a world, or press Run');
    return;
  }
  const on = own.every((one) => stops.value.some((stop) => same(stop, one)));
  const rest = stops.value.filter((stop) => !own.some((one) => same(stop, one)));
  send(on ? rest : [...rest, ...own]);
}

export const clearStops = () => send([]);

function send(list) {
  const { id } = session.value;
  known.value = new Map(known.value).set(id, list);
  ask('breakpoints', { session: id, list });
}

listen((message) => {
  if (message?.type === 'breakpoints') known.value = new Map(known.value).set(message.session, message.list);
  else if (message?.type === 'hit') reached(message);
  else if (message?.type === 'described') hit.value = null;
});

/** Words for a hit or breakpoint. */
export function wordsOf({ component: index, state = null, transition = null }, of = session.value) {
  const described = of?.description.value?.components[index];
  if (!described) return '';
  return state !== null ? `${described.name} is in ${described.states[state]?.name}` : `${described.name} takes ${described.transitions[transition]?.name}`;
}

function reached(message) {
  hit.value = message;
  if (message.session !== session.value?.id) return;
  notify('done', `Breakpoint: ${wordsOf(message)}`, message.paused ? 'The world is paused; “.” makes a step, “,” continues.' : 'The robot goes on.');
}

/** Goes to the next moment in memory at which a breakpoint is reached. */
export async function nextHit() {
  const shown = session.value;
  const from_us = shown.moment.value?.time_us ?? shown.info.value.from_us;
  const found = await ask('next_hit', { session: shown.id, from_us });
  if (found === undefined) return;
  if (found === null) notify('done', 'no breakpoint is reached later in what is remembered');
  else {
    hit.value = { ...found, session: shown.id, paused: false };
    seek(found.time_us);
  }
}

