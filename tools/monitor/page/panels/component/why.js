// Why a component is latent, and why a state machine does not proceed.

import { html } from '../../lib/dom.js';
import { duration } from '../../lib/format.js';
import { openComponent } from '../../lib/dock.js';
import { cursor } from '../../lib/store.js';

export function Why({ shown, component, index }) {
  const components = shown.moment.value?.components;
  if (!components) return null;
  const active = components[index]?.[0];
  return html`
    ${component.states.length > 0 && html`<${Machine} ...${{ shown, component, index, active }} />`}
    <${Activators} ...${{ shown, component, index, components, active }} />`;
}

/** States, and the transitions that leave the current one. */
function Machine({ shown, component, index, active }) {
  const now = shown.moment.value.components[index];
  const current = now[2];
  const conditions = shown.conditions_of(index).value?.conditions;
  const leaving = component.transitions.map((transition, number) => ({ ...transition, number })).filter(({ from }) => from === current);
  const last = component.states[current]?.last;
  return html`<section aria-label="States"><h3>${active ? 'Why it does not proceed' : component.resume ? 'Continues here' : 'States'}</h3>
    <ul class="states">${component.states.map((state, number) => html`<li class=${number === current ? 'current' : ''} title=${state.doc} aria-current=${number === current ? 'step' : undefined}>${state.name}</li>`)}</ul>
    ${leaving.length === 0 && html`<p class="dim">${last ? 'This is a last state: no transition leaves it.' : 'No transition leaves this state.'}</p>`}
    ${leaving.map((transition) => {
      const condition = conditions?.[transition.number];
      const holds = condition?.holds;
      const waits = condition?.remaining_ms > 0;
      const since = condition ? Math.max(0, shown.moment.value.time_us - condition.since_us) : null;
      return html`<div key=${transition.number} class=${`why ${holds ? 'true' : ''} ${waits ? 'false' : ''}`} title=${transition.doc}>
        <b>${transition.name}</b> <span class="to">→ ${component.states[transition.to]?.name}</span>
        <span class="value">${condition === undefined ? '' : holds === null ? 'not evaluated' : `${holds}${since !== null ? ` for ${duration(since)}` : ''}`}</span>
        ${transition.after_ms !== null && html`<span class=${`timer ${waits ? 'warn' : 'dim'}`}>${waits ? `${(condition.remaining_ms / 1000).toFixed(1)} s of ${transition.after_ms / 1000} s left` : `after ${transition.after_ms / 1000} s`}</span>`}
      </div>`;
    })}
    ${leaving.length > 0 && !conditions && html`<p class="dim">${!shown.info.value.can.conditions ? 'This session does not send the values of conditions.' : cursor.value === null ? 'Values of the conditions follow.' : 'The values of the conditions at this moment are not known.'}</p>`}</section>`;
}

/** Who activates it, or what would. */
function Activators({ shown, component, index, components, active }) {
  const description = shown.description.value;
  const links = shown.incoming[index] ?? [];
  const held = components[index]?.[1];
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
  const rows = merged.map((one) => ({ ...one, why: reason(one) })).sort((a, b) => order(a) - order(b));
  return html`<section aria-label=${active ? 'Why it is active' : 'Why it is latent'}><h3>${active ? 'Why it is active' : 'Why it is latent'}</h3>
    ${held === 'latent' && html`<div class="why false"><b>An operator holds it latent.</b> Choose “by the tree” below.</div>`}
    ${held === 'active' && html`<div class="why true"><b>An operator holds it active.</b></div>`}
    ${description.root === index && held === 'tree' && html`<div class="why true"><b>It is the root</b> of the tree.</div>`}
    ${rows.map(({ from, why }) => html`<div key=${from} class=${`why ${why.level === 'yes' ? 'true' : why.level === 'no' ? 'false' : ''}`}>
      <button class="name" onClick=${() => openComponent(description.components[from].name)}>${description.components[from].name}</button> <span>${why.text}</span></div>`)}
    ${rows.length === 0 && description.root !== index && html`<p class="dim">No component activates it.</p>`}</section>`;
}

const order = ({ why }) => ['yes', 'no', 'off'].indexOf(why.level);
