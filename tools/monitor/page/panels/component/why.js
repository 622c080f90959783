// Why a component is latent, and why a state machine does not proceed.

import { html } from '../../lib/dom.js';
import { duration } from '../../lib/format.js';
import { openComponent } from '../../lib/dock.js';
import { writtenBy } from '../tree/boxes.js';
import { cursor } from '../../lib/store.js';
import { Answer, Way, blocking, waits } from './answer.js';

/** The first lines of the tab, of one height: what follows does not move. */
export function First({ shown, component, index }) {
  const components = shown.moment.value?.components;
  return components ? html`<${Answer} ...${{ shown, component, index, reasons: reasonsOf(shown, index, components) }} />` : html`<div class="answer"></div>`;
}

export function Why({ shown, component, index }) {
  const components = shown.moment.value?.components;
  if (!components) return null;
  const active = components[index]?.[0];
  const reasons = reasonsOf(shown, index, components);
  return html`${waits(component, components[index]) && html`<${Way} ...${{ component, current: components[index][2] }} />`}
    ${component.states.length > 0 && html`<${Machine} ...${{ shown, component, index, active }} />`}
    <${Activators} ...${{ shown, index, components, active, reasons }} />
    ${component.queries && html`<${Asks} components=${shown.description.value.components} queries=${component.queries} />`}`;
}

/** The components for whose age or outcome it asks. */
const Asks = ({ components, queries }) => html`<section aria-label="Asks"><h3>Asks</h3>
  ${queries.map(({ of, kind }) => html`<div class="why"><span>${kind} of </span><button class="name" onClick=${() => openComponent(components[of].name)}>${components[of].name}</button></div>`)}</section>`;

/** States, and the transitions that leave the current one. */
function Machine({ shown, component, index, active }) {
  const now = shown.moment.value.components[index];
  const current = now[2];
  const conditions = shown.conditions_of(index).value?.conditions;
  const leaving = component.transitions.map((transition, number) => ({ ...transition, number })).filter(({ from }) => from === current);
  const { last, end } = component.states[current] ?? {};
  const blocks = active ? blocking(component, current) : undefined;
  return html`<section aria-label="States"><h3>${active ? `Leaves ${component.states[current]?.name} by` : component.resume ? 'Continues in' : 'Was last in'}${!active && html` <b title=${component.states[current]?.doc}>${component.states[current]?.name}</b>`}</h3>
    ${leaving.length === 0 && html`<p class="dim">${end ? `The machine ends here: ${end}.` : last ? 'This is a last state: no transition leaves it.' : 'No transition leaves this state.'}</p>`}
    ${leaving.map((transition) => {
      const condition = conditions?.[transition.number];
      const holds = condition?.holds;
      const waits = condition?.remaining_ms > 0;
      const since = condition ? Math.max(0, shown.moment.value.time_us - condition.since_us) : null;
      const value = condition === undefined ? '' : holds === null ? 'not evaluated' : `${holds}${since !== null ? ` for ${duration(since)}` : ''}`;
      const parameter = transition.after === undefined ? null : component.params[transition.after];
      const after = parameter ? `${parameter.name} (${shown.params.value[index]?.[transition.after] ?? parameter.default} ${parameter.unit})` : `${transition.after_ms / 1000} s`;
      const timer = transition.after_ms === null ? '' : waits ? `${(condition.remaining_ms / 1000).toFixed(1)} s of ${after} left` : `after ${after}`;
      const times = transition.times ? `at most ${transition.times} times in a row` : '';
      return html`<div key=${transition.number} class=${`why leaves ${holds ? 'true' : ''} ${transition.number === blocks ? 'blocking' : ''}`} title=${transition.doc}>
        <span class="names"><b>${transition.name}</b> <span class="to">→ ${component.states[transition.to]?.name}${transition.carries && ` ← ${transition.carries}`}</span></span><span class="value">${[value, timer, times].filter(Boolean).join(' · ')}</span></div>`;
    })}
    ${leaving.length > 0 && component.states[current]?.before && html`<p class="dim">Before these, <b>${component.states[current].before}</b> runs.</p>`}
    ${leaving.length > 0 && !conditions && html`<p class="dim">${!shown.info.value.can.conditions ? 'This session does not send the values of conditions.' : cursor.value === null ? 'Values of the conditions follow.' : 'The values of the conditions at this moment are not known.'}</p>`}</section>`;
}

/** Who activates it, or what would, the strongest first: [{from, name, why}]. */
function reasonsOf(shown, index, components) {
  const description = shown.description.value;
  const links = shown.incoming[index] ?? [];
  const merged = [...Map.groupBy(links, (one) => one.from)].map(([from, all]) => ({ from, states: all.map((one) => one.state), modulation: all.every((one) => one.kind === 'modulation') }));
  const reason = ({ from, states, modulation }) => {
    const source = description.components[from];
    const [isActive, sourceHeld, state] = components[from];
    const always = states.includes(null);
    const names = states.filter((one) => one !== null).map((one) => source.states[one]?.name);
    const inState = always || states.includes(state);
    if (isActive && inState) return { level: 'yes', text: modulation ? 'activates and modulates it' : 'requires it' };
    if (isActive) return { level: 'no', text: html`is in <b>${source.states[state]?.name ?? '?'}</b>; it activates this only in ${names.join(', ')}` };
    const when = always ? '' : `, and would activate this only in ${names.join(', ')}`;
    return { level: 'off', text: sourceHeld === 'latent' ? `is held latent${when}` : `is latent${when}` };
  };
  return merged.map((one) => ({ from: one.from, name: description.components[one.from].name, why: reason(one) })).sort((a, b) => order(a) - order(b));
}

function Activators({ shown, index, components, active, reasons }) {
  const description = shown.description.value;
  const held = components[index]?.[1];
  return html`<section aria-label=${active ? 'Why it is active' : 'Why it is latent'}><h3>${active ? 'Why it is active' : 'Why it is latent'}</h3>
    ${held === 'latent' && html`<div class="why false"><b>An operator holds it latent.</b> Choose “by the tree” below.</div>`}
    ${held === 'active' && html`<div class="why true"><b>An operator holds it active.</b></div>`}
    ${description.root === index && held === 'tree' && html`<div class="why true"><b>It is the root</b> of the tree.</div>`}
    ${reasons.map(({ from, name, why }) => html`<div key=${from} class=${`why ${why.level === 'yes' ? 'true' : why.level === 'no' ? 'false' : ''}`}>
      <button class="name" onClick=${() => openComponent(name)}>${name}</button> <span>${why.text}</span></div>`)}
    ${description.components[index].writers && html`<p class="dim">In one cycle it is ${writtenBy(description, description.components[index])}.</p>`}
    ${reasons.length === 0 && description.root !== index && html`<p class="dim">No component activates it.</p>`}</section>`;
}

const order = ({ why }) => ['yes', 'no', 'off'].indexOf(why.level);
