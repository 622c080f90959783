// The first lines of a component's tab: why it does what it does now, as a sentence.

import { Fragment, html, signal } from '../../lib/dom.js';
import { duration } from '../../lib/format.js';
import { farthest, shortestWay } from '../../lib/ways.js';

/** The states that a person wants components to reach, by name of the component. */
const wanted = signal(new Map());

/** Shows the way of a component to one of its states. */
export const wish = (component, state) => { wanted.value = new Map(wanted.value).set(component, state); };

/** The state to which the way of a machine is shown. */
export function wantedState(component) {
  const named = component.states.findIndex(({ name }) => name === wanted.value.get(component.name));
  return named >= 0 ? named : farthest(component);
}

/** The transition on which a machine waits: the first of the way to the wanted state; undefined without a way. */
export function blocking(component, current) {
  return shortestWay(component, current, wantedState(component))?.[0];
}

/** `reasons` are the rows of its activators, the strongest first. */
export function Answer({ shown, component, index, reasons }) {
  const [active, held, current] = shown.moment.value.components[index];
  const cause = held !== 'tree' ? html`an operator holds it <b class="hand">${held}</b>.` : reasons.length === 0
    ? (active ? 'it is the root of the tree.' : 'no component activates it.')
    : html`<b>${reasons[0].name}</b> ${reasons[0].why.text}.${reasons.length > 1 ? html` <span class="dim">${reasons.length - 1} more below.</span>` : ''}`;
  return html`<div class="answer" role="status">${waits(component, shown.moment.value.components[index]) ? html`<${Waiting} ...${{ shown, component, index, current }} />` : html`<p><b>${active ? 'Active' : 'Latent'}</b>: ${cause}</p>`}</div>`;
}

/** Whether a component is a machine that runs. */
export const waits = (component, [active, , current]) => active && current !== null && component.transitions.length > 0;

function Waiting({ shown, component, index, current }) {
  const name = component.states[current].name;
  const target = wantedState(component);
  const way = shortestWay(component, current, target);
  if (way === null) return html`<p><b class="now">${name}</b>: no way of transitions leads to <b>${component.states[target].name}</b>.</p>`;
  if (way.length === 0) return html`<p><b class="now">${name}</b> is reached, ${duration(shown.moment.value.time_us - shown.moment.value.components[index][4])} ago.</p>`;
  const [first, ...rest] = way.map((number) => ({ ...component.transitions[number], number }));
  const condition = shown.conditions_of(index).value?.conditions[first.number];
  return html`<p><b class="now">${name}</b>: waits for <b class="blocks">${first.name}</b><span class="since">${sinceText(shown, condition)}</span>; then ${[first, ...rest].map(({ to }, at) => html`<${Fragment}>${at > 0 && ' → '}<b>${component.states[to].name}</b><//>`)}</p>`;
}

/** How long a condition has been as it is. */
function sinceText(shown, condition) {
  if (!condition || condition.holds === null) return '';
  if (condition.remaining_ms > 0) return ` (${(condition.remaining_ms / 1000).toFixed(1)} s left)`;
  return ` (${condition.holds ? 'true for ' : ''}${duration(Math.max(0, shown.moment.value.time_us - condition.since_us))})`;
}

/** The way to the wanted state, and the choice of that state. */
export function Way({ component, current }) {
  const target = wantedState(component);
  const way = shortestWay(component, current, target) ?? [];
  const choose = (event) => wish(component.name, event.target.value);
  const transitions = way.map((number) => component.transitions[number]);
  return html`<div class="way"><label>Way to <select aria-label="Wanted state" onChange=${choose}>${component.states.map(({ name }, state) => html`<option selected=${state === target}>${name}</option>`)}</select></label>
    <span class="dim">${way.length === 1 ? '1 transition' : `${way.length} transitions`}</span>
    ${way.length > 0 && html`<ol class="chain" aria-label="Way">${transitions.map(({ name, to }, at) => html`<li><span class=${at === 0 ? 'blocks' : 'dim'}>${name} →</span> <b>${component.states[to].name}</b></li>`)}</ol>`}</div>`;
}
