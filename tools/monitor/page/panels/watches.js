// Watches: conditions that mark the timeline when they have held for a time, and can pause a simulated world.

import { html, useEffect, useSignal } from '../lib/dom.js';
import { valueNow } from '../lib/curves.js';
import { duration, number, time } from '../lib/format.js';
import { shownTime } from '../lib/axis.js';
import { notify, seek, session } from '../lib/store.js';
import { Bar, Empty, Toggle } from '../lib/ui.js';
import { draft, findings, keep, parts, remove, watches } from '../lib/watches.js';

/** Conditions that are offered while there is none. */
const OFFERED = 3;
const NUMBER = /^(f32|f64|[iu](8|16|32|64|size))$/;

export function Watches({ visible, retitle }) {
  const shown = session.value;
  const description = shown?.description.value;
  const typed = useSignal('');
  const edited = useSignal(null);
  const fault = useSignal('');
  const pause = useSignal(false);
  const alerts = [...findings.value.values()].reduce((sum, { fired }) => sum + fired.length, 0);
  useEffect(() => retitle(alerts > 0 ? `Watches ${alerts}` : 'Watches'), [alerts]);
  useEffect(() => {
    if (!draft.value) return;
    const known = watches.value.find(({ text }) => text === draft.value);
    [typed.value, edited.value, pause.value, draft.value] = [draft.value, known?.text ?? null, known?.pause ?? false, ''];
  }, [draft.value]);
  if (!description) return html`<${Empty} what="Nothing to watch yet" help="Open a world, a robot or a recording." />`;
  const add = (event) => {
    event.preventDefault();
    try {
      keep(shown, typed.value.trim(), pause.value, edited.value);
      [typed.value, edited.value, pause.value] = ['', null, false];
    } catch ({ message }) {
      fault.value = message;
      notify('error', message, 'write a condition and perhaps its time, as in Component.output > 0.2 for 1 s');
    }
  };
  const all = description.components.flatMap((component) => component.info.map((info) => `${component.name}.${info.name}`));
  return html`<${Bar} label="Watches">
      <form class="join" onSubmit=${add}><input class="condition" list="all-watched" placeholder="Component.output > 0.2 for 1 s" aria-label="Condition to watch" maxlength="500" aria-invalid=${fault.value !== ''} title=${fault.value} value=${typed.value} onInput=${(event) => { [typed.value, fault.value] = [event.target.value, '']; }} />
        <datalist id="all-watched">${all.map((name) => html`<option value=${name}></option>`)}</datalist>
        <${Toggle} on=${pause.value} label="Pause the world" title="When the watch fires, a simulated world is paused, and the page shows that moment" onChange=${(on) => { pause.value = on; }} />
        <button disabled=${!typed.value.trim()}>${edited.value === null ? 'Watch' : 'Change'}</button></form>
    <//>
    ${watches.value.length === 0
      ? html`<${Empty} what="No watch yet" help=${html`A watch marks the timeline when its condition has held for a time.${examples(description).map((text) => html` <button class="small" onClick=${() => { typed.value = text; }}>${text}</button>`)}`} />`
      : html`<ul class="watches" aria-label="Watches">${watches.value.map((one) => html`<${Watch} key=${one.text} ...${{ shown, one, visible }} />`)}</ul>`}`;
}

/** Conditions over numbers of this tree. */
const examples = (description) => description.components
  .flatMap(({ name, info }) => info.filter(({ type, unit }) => NUMBER.test(type) && unit).slice(0, 1).map((one) => `${name}.${one.name} > 0.2 for 1 s`)).slice(0, OFFERED);

function Watch({ shown, one: { text, pause }, visible }) {
  const { condition, hold_us: hold } = parts(text);
  const { spans = [], fired = [], curve, error } = findings.value.get(text) ?? {};
  const at = visible.value ? shownTime.value : 0;
  const span = spans.findLast(([begin, end]) => begin <= at && (end === null || at < end));
  const [before, after] = [fired.findLast((time) => time < at), fired.find((time) => time > at)];
  const value = curve?.inputs.length > 0 && visible.value ? inputsNow(shown, curve) : '';
  return html`<li class=${span ? 'true' : ''}><i class="dot" aria-hidden="true"></i>
    <span><b>${condition}</b>${hold > 0 && html` <span class="dim">for ${duration(hold)}</span>`}</span>
    <span class="v">${value}</span>
    <span class="now">${error ? html`<span class="error">${error}</span>` : span ? `holds for ${duration(at - span[0])}` : 'does not hold'}</span>
    <span class="join"><span class="dim">fired ${fired.length === 1 ? 'once' : `${fired.length} times`}</span>
      <button aria-label=${`Previous alert of ${text}`} disabled=${before === undefined} title=${before === undefined ? '' : time(before)} onClick=${() => seek(before)}>⟨</button><button aria-label=${`Next alert of ${text}`} disabled=${after === undefined} title=${after === undefined ? '' : time(after)} onClick=${() => seek(after)}>⟩</button>
      <${Toggle} on=${pause} label="Pause" title="Pause a simulated world when it fires" onChange=${(on) => keep(shown, text, on, text)} />
      <button onClick=${() => { draft.value = text; }}>Edit</button><button aria-label=${`Remove ${text}`} onClick=${() => remove(text)}>×</button></span></li>`;
}

/** The values that a condition compares, at the shown moment. */
function inputsNow(shown, { inputs }) {
  const all = inputs.slice(0, 3).map((input) => valueNow(shown, { inputs: [input], begin: () => (at, [value]) => value }));
  return `${all.map(number).join(', ')}${inputs.length === 1 && inputs[0].unit && !inputs[0].unit.includes(',') ? ` ${inputs[0].unit}` : ''}`;
}
