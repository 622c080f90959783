// Names and roles of the activation trees of a file.

import { html } from '../../lib/dom.js';
import { Field } from '../../lib/ui.js';
import { edit, model } from '../sources.js';

const Remove = ({ what, onClick }) => html`<button class="small" aria-label=${`Remove ${what} from the tree`} title="From the tree only" onClick=${onClick}>×</button>`;

/** A text field of a name; an empty one changes nothing. */
const Name = ({ value, label, onName }) => html`<${Field} value=${value} label=${label} spellcheck="false" onCommit=${(to) => to.trim() && onName(to.trim())} />`;

function Tree({ tree: { name: tree, members, roles } }) {
  const change = (kind, fields) => edit([{ edit: kind, tree, ...fields }]);
  const types = [...new Set(members.map(({ ty }) => ty))];
  return html`<section aria-label=${`Tree ${tree}`}><h3>Tree ${tree}</h3>
    <p class="dim">${types.join(', ')}</p>
    ${members.filter(({ name }) => name !== null).map(({ name, ty }) => html`<div class="child" key=${name}>
      <${Name} value=${name} label=${`Name of ${ty}`} onName=${(to) => change('rename_member', { member: name, to })} /> <span class="dim">${ty}</span>
      <${Remove} what=${name} onClick=${() => change('rename_member', { member: name, to: null })} /></div>`)}
    ${roles.map(({ role, provider }) => html`<div class="child" key=${role}>
      <${Name} value=${role} label=${`Name of the role ${role}`} onName=${(to) => edit([{ edit: 'rename_role', role, to }])} />
      <select aria-label=${`Provider of ${role}`} onChange=${(event) => change('set_provider', { role, provider: event.target.value })}>${types.map((one) => html`<option value=${one} selected=${one === provider}>${one}</option>`)}</select>
      <${Remove} what=${role} onClick=${() => change('set_provider', { role, provider: null })} /></div>`)}
    ${roles.length > 0 && html`<p class="dim">A role gets its new name in this file only.</p>`}</section>`;
}

/** The trees of the open file. */
export const Trees = () => (model.value?.trees ?? []).map((tree) => html`<${Tree} key=${tree.name} tree=${tree} />`);
