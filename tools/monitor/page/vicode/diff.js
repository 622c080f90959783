// The difference from the last commit: both versions on one drawing, and the list of changes.

import { computed, effect, html, signal } from '../lib/dom.js';
import { Empty } from '../lib/ui.js';
import { request } from '../lib/connection.js';
import { focusOn } from './canvas/keys.js';
import { machineOf, stateKey } from './machine.js';
import { mode } from './mode.js';
import { component, machine, openedFile, openedText } from './sources.js';

/** The answer to `compare_file`, or {error: {text, help}}; null while it is not known. */
const difference = signal(null);
/** Time without typing after which the text is compared again, ms. */
const PAUSE = 250;

let timer = 0;
effect(() => {
  const [file, shown] = [openedFile.value, mode.value === 'diff'];
  void openedText.value;
  clearTimeout(timer);
  if (!file || !shown) return;
  if (difference.peek()?.file !== file) difference.value = null;
  timer = setTimeout(async () => {
    const answer = await request('source', { request: { type: 'compare_file', file } }).catch(({ text = 'it is not known', help = '' }) => ({ error: { text, help } }));
    if (openedFile.value === file) difference.value = { ...answer, file };
  }, difference.peek() ? PAUSE : 0);
});

const SIGNS = { added: '+', removed: '−', changed: '~' };
const own = () => difference.value?.comparison?.components.find(({ key }) => key === component.value) ?? null;

const marked = (one, change) => (change ? { ...one, mark: change, sign: SIGNS[change] } : one);

/** The machine with the parts of both versions and their marks; null if there is no difference to show. */
export const bothVersions = computed(() => {
  const change = own();
  const both = difference.value?.both?.[component.value];
  if (!change || !both) return null;
  const { states, arrows } = machineOf({ components: [both] }, component.value);
  const found = ({ name, from, to }) => change.marks.arrows.find((one) => one.name === name && one.from === from && one.to === to)?.change;
  const drawn = { states: states.map((one) => marked(one, change.marks.states[one.name])), arrows: arrows.map((one) => marked(one, found(one))) };
  return { ...machineOf({ components: [both] }, component.value), ...drawn, byKey: new Map([...drawn.states, ...drawn.arrows].map((one) => [one.key, one])) };
});

/** Shows a part on the drawing, if it is still in the text. */
function show({ part, name }) {
  const key = part === 'state' ? stateKey(name) : machine.value?.arrows.find((one) => one.name === name)?.key;
  if (key && machine.value?.byKey.has(key)) focusOn(key);
}

const Value = ({ text, sign }) => text !== null && html`<code class=${sign === '+' ? 'added' : 'removed'}>${sign} ${text}</code>`;

const Part = ({ one }) => html`<li class=${one.change}>
  <button class="name" onClick=${() => show(one)}><b>${SIGNS[one.change]} ${one.name}</b> <span class="dim">${one.part}</span></button>
  ${one.change === 'changed' && one.details.map(({ what, before, after }) => html`<div class="detail"><span class="dim">${what}</span><${Value} sign="−" text=${before} /><${Value} sign="+" text=${after} /></div>`)}</li>`;

export function DiffSide() {
  const now = difference.value;
  if (!now) return html`<${Empty} what="Comparing…" help="The file is compared with its last commit." />`;
  if (now.error) return html`<${Empty} what=${now.error.text} help=${now.error.help} />`;
  const change = own();
  const rest = now.comparison.components.filter((one) => one !== change);
  return html`<h3>${now.new ? 'The last commit does not have this file' : html`Since commit <code>${now.revision}</code>`}</h3>
    ${change ? html`<ul class="changes" aria-label="Changes">${change.parts.map((one) => html`<${Part} one=${one} />`)}</ul>` : html`<p class="dim">${component.value ?? 'The file'} has no difference.</p>`}
    ${rest.length > 0 && html`<h3>Also different</h3><ul>${rest.map(({ key }) => html`<li><button class="name" onClick=${() => { component.value = key; }}>${key}</button></li>`)}</ul>`}
    ${now.comparison.parameters.length > 0 && html`<h3>Parameters</h3><ul class="changes">${now.comparison.parameters.map((one) => html`<${Part} one=${one} />`)}</ul>`}`;
}

export const DiffLegend = () => html`<p class="legend" role="note"><span class="added">+ added, thick</span><span class="removed">− removed, dotted</span><span class="changed">~ changed</span><span class="dim">grey: equal</span></p>`;
