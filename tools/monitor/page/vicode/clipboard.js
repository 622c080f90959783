// Copy and paste of states with their transitions, also into another component.

import { notify } from '../lib/store.js';
import { functionsOf, parsed, stateKey } from './machine.js';
import { change, choose, machine, move, offsets, selection, wish } from './sources.js';
import { stage } from './canvas/stage.js';

/** What was copied: {code, names, places}. */
let copied = null;

/** Copies the selected states, the transitions between them, and the hooks of them alone. */
export function copy() {
  const own = machine.value;
  if (!own || selection.value.length === 0) return;
  const all = selection.value.map(parsed);
  const states = new Set(all.filter(({ kind }) => kind === 'state').map(({ name }) => name));
  const chosen = new Set(all.map(({ name }) => name));
  const inside = (transition) => transition.arrows.every(({ from, to }) => from !== 'any' && states.has(to?.text) && from.these.every((one) => states.has(one.text)));
  const functions = [
    ...own.component.states.filter((one) => states.has(one.function.name.text)),
    ...own.component.hooks.filter((hook) => hook.states.length > 0 && hook.states.every((one) => states.has(one.text))),
    ...own.component.transitions.filter((one) => inside(one) || (states.size === 0 && chosen.has(one.function.name.text))),
  ].map((one) => one.function);
  functions.sort((a, b) => a.span[0] - b.span[0]);
  const boxes = [...states].map((name) => [name, stage.boxes.get(name)]);
  copied = { code: functions.map(({ span }) => offsets.value.slice(span)).join('\n\n'), names: functions.map(({ name }) => name.text), places: boxes.map(([name, { x, y }]) => ({ name, x, y })) };
  navigator.clipboard?.writeText(copied.code).catch(() => {});
  notify('done', functions.length === 1 ? `${copied.names[0]} was copied` : `${functions.length} functions were copied`);
}

/** Pastes; names that are taken get a number. */
export async function paste() {
  const own = machine.value;
  if (!own || !copied) {
    if (own) notify('error', 'nothing was copied', 'select states and press Ctrl+C');
    return;
  }
  const taken = new Set(functionsOf(own.component).map((one) => one.name.text));
  const renamed = new Map();
  for (const name of copied.names) {
    let [free, number] = [name, 2];
    for (; taken.has(free); number += 1) free = `${name}_${number}`;
    taken.add(free);
    renamed.set(name, free);
  }
  let code = copied.code.replace(/\p{XID_Continue}+/gu, (word) => renamed.get(word) ?? word);
  if (own.states.some(({ initial }) => initial)) code = code.replace(/#\[state\(initial\)\]/g, '#[state]').replace(/#\[state\(initial,\s*/g, '#[state(');
  const keys = copied.places.map(({ name }) => stateKey(renamed.get(name)));
  if (keys.length > 0) wish(keys);
  if (!(await change({ edit: 'insert_code', code }))) return;
  await move(Object.fromEntries(copied.places.map(({ name, x, y }) => [renamed.get(name), { x: x + 48, y: y + 64 }])), false);
  if (keys.length > 0) choose(keys);
}
