// The tab of a component, made from its description.

import { html, useEffect, useSignal } from '../lib/dom.js';
import { duration, niceStep, number, time } from '../lib/format.js';
import { openComponent, openSources } from '../lib/dock.js';
import { command, cursor, hello, selected, session, watch } from '../lib/store.js';
import { Empty } from '../lib/ui.js';
import { OutputList } from './component/outputs.js';
import { Modulations } from './component/modulations.js';
import { Parameters } from './component/parameters.js';
import { First, Why } from './component/why.js';
import { openByName } from '../vicode/sources.js';

const HOLDS = [['tree', 'by the tree'], ['active', 'active'], ['latent', 'latent']];

export function ComponentTab({ visible, params, retitle }) {
  const own = params.component;
  const shown = session.value;
  const name = own ?? selected.value ?? shown?.description.value?.components[shown.description.value.root]?.name;
  const index = name ? shown?.find(name) ?? -1 : -1;
  const component = shown?.description.value?.components[index];
  useEffect(() => {
    if (name) retitle(name);
  }, [name]);
  useEffect(() => {
    if (!visible.value || !component) return undefined;
    return watch({ costs: true, conditions: component.transitions.length > 0 ? [index] : [], info: component.info.map((_, info) => [index, info, 3]) });
  }, [visible.value, component, index]);

  if (!shown) return html`<${Empty} what="No component is chosen" help="Open a session, then click a component in the tree." />`;
  if (!component) return html`<${Empty} what=${own ? `This tree has no component ${own}` : 'No component is chosen'} help="Click a component in the tree or in the timeline." />`;
  return html`<article class="tab" key=${name}>
    <${Head} ...${{ shown, component, index, own }} />
    <${First} ...${{ shown, component, index }} />
    ${/* Controls stand above what changes its height while time goes on: they do not move under the pointer. */ ''}
    ${component.params.length > 0 && html`<${Parameters} ...${{ shown, component, index }} />`}
    <${ByHand} ...${{ shown, component, index }} />
    ${component.modulations.length > 0 && html`<${Modulations} ...${{ component, index }} />`}
    <${Why} ...${{ shown, component, index }} />
    ${component.doc && html`<p class="doc">${component.doc}</p>`}
    ${component.info.length > 0 && html`<${OutputList} ...${{ shown, component, index, visible }} />`}
  </article>`;
}

async function edit(name) {
  if (!(await openByName(name))) return;
  openSources();
}

function Head({ shown, component, index, own }) {
  const kind = shown.kinds.value[index] ?? 'component';
  const now = shown.moment.value?.components?.[index];
  const since = now && shown.moment.value ? shown.moment.value.time_us - now[4] : null;
  return html`<header class="head">
    <h2><span class=${`kind ${kind}`}>${component.name}</span><span class="grow"></span>
      ${!own && html`<button class="small" title="Open in a tab of its own" aria-label=${`Open ${component.name} in a tab of its own`} onClick=${() => openComponent(component.name, true)}>↗</button>`}
      ${hello.value?.source && html`<button class="small" title="Open its source in the designer" onClick=${() => edit(component.kind ?? component.name)}>${component.states.length > 0 ? 'edit states' : 'edit code'}</button>`}</h2>
    <p class="dim facts" role="status">${kind} · <b class=${now?.[0] ? 'yes' : ''}>${now?.[0] ? 'active' : 'latent'}</b>${since !== null && html` for ${duration(Math.max(0, since))}`}${now && now[1] !== 'tree' && html` · <b class="warn">held ${now[1]}</b>`}${cursor.value !== null && ` · at ${time(cursor.value)}`}</p>
  </header>`;
}

/** Makes an active machine go to a state; one that takes what a transition found cannot be entered by hand. */
function GoTo({ component, index, active }) {
  const go = ({ currentTarget }) => {
    command('go', { component: index, state: Number(currentTarget.value) });
    currentTarget.value = '';
  };
  const takes = (state) => component.transitions.some(({ to, carries }) => to === state && carries);
  return html`<select aria-label=${`State to which ${component.name} goes`} title=${active ? 'With the exit and entry hooks of a transition' : 'A latent machine goes to no state'} disabled=${!active} onChange=${go}>
    <option value="">go to…</option>${component.states.map(({ name }, state) => html`<option value=${state} disabled=${takes(state)}>${name}</option>`)}</select>`;
}

function ByHand({ shown, component, index }) {
  const can = shown.info.value.can.operate;
  const now = shown.moment.value?.components?.[index];
  const costs = shown.costs.value;
  const cost = costs?.components[index];
  const rate = useSignal(null);
  const wanted = now?.[3] ?? component.hz;
  const most = component.hz;
  const step = most > 10 ? 1 : niceStep(most ?? 1);
  const hold = (kind) => command('hold', { component: index, hold: kind }, kind === 'tree' ? `${component.name} is left to the tree` : `${component.name} is held ${kind}`);
  const setRate = (hz) => {
    rate.value = null;
    command('rate', { component: index, hz });
  };
  return html`<section aria-label="By hand"><h3>By hand</h3>
    <div class="row"><span>hold</span><div class="segments" role="radiogroup" aria-label=${`Hold ${component.name}`}>${HOLDS.map(([kind, title]) => html`
      <button role="radio" aria-checked=${now?.[1] === kind} class=${now?.[1] === kind ? 'on' : ''} disabled=${!can} onClick=${() => hold(kind)}>${title}</button>`)}</div></div>
    ${can && component.states.length > 0 && html`<div class="row"><span>state</span><${GoTo} ...${{ component, index, active: now?.[0] }} /></div>`}
    ${component.hz !== null && html`<div class="row"><span>rate</span>
      <input type="range" min=${step} max=${most} step=${step} disabled=${!can} aria-label=${`Rate of ${component.name}`} value=${rate.value ?? wanted}
        onInput=${(event) => { rate.value = Number(event.target.value); }} onChange=${(event) => setRate(Number(event.target.value))} />
      <span class=${`v ${now?.[3] !== null && now?.[3] !== undefined && now[3] !== component.hz ? 'changed' : ''}`}>${number(rate.value ?? wanted)} Hz</span>
      <button class="small" disabled=${!can || now?.[3] === component.hz} title=${`Declared: ${number(component.hz)} Hz`} onClick=${() => setRate(null)}>declared</button></div>`}
    <div class="row"><span>cost</span><span class="wide2">${cost?.[0]
      ? html`<b class=${component.budget_us && cost[1] > component.budget_us ? 'warn' : ''}>${number(cost[1])} µs</b> mean, ${number(cost[2])} µs longest${component.budget_us ? `, budget ${number(component.budget_us)} µs` : ''}, ${((cost[0] / costs.window_us) * 1e6).toFixed(0)} runs/s`
      : html`<span class="dim">${!costs && cursor.value !== null ? 'not known of this moment' : component.budget_us ? `not run now, budget ${number(component.budget_us)} µs` : 'not run now'}</span>`}</span></div>
  </section>`;
}

