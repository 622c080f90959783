// The fields of a component.

import { html } from '../../lib/dom.js';
import { Field, Toggle } from '../../lib/ui.js';
import { freeName } from '../machine.js';
import { renameUsed } from '../rename.js';
import { change, edit, model } from '../sources.js';
import { Docs, Name, addHook } from './fields.js';
import { Trees } from './trees.js';

const OPTIONS = [['hz', 'rate', 'Hz'], ['budget_us', 'budget', 'µs'], ['writers', 'of several writers', 'first or last']];

export function ComponentFields({ machine }) {
  const { component, name } = machine;
  const { settings } = component.options;
  const value = (key) => settings.find((one) => one.key.text === key)?.value?.text ?? '';
  const set = (option, typed) => change({ edit: 'set_option', option, value: typed.trim() === '' ? null : typed.trim() });
  const free = (wished) => freeName(component, wished);
  const hooks = [...machine.start, ...machine.stop];
  return html`<h2><span class="dim">Component</span> ${name}</h2>
    <${Docs} text=${component.docs.text} onCommit=${(docs) => change({ edit: 'set_docs', docs })} />
    <section aria-label="Options"><h3>Options</h3>
      ${OPTIONS.map(([key, label, unit]) => html`<div class="row" key=${key}><span>${label}</span><span><${Field} value=${value(key)} label=${`${label}, ${unit}`} width="short" onCommit=${(typed) => set(key, typed)} /> <span class="unit">${unit}</span></span></div>`)}
      ${component.states.length > 0 && html`<div class="buttons"><${Toggle} on=${settings.some((one) => one.key.text === 'resume')} label="Resume" title="Continues in its last state when it becomes active again" onChange=${(on) => change({ edit: 'set_option', option: 'resume', value: on ? '' : null })} /></div>`}</section>
    <section aria-label="Start and stop"><h3>Start and stop</h3>
      ${hooks.map((hook) => html`<div class="child" key=${hook.function.name.text}><em class="dim">${hook.role}</em> <${Name} value=${hook.function.name.text} label=${`Name of the ${hook.role} hook`} />
        <button class="small" aria-label=${`Delete ${hook.function.name.text}`} onClick=${() => change({ edit: 'delete', function: hook.function.name.text })}>×</button></div>`)}
      <div class="buttons">${['start', 'stop'].filter((role) => !hooks.some((hook) => hook.role === role)).map((role) => html`<button class="small" onClick=${() => addHook(role, [], free)}>Add a ${role} hook</button>`)}</div></section>
    ${[['info', 'Outputs'], ['modulations', 'Modulations'], ['work', 'Beside the loop']].map(([key, title]) => component[key].length > 0 && html`<section aria-label=${title}><h3>${title}</h3>
      ${component[key].map(({ function: { name: own, docs } }) => html`<div class="child" key=${own.text} title=${docs.text}><${Field} value=${own.text} label=${`Name of ${own.text}`} spellcheck="false" onCommit=${(to) => to.trim() && renameUsed(own.text, to.trim())} /></div>`)}</section>`)}
    <${Parameters} /><${Trees} />`;
}

/** Defaults of the parameters of the file. */
function Parameters() {
  return (model.value?.parameters ?? []).map((one) => html`<section aria-label=${`Parameters ${one.name.text}`} key=${one.name.text}><h3>${one.name.text}</h3>
    ${one.parameters.map((param) => {
      const text = param.keys.find((key) => key.key.text === 'default')?.value?.text ?? '';
      return html`<div class="row" key=${param.name.text} title=${param.docs.text}><span>${param.name.text}</span><span><${Field} value=${text} label=${`Default of ${param.name.text}`} width="short" onCommit=${(typed) => edit([{ edit: 'set_default', parameters: one.name.text, parameter: param.name.text, value: typed }])} /></span></div>`;
    })}</section>`);
}
