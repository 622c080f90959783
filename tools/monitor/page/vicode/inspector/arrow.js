// The fields of a transition.

import { html } from '../../lib/dom.js';
import { open as openPanel } from '../../lib/dock.js';
import { Field, Toggle } from '../../lib/ui.js';
import { remove } from '../canvas/actions.js';
import { focusCode } from '../focus.js';
import { change, refusal, wish } from '../sources.js';
import { Body, Children, Docs, Name, Stop } from './fields.js';

export function ArrowFields({ arrow, machine }) {
  const { owner: name, arrow: index, sources, to, bare, parts } = arrow;
  const names = machine.states.map((state) => state.name);
  const setSources = (from) => {
    if (from.length === 0) return;
    wish([`t:${name}:${index}:${from.includes(arrow.from) ? arrow.from : from[0]}`]);
    change({ edit: 'set_sources', transition: name, arrow: index, from });
  };
  const toggle = (state, on) => setSources(on ? [...sources.filter((one) => one !== '*'), state] : sources.filter((one) => one !== state));
  const setTimer = (typed) => {
    const text = typed.trim();
    const after_ms = text === '' ? null : Number(text);
    if (after_ms !== null && !(Number.isInteger(after_ms) && after_ms >= 0)) refusal.value = { text: `${text} is no time`, help: 'Type whole milliseconds, or nothing.' };
    else change({ edit: 'set_timer', transition: name, arrow: index, after_ms });
  };
  const setWait = (key) => (typed) => change({ edit: 'set_wait', transition: name, arrow: index, key, value: typed.trim() || null });
  const wait = (key, text, hint) => html`<div class="row"><span>${key}</span><span><${Field} value=${arrow[key] ?? ''} label=${text} placeholder=${hint} spellcheck="false" onCommit=${setWait(key)} /></span></div>`;
  return html`<h2><span class="dim">Transition</span> ${bare ? html`<b>${arrow.name}</b>` : html`<${Name} value=${name} label="Name of the transition" />`}${arrow.carries !== null && html` <span class="dim" title=${`What it hands over to ${to}`}>carries ${arrow.carries}</span>`}</h2>
    ${!bare && html`<${Docs} text=${arrow.docs} onCommit=${(docs) => change({ edit: 'set_docs', function: name, docs })} />`}
    <section aria-label="Way"><h3>From${parts > 1 ? html` <span class="dim">${index + 1} of ${parts} ways of this condition</span>` : ''}</h3>
      <div class="buttons">${!bare && html`<${Toggle} on=${arrow.any} label="any state" title="From all states but the target" onChange=${(on) => setSources(on ? ['*'] : names.filter((one) => one !== to).slice(0, 1))} />
        ${names.map((one) => html`<${Toggle} key=${one} on=${sources.includes(one)} label=${one} title=${`Leaves ${one}`} onChange=${(on) => toggle(one, on)} />`)}`}</div>
      <div class="row"><span>to</span><select aria-label="Target" onChange=${(event) => change({ edit: 'set_target', transition: name, arrow: index, to: event.target.value })}>${names.map((one) => html`<option value=${one} selected=${one === to}>${one}</option>`)}</select></div>
      <div class="row"><span>after</span><span><${Field} value=${arrow.after_ms ?? ''} label="Timer, ms" inputmode="numeric" width="short" onCommit=${setTimer} /> <span class="unit">ms in the state, at least</span></span></div>
      ${wait('after', 'Timer, a parameter', 'Params::field')}${wait('when', 'Result of a child', 'failed(Child)')}${arrow.when !== null && wait('times', 'Times in a row', 'any number')}</section>
    <div class="buttons"><${Stop} of=${arrow.key} title="Stop when it is taken (b)" />
      ${!bare && html`<button onClick=${() => { openPanel('code'); focusCode(); }} title="Enter in the canvas">Edit condition</button>`}</div>
    ${!bare && html`<${Children} owner=${name} arguments=${arrow.function.arguments} /><${Body} of=${arrow.function} />`}
    <div class="buttons"><button onClick=${remove} title="Delete in the canvas">Delete the transition</button></div>`;
}
