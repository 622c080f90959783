// Any outputs as a table: values at the shown moment, with their range, also of sessions side by side; or their history.

import { html, untracked, useEffect, useSignal } from '../lib/dom.js';
import { shownTime } from '../lib/axis.js';
import { number, text, time, valueAt, words } from '../lib/format.js';
import { valueNow } from '../lib/curves.js';
import { groupsOf, shownText, useAllBeside, useLabels } from '../lib/group.js';
import { curvesOf, faultOf, readVersions, samplesAt, titleOf, useCurves } from '../lib/series.js';
import { span, statistics } from '../lib/span.js';
import { companions, seek, session, show, visibleRange } from '../lib/store.js';
import { besideColour } from '../lib/theme.js';
import { Bar, Empty, Toggle } from '../lib/ui.js';

/** Rows of a history. */
const ROWS = 200;
/** Time between two updates of the rows of sessions, ms. */
const UPDATE_MS = 200;

/**
 * `params`: the `rows`, whether they are a `history`, or the columns of a table of `sessions`; of that one, the output that names the
 * `group` (lib/group.js).
 */
export function Table({ visible, params, remember }) {
  const names = useSignal(params.rows ?? []);
  const history = useSignal(params.history ?? false);
  const turned = useSignal(params.sessions ?? false);
  useAllBeside(turned.value);
  const typed = useSignal('');
  const fault = useSignal('');
  const shown = session.value;
  const description = shown?.description.value;
  const { own, beside, key } = curvesOf(shown, names.value);
  useCurves([...own, ...beside], shown, visible, key);
  if (!description) return html`<${Empty} what="Nothing to list yet" help="Open a world, a robot or a recording." />`;
  const keep = (rows) => {
    names.value = rows;
    remember({ rows, history: history.value, sessions: turned.value });
  };
  // The name of a component stands for all its outputs.
  const add = (name) => {
    const all = description.components[shown.find(name.normalize('NFC'))]?.info.map((info) => `${name}.${info.name}`) ?? [name];
    const fault = all.map((one) => faultOf(shown, one)).find(Boolean) ?? '';
    if (!fault) keep([...new Set([...names.value, ...all])]);
    return fault;
  };
  const submit = (event) => {
    event.preventDefault();
    fault.value = typed.value.trim() && add(typed.value.trim());
    if (!fault.value) typed.value = '';
  };
  const drop = (event) => {
    event.preventDefault();
    const name = event.dataTransfer.getData('application/x-jmanager-curve');
    if (name) add(name);
  };
  const known = description.components.flatMap(({ name, info }) => [name, ...info.map((one) => `${name}.${one.name}`)]);
  const remove = (name) => keep(names.value.filter((one) => one !== name));
  return html`<div class="plot" onDragOver=${(event) => event.preventDefault()} onDrop=${drop}><${Bar} label="Table">
      <form class="join" onSubmit=${submit}><input list="all-rows" placeholder="Output, component or f(x)…" aria-label="Output to list" aria-invalid=${fault.value !== ''} title=${fault.value} value=${typed.value} onInput=${(event) => { [typed.value, fault.value] = [event.target.value, '']; }} /><button>Add</button></form>
      <datalist id="all-rows">${known.map((name) => html`<option value=${name}></option>`)}</datalist>
      <${Toggle} on=${history.value} label="History" title="A row for each time at which a value changed" onChange=${(on) => { [history.value, turned.value] = [on, on ? false : turned.value]; keep(names.value); }} />
      <${Toggle} on=${turned.value} label="Sessions" title="A row for each session: all with this tree are shown beside the chosen one" onChange=${(on) => { [turned.value, history.value] = [on, on ? false : history.value]; keep(names.value); }} /><//>
    ${own.length === 0
      ? html`<${Empty} what=${names.value.length > 0 ? 'This tree has none of these outputs' : 'No output yet'} help="Drag an output from a component tab onto this panel, or name one, or a component, above." />`
      : html`<div class="log" tabindex="0" role="group" aria-label="Listed outputs">${visible.value && (turned.value ? html`<${Sessions} ...${{ own, beside, visible }} group=${params.group} />` : history.value ? html`<${History} curves=${[...own, ...beside]} />` : html`<${Values} ...${{ own, beside, remove }} />`)}</div>`}
  </div>`;
}

/** The value of a curve at the shown moment, as text. */
function shownValue(curve) {
  const value = valueNow(curve.of, curve);
  return value === null && curve.place ? text(valueAt(curve.of.output(...curve.place).now.value?.value, curve.path)) : number(value);
}

const Session = ({ curve: { of, beside } }) => html`<th class="n" scope="col" ref=${(head) => { if (head) head.style.color = beside === undefined ? '' : besideColour(beside); }}>${of.title}</th>`;

function Values({ own, beside, remove }) {
  readVersions(own);
  const others = [...new Map(beside.map((curve) => [curve.of, curve])).values()];
  const [from, until] = span.value ?? visibleRange.value;
  return html`<table class="stats values" aria-label="Values"><thead><tr><th scope="col">output</th><${Session} curve=${own[0]} />${others.map((curve) => html`<${Session} curve=${curve} />`)}<th scope="col">unit</th><th class="n" scope="col">least</th><th class="n" scope="col">largest</th><th><span class="dim">${time(from)} – ${time(Math.min(until, shownTime.value))}</span></th></tr></thead>
    <tbody>${own.map((curve) => {
      const found = statistics(samplesAt(curve, [0, until]), [from, until]);
      return html`<tr key=${curve.name}><th scope="row">${curve.name}</th><td class="n">${shownValue(curve)}</td>
        ${others.map(({ of }) => html`<td class="n">${beside.filter((one) => one.of === of && one.name === curve.name).map(shownValue)}</td>`)}
        <td class="unit">${curve.unit}</td><td class="n">${found ? number(found.min) : '–'}</td><td class="n">${found ? number(found.max) : '–'}</td><td><button class="small" aria-label=${`Remove ${curve.name}`} onClick=${() => remove(curve.name)}>×</button></td></tr>`;
    })}</tbody></table>`;
}

/** A row for each session, whose name chooses it, and a column for each output. */
function Sessions({ own, beside, visible, group }) {
  const all = [session.value, ...companions.value.map(({ of }) => of)];
  useLabels(all, [], group, visible);
  const updated = useSignal(0);
  useEffect(() => {
    const timer = setInterval(() => { updated.value += 1; }, UPDATE_MS);
    return () => clearInterval(timer);
  }, []);
  void updated.value;
  // Not with each of the many values that come.
  const rows = untracked(() => {
    const colours = group && groupsOf(all, group);
    const cell = (of, { name }) => [...own, ...beside].filter((one) => one.of === of && one.name === name).map(shownValue);
    const row = (of) => ({ of, name: of.title, colour: colours?.get(shownText(of, group)), cells: own.map((curve) => cell(of, curve)) });
    return all.map(row).sort((one, other) => one.name.localeCompare(other.name, 'en', { numeric: true }));
  });
  const columns = own.map(({ name, unit }) => ({ name, unit, parts: name.match(/^(\w+)\.(.+)$/u) ?? [null, '', name] }));
  // Outputs of a component that follow each other stand below its name.
  const components = columns.reduce((all, { parts: [, of] }) => (all.at(-1)?.of === of ? [...all.slice(0, -1), { of, span: all.at(-1).span + 1 }] : [...all, { of, span: 1 }]), []);
  return html`<table class="stats values group" aria-label="Sessions"><thead><tr><td></td>${components.map(({ of, span }) => html`<th scope="colgroup" colspan=${span}>${of}</th>`)}</tr>
      <tr><th scope="col">session</th>${columns.map(({ name, unit, parts }) => html`<th key=${name} scope="col" title=${name}>${words(parts[2])}${unit && html` <span class="unit">${unit}</span>`}</th>`)}</tr></thead>
    <tbody>${rows.map(({ of, name, colour, cells }) => html`<tr key=${of.id} class=${of === session.value ? 'chosen' : ''}><th scope="row" ref=${(cell) => { if (cell) cell.style.borderLeftColor = colour ?? ''; }}><button class="name" aria-current=${of === session.value} title=${`Show ${of.title} in all panels`} onClick=${() => show(of.id)}>${name}</button></th>${cells.map((cell) => html`<td>${cell}</td>`)}</tr>`)}</tbody></table>`;
}

/** The last changes up to the shown moment, the newest first. */
function History({ curves }) {
  readVersions(curves);
  const columns = curves.map((curve) => {
    const { place, path, of, shift } = curve;
    if (!place) return samplesAt(curve, [0, shownTime.value]);
    const { times, values } = of.output(...place);
    return new Map(times.map((at, index) => [at - shift, valueAt(values[index], path)]));
  });
  const all = [...new Set(columns.flatMap((column) => [...column.keys()]))].filter((at) => at <= shownTime.value).sort((a, b) => a - b).slice(-4 * ROWS);
  const last = columns.map(() => '–');
  const rows = all.flatMap((at) => {
    const now = columns.map((column, index) => (column.has(at) ? text(column.get(at)) : last[index]));
    const isNew = now.some((cell, index) => cell !== last[index]);
    now.forEach((cell, index) => { last[index] = cell; });
    return isNew ? [[at, now]] : [];
  });
  return html`<table class="stats values" aria-label="History"><thead><tr><th scope="col">time</th>${curves.map((curve) => html`<th class="n" scope="col">${titleOf(curve)}</th>`)}</tr></thead>
    <tbody>${rows.slice(-ROWS).reverse().map(([at, cells]) => html`<tr key=${at}><td><button class="time" onClick=${() => seek(at)}>${time(at)}</button></td>${cells.map((cell) => html`<td class="n">${cell}</td>`)}</tr>`)}</tbody></table>`;
}
