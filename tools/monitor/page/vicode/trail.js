// The way down: children that are machines are opened out of a state, and the trail leads back.

import { html, signal } from '../lib/dom.js';
import { notify, session } from '../lib/store.js';
import { component, list, machine, open, openByName, openedFile } from './sources.js';

/** The states that were gone through, the uppermost first: {file, name, state, child}. */
const trail = signal([]);
/** The trail of the shown component; none if it was opened in another way. */
const valid = () => (trail.value.at(-1)?.child === component.value?.split('<')[0] ? trail.value : []);

const nameOf = (one) => (one.kind ?? one.name).split('<')[0];

/** The component that a child stands for: of a role, `impl Legs`, its provider in the tree of the shown robot. */
function providerOf(child) {
  const [, role] = child.match(/^impl (\w+)$/) ?? [];
  const components = session.value?.description.value?.components ?? [];
  const link = role && components.flatMap(({ links }) => links).find(({ roles = [] }) => roles.includes(role));
  return link ? nameOf(components[link.to]) : child;
}

export function isMachine(child) {
  const name = providerOf(child);
  return list.value?.some(({ components = [] }) => components.some((one) => one.machine && nameOf(one) === name)) ?? false;
}

/** Opens a child of a state; of a role, its provider. */
export async function descend(state, name) {
  const child = providerOf(name);
  const step = { file: openedFile.value, name: component.value, state, child };
  const before = valid();
  if (await openByName(child)) trail.value = [...before, step];
}

/** Opens the first child of a state that is a machine. */
export function descendFirst(name) {
  const state = machine.value?.states.find((one) => one.name === name);
  const child = state?.children.find((one) => isMachine(one.child))?.child;
  if (child) return descend(name, child);
  return state && notify('error', `${name} has no child that is a machine`, 'its children are opened from Sources');
}

/** Goes back up to a component of the trail. */
async function ascend(depth) {
  const { file, name } = trail.value[depth];
  trail.value = trail.value.slice(0, depth);
  await open(file, name);
}

export function Trail() {
  const steps = valid();
  if (steps.length === 0) return null;
  return html`<nav class="trail" aria-label="Trail">${steps.map(({ name, state }, depth) => html`<button onClick=${() => ascend(depth)} title=${`Back to ${name}`}>${name}</button><span class="dim">› ${state} ›</span>`)}<b>${component.value}</b></nav>`;
}
