// Breakpoints at states and transitions of the selected session.

import { computed, signal } from '../lib/dom.js';
import { listen, request } from '../lib/connection.js';
import { resolve } from '../lib/curves.js';
import { numberAt } from '../lib/format.js';
import { act, ask, command, notify, seek, session } from '../lib/store.js';
import { stored } from '../lib/stored.js';
import { writtenBy } from '../panels/tree/boxes.js';
import { parsed, stateKey } from './machine.js';
import { machine } from './sources.js';

/** Breakpoints by session: [{component, state} or {component, transition}], indices of its description. */
const known = signal(new Map());
/** The last hit: {session, time_us, component, state, transition, paused}. */
export const hit = signal(null);

export const stops = computed(() => known.value.get(session.value?.id) ?? []);

/** Index of the shown component in the session; -1 if it has none of the name. */
export const place = computed(() => (machine.value ? session.value?.description.value?.components.findIndex(({ name, kind }) => (kind ?? name).split('<')[0] === machine.value.component.name.text.split('<')[0]) ?? -1 : -1));

/** Who writes a child of the shown component in one cycle, if several do in the session: `written by Avoid, then Follow; in force: Avoid`. */
export function writtenWith(child) {
  const description = session.value?.description.value;
  const isOf = ({ to, roles = [] }) => (child.startsWith('impl ') ? roles.includes(child.slice(5)) : (description.components[to].kind ?? description.components[to].name) === child);
  const link = description?.components[place.value]?.links.find((one) => one.kind === 'modulation' && isOf(one));
  return link && writtenBy(description, description.components[link.to]);
}

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
  const { kind, name: stateName, from } = parsed(key);
  if (kind === 'state') {
    const state = described.states.findIndex((one) => one.name === stateName);
    return state < 0 ? [] : [{ component: place.value, state }];
  }
  const { name, to: target } = machine.value?.byKey.get(key) ?? {};
  return described.transitions.flatMap((one, transition) => (one.name === name && described.states[one.to]?.name === target && (from === '*' || described.states[one.from]?.name === from) ? [{ component: place.value, transition }] : []));
}

const same = (a, b) => a.component === b.component && (a.state ?? null) === (b.state ?? null) && (a.transition ?? null) === (b.transition ?? null);

export function toggleStop(key) {
  const own = stopsOf(key);
  if (own.length === 0) {
    notify('error', session.value ? `${session.value.title} does not run this ${key.startsWith('s:') ? 'state' : 'transition'}` : 'no session is open', session.value ? 'press Run to build it and run it' : 'open a world, or press Run');
    return;
  }
  const on = own.every((one) => stops.value.some((stop) => same(stop, one)));
  const rest = stops.value.filter((stop) => !own.some((one) => same(stop, one)));
  if (on) setCondition(key, '');
  send(on ? rest : [...rest, ...own]);
}

export const clearStops = () => send([]);

/** Whether the shown component runs in a session that can be operated. */
export const canGo = computed(() => place.value >= 0 && session.value.info.value.can.operate);

/** Makes the running machine go to a state. */
export function goTo(key) {
  const [found] = stopsOf(key);
  if (!canGo.value || found?.state === undefined) notify('error', 'no session that can be operated runs this state', 'choose a state, and open a world or press Run');
  else command('go', found);
}

// ---- conditions

const remembered = stored('localStorage', 'jmanager-breakpoint-conditions');
/** Conditions of breakpoints, as of watches, by the names of their places: of this browser, also after a reload and in a new run. */
const conditions = signal(new Map(remembered.read() ?? []));

function nameOf(of, { component: index, state = null, transition = null }) {
  const { name, states, transitions } = of.description.value.components[index];
  const arrow = transitions[transition];
  return [name, ...(arrow ? [arrow.name, states[arrow.from]?.name, states[arrow.to]?.name] : [states[state]?.name])].join(' ');
}

/** The condition of the breakpoint at a key; empty without one. */
export const conditionAt = (key) => stopsOf(key).map((stop) => conditions.value.get(nameOf(session.value, stop)))[0] ?? '';

export function setCondition(key, text) {
  try {
    if (text) resolve(session.value, text);
  } catch ({ message }) {
    notify('error', message, 'write a condition over outputs, as in Odometry.walked.x > 0.5');
    return;
  }
  const next = new Map(conditions.value);
  for (const name of stopsOf(key).map((stop) => nameOf(session.value, stop))) {
    if (text) next.set(name, text);
    else next.delete(name);
  }
  conditions.value = next;
  remembered.write([...next]);
}

/** Whether the condition of a reached breakpoint held in its cycle. One whose outputs are not known then holds. */
async function holds(of, reached) {
  const text = conditions.value.get(nameOf(of, reached));
  if (!text) return true;
  const { inputs, begin } = resolve(of, text);
  const { info } = await request('at', { session: of.id, time_us: reached.time_us, info: inputs.map(({ place: one }) => one), image: false });
  const values = inputs.map(({ place: [index, output], path }) => numberAt(info.find(([one, other]) => one === index && other === output)?.[3], path));
  return values.includes(null) || Boolean(begin()(reached.time_us / 1e6, values));
}

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

async function reached(message) {
  const of = session.value;
  if (message.session === of?.id && !(await holds(of, message).catch(() => true))) {
    if (message.paused) act('resume');
    return;
  }
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

