// The fields of a state.

import { html } from '../../lib/dom.js';
import { open as openPanel } from '../../lib/dock.js';
import { Toggle } from '../../lib/ui.js';
import { addTransition, askTransition, remove } from '../canvas/actions.js';
import { focusOn } from '../canvas/keys.js';
import { waitText } from '../canvas/labels.js';
import { stage } from '../canvas/stage.js';
import { focusCode } from '../focus.js';
import { freeName } from '../machine.js';
import { change } from '../sources.js';
import { canGo, goTo } from '../stops.js';
import { Body, Children, Docs, Name, Stop, addHook } from './fields.js';

export function StateFields({ state, machine }) {
  const { name } = state;
  const free = (wished) => freeName(machine.component, wished);
  const own = machine.component.hooks.filter((hook) => hook.states.some((one) => one.text === name));
  const arrows = machine.arrows.filter((arrow) => arrow.from === name || arrow.to === name || (arrow.any && arrow.to !== name));
  return html`<h2><span class="kind machine">State</span> <${Name} value=${name} label="Name of the state" />${state.takes && html` <span class="dim" title="What it takes from the transitions that enter it">← ${state.takes}</span>`}</h2>
    <${Docs} text=${state.docs} onCommit=${(docs) => change({ edit: 'set_docs', function: name, docs })} />
    <div class="buttons">
      <${Toggle} on=${state.initial} label="Initial" title="The machine starts here" disabled=${state.initial} onChange=${() => change({ edit: 'set_initial', state: name })} />
      <${Toggle} on=${state.last && !state.end} label="Last" title="No transition leaves it" onChange=${(last) => change({ edit: 'set_last', state: name, last })} />
      ${['done', 'failed'].map((end) => html`<${Toggle} key=${end} on=${state.end === end} label=${end} title=${`The machine ends here: ${end}`} onChange=${(on) => change({ edit: 'set_end', state: name, end: on ? end : null })} />`)}
      <${Stop} of=${state.key} title="Stop when it is entered (b)" />
      ${canGo.value && html`<button onClick=${() => goTo(state.key)} title="The running machine goes to this state (G)">Go there</button>`}
      <button onClick=${() => { openPanel('code'); focusCode(); }} title="Enter in the canvas">Edit code</button></div>
    <${Children} owner=${name} arguments=${state.function.arguments} state=${true} />
    <section aria-label="Hooks"><h3>Hooks</h3>
      ${own.map((hook) => html`<div class="child" key=${hook.function.name.text}><em class="dim">${hook.role}</em> <${Name} value=${hook.function.name.text} label=${`Name of the ${hook.role} hook`} />
        <button class="small" aria-label=${`Remove ${hook.function.name.text} here`} onClick=${() => (hook.states.length > 1
          ? change({ edit: 'set_hook_states', hook: hook.function.name.text, states: hook.states.map((one) => one.text).filter((one) => one !== name) })
          : change({ edit: 'delete', function: hook.function.name.text }))}>×</button></div>`)}
      <div class="buttons"><button class="small" onClick=${() => addHook('entry', [name], free)}>Add an entry hook</button><button class="small" onClick=${() => addHook('exit', [name], free)}>Add an exit hook</button>
        ${own.some(({ role }) => role === 'before') ? '' : html`<button class="small" onClick=${() => addHook('before', [name], free)} title="It runs before the transitions of the state are tried">Add a hook before its transitions</button>`}</div></section>
    <section aria-label="Transitions"><h3>Transitions</h3>
      ${arrows.map((arrow) => html`<div class="child" key=${arrow.key}><button class="name" onClick=${() => focusOn(arrow.key)}>${arrow.name}</button> <span class="dim">${arrow.to === name && arrow.from !== name ? `← ${arrow.any ? 'any' : arrow.from}` : `→ ${arrow.to}`}${` ${waitText(arrow)}`}</span></div>`)}
      <div class="buttons">${state.children.filter(({ kind }) => kind !== 'rate').map(({ child }) => html`<button class="small" key=${child} title="A transition that needs no function" onClick=${() => change({ edit: 'add_arrow', transition: name, from: [name], to: name, when: `failed(${child})` })}>When ${child} fails</button>`)}<button class="small" onClick=${askTransition} title="r in the canvas">Add a transition…</button>
        <button class="small" onClick=${() => { const { x, y } = stage.boxes.get(name); addTransition([name], name, [x + 150, y]); }}>To itself</button></div></section>
    <${Body} of=${state.function} />
    <div class="buttons"><button onClick=${remove} title="Delete in the canvas">Delete the state</button></div>`;
}
