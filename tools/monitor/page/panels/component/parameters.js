// Parameters of a component: default, range, wanted and actual value; undo, reset, save.

import { html, useSignal, useState } from '../../lib/dom.js';
import { openSources } from '../../lib/dock.js';
import { exact, niceStep, typedNumber, words } from '../../lib/format.js';
import { act, cursor, hello, notify, redo, redoParams, setParams, undo, undoParams } from '../../lib/store.js';
import { jump } from '../../vicode/problems.js';

const CHOICE = { bool: ['true', 'false'] };

export function Parameters({ shown, component, index }) {
  const actual = shown.params.value[index] ?? [];
  const can = shown.info.value.can.operate && shown.description.value.tunable;
  const onlyChanged = useSignal(false);
  const changed = component.params.map((param, number) => (actual[number] !== param.default ? number : null)).filter((number) => number !== null);
  const reset = () => setParams(changed.map((param) => ({ component: index, param, value: component.params[param].default })));
  const listed = component.params.map((param, number) => ({ param, number })).filter(({ number }) => !onlyChanged.value || changed.includes(number));
  return html`<section aria-label="Parameters"><h3>Parameters${cursor.value !== null && html` <span>${shown.info.value.kind === 'recording' ? 'at the beginning' : 'of the present'}</span>`}
      ${component.params.length > 8 && html`<button class=${`small ${onlyChanged.value ? 'on' : ''}`} role="switch" aria-checked=${onlyChanged.value} onClick=${() => { onlyChanged.value = !onlyChanged.value; }}>changed only</button>`}</h3>
    ${!shown.description.value.tunable && html`<p class="dim">This tree was built without <code>tunable</code>: its parameters are constants.</p>`}
    ${listed.map(({ param, number }) => html`<${Parameter} key=${param.name} ...${{ param, component: index, number, actual: actual[number], can }} />`)}
    ${changed.length > 0 && html`<${Save} ...${{ shown, index, changed, can, reset }} />`}
    ${undo.value.length + redo.value.length > 0 && html`<p class="save"><button class="small" disabled=${undo.value.length === 0} onClick=${undoParams} title="Key u">Undo last change</button><button class="small" disabled=${redo.value.length === 0} onClick=${redoParams} title="Key U">Redo</button></p>`}
  </section>`;
}

function Parameter({ param, component, number: place, actual, can }) {
  const wanted = useSignal(null);
  const refused = useSignal(null);
  const value = wanted.value ?? actual;
  const changed = actual !== param.default;
  const send = async (next) => {
    refused.value = null;
    wanted.value = next;
    const done = await setParams([{ component, param: place, value: next }]);
    if (done === undefined) refused.value = next;
    else if (hello.value?.source && uses === null) showUses();
    wanted.value = null;
  };
  const [uses, setUses] = useState(null);
  // Who uses it is shown with the first change, and by its name.
  const showUses = async () => setUses((await act('param_uses', { component, param: place })) ?? null);
  const range = 'min' in param ? `${shownValue(param.min)} to ${shownValue(param.max)}` : '';
  const title = `${param.doc}\nDefault ${shownValue(param.default)}${param.unit ? ` ${param.unit}` : ''}${range ? `, range ${range}` : ''}`;
  return html`<div class=${`row param ${changed ? 'changed' : ''} ${wanted.value !== null && wanted.value !== actual ? 'pending' : ''}`} title=${title}>
    ${hello.value?.source ? html`<button class="name" aria-expanded=${uses !== null} aria-label=${`Uses of ${param.name}`} onClick=${() => (uses ? setUses(null) : showUses())}>${words(param.name)}</button>` : html`<label>${words(param.name)}</label>`}
    <${Control} ...${{ param, value, can, send, wanted }} />
    ${changed ? html`<button class="small reset" disabled=${!can} aria-label=${`Reset ${param.name} to ${shownValue(param.default)}`} title=${`Reset to the default, ${shownValue(param.default)}`} onClick=${() => send(param.default)}>↺</button>` : html`<span></span>`}
    ${wanted.value !== null && wanted.value !== actual && html`<span class="detail">actual ${shownValue(actual)}</span>`}
    ${changed && wanted.value === null && html`<span class="detail">default ${shownValue(param.default)}${range && ` · ${range}`}</span>`}
    ${uses && html`<${Uses} uses=${uses} />`}
    ${refused.value !== null && html`<span class="detail error">${shownValue(refused.value)} was refused</span>`}
  </div>`;
}

/** Where a parameter is declared and read: a click opens the place in the designer. */
function Uses({ uses }) {
  const show = async (use) => {
    openSources();
    await jump(use);
  };
  return html`<ul class="detail uses" aria-label="Uses in the source">${uses.length === 0 && html`<li>No file below the folder of --source has it.</li>`}
    ${uses.map((use) => html`<li><button class="small" title=${use.text} onClick=${() => show(use)}>${use.file.split('/').at(-1)}:${use.line}</button> <code>${use.text}</code></li>`)}</ul>`;
}

/** A value as it is in force, in the text that can be typed. */
const shownValue = (value) => (typeof value === 'number' ? exact(value) : String(value));

/** A slider and a number, or a choice. A slider sends when it is released, a number with Enter. */
function Control({ param, value, can, send, wanted }) {
  const typed = useSignal(null);
  const { name, kind } = param;
  if (kind === 'bool' || kind === 'choice') {
    const variants = kind === 'bool' ? CHOICE.bool : param.variants.map((variant) => variant.name);
    return html`<select class="wide2" aria-label=${name} disabled=${!can} onChange=${(event) => send(kind === 'bool' ? event.target.value === 'true' : event.target.value)}>
      ${variants.map((variant) => html`<option selected=${String(value) === variant}>${variant}</option>`)}</select>`;
  }
  if (kind === 'unknown') return html`<span class="wide2 dim">of a newer version</span>`;
  const step = param.step ?? (kind === 'f32' ? niceStep(param.max - param.min) : 1);
  const commit = () => {
    const text = typed.value;
    typed.value = null;
    if (text === null || text.trim() === '') return;
    const next = Number(typedNumber(text));
    if (!Number.isFinite(next)) notify('error', `“${text}” is no number`, `${name} is between ${shownValue(param.min)} and ${shownValue(param.max)}`);
    else if (next !== value) send(next);
  };
  const keys = (event) => {
    if (event.key === 'Enter') commit();
    if (event.key === 'Escape') typed.value = null;
  };
  return html`<input type="range" min=${param.min} max=${param.max} step=${step} value=${value} disabled=${!can} aria-label=${name}
      onInput=${(event) => { wanted.value = Number(event.target.value); }} onChange=${(event) => send(Number(event.target.value))} />
    <span class="v"><input class="number" type="text" inputmode="decimal" aria-label=${`${name}, value`} disabled=${!can} value=${typed.value ?? shownValue(value)}
      onInput=${(event) => { typed.value = event.target.value; }} onBlur=${commit} onKeyDown=${keys} /> <span class="unit">${param.unit ?? ''}</span></span>`;
}

function Save({ shown, index, changed, can, reset }) {
  const name = useSignal(shown.info.value.kind === 'world' ? shown.info.value.name.split(/[ ,]/)[0] : 'robot');
  const diff = useSignal(null);
  const tune = () => act('save_tune', { params: changed.map((param) => [index, param]), name: name.value }, `saved to the tune file ${name.value}.toml`);
  const source = async () => {
    for (const param of changed) {
      const written = await act('save_source', { component: index, param });
      if (written === undefined) return;
      diff.value = `${written.path}\n${written.diff}`;
    }
    notify('done', `${changed.length} default${changed.length > 1 ? 's were' : ' was'} written to the source`);
  };
  return html`<div class="save"><span class="changed">${changed.length} changed</span>
      <button class="small" disabled=${!can} onClick=${reset}>Reset all</button>
      <span class="join"><input aria-label="Name of the tune file" value=${name.value} onInput=${(event) => { name.value = event.target.value; }} /><button class="small" onClick=${tune}>Save to tune file</button></span>
      ${hello.value?.source && html`<button class="small" onClick=${source} title="Writes the values as new defaults into the Rust file">Save to source</button>`}</div>
    ${diff.value && html`<pre class="diff" aria-label="Change of the source">${diff.value}</pre>`}`;
}
