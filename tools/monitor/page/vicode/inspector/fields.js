// Parts of the inspector.

import { renameUsed } from '../rename.js';
import { html, useState } from '../../lib/dom.js';
import { Field, Toggle } from '../../lib/ui.js';
import { addChild } from '../canvas/actions.js';
import { change, offsets } from '../sources.js';
import { conditionAt, setCondition, stopKeys, toggleStop, writtenWith } from '../stops.js';

/** A text, such as a doc comment. */
export function Docs({ text, label = 'Documentation', onCommit }) {
  const [typed, setTyped] = useState(null);
  const commit = () => {
    if (typed !== null && typed !== text) onCommit(typed);
    setTyped(null);
  };
  return html`<textarea class="docs-field" aria-label=${label} rows=${Math.min(5, Math.max(2, text.split('\n').length))} placeholder="What it does" value=${typed ?? text}
    onInput=${(event) => setTyped(event.target.value)} onBlur=${commit} onKeyDown=${(event) => {
      if (event.key === 'Enter' && (event.ctrlKey || event.metaKey)) commit();
      if (event.key === 'Escape') setTyped(null);
    }}></textarea>`;
}

/** The name of a function, that can be changed. */
export const Name = ({ value, label = 'Name' }) => html`<${Field} value=${value} label=${label} spellcheck="false" onCommit=${(to) => to.trim() && renameUsed(value, to.trim())} />`;

const KINDS = [['requirement', 'reads'], ['modulation', 'writes'], ['rate', 'sets rate']];

/** Children of a function, with their kinds. */
export function Children({ owner, arguments: all, state }) {
  const links = all.filter(({ input }) => input === 'link');
  return html`<section aria-label="Children"><h3>Children</h3>
    ${links.map(({ child, kind }) => html`<div class="child" key=${child}><span class=${`link-name to-${kind}`}>${child}</span>
      <select aria-label=${`Link to ${child}`} onChange=${(event) => change({ edit: 'set_child_kind', function: owner, child, kind: event.target.value })}>${KINDS.map(([value, text]) => html`<option value=${value} selected=${value === kind}>${text}</option>`)}</select>
      <button class="small" aria-label=${`Remove ${child}`} onClick=${() => change({ edit: 'remove_child', function: owner, child })}>×</button></div>${writtenWith(child) && html`<p class="dim">${writtenWith(child)}</p>`}`)}
    ${links.length === 0 && html`<p class="dim">None${state ? ': drag a component here onto the state' : ''}.</p>`}
    <button class="small" onClick=${() => addChild(owner)}>Add a child…</button></section>`;
}

/** The code of a function, to read; it is edited in the code panel. */
export const Body = ({ of }) => {
  const text = of.body ? offsets.value.slice(of.body).trim() : '';
  return text ? html`<section aria-label="Code"><h3>Code</h3><pre class="diff">${text.replace(/\n {8}/g, '\n')}</pre></section>` : null;
};

/** The breakpoint of a state or transition, with its condition. */
export const Stop = ({ of, title }) => html`<${Toggle} on=${stopKeys.value.has(of)} label="Breakpoint" title=${title} onChange=${() => toggleStop(of)} />
  ${stopKeys.value.has(of) && html`<${Field} value=${conditionAt(of)} label="Condition of the breakpoint" placeholder="only if Component.output > 0.5" title="The world goes on if it does not hold; this browser keeps it" spellcheck="false" onCommit=${(text) => setCondition(of, text.trim())} />`}`;

const VERBS = { entry: 'enter', exit: 'leave', before: 'prepare' };
const PROMPTS = { entry: 'on_entry', exit: 'on_exit', start: 'on_start', stop: 'on_stop' };

/** Adds a hook; its name can be changed afterwards. */
export const addHook = (role, states, free) => change({ edit: 'add_hook', name: free(states.length > 0 ? `${VERBS[role]}_${states[0]}` : PROMPTS[role]), role, states });

