// Outputs of a component: value, unit, curve, and history. A row can be dragged onto a plot.

import { html, useSignal } from '../../lib/dom.js';
import { open } from '../../lib/dock.js';
import { numberAt, numbers, text, time, words } from '../../lib/format.js';
import { cursor, seek } from '../../lib/store.js';
import { Spark } from '../../lib/ui.js';

/** Longest list of plain values of which each has a row, and most rows of a struct. */
const [MAX_PARTS, MAX_ROWS] = [4, 16];

/** The plain values in a value: [path, value]. */
const leaves = (value, path = '') => (value === null || typeof value !== 'object' ? [[path, value]]
  : Object.entries(value).flatMap(([name, inner]) => leaves(inner, Array.isArray(value) ? `${path}[${name}]` : `${path}.${name}`)));
const isPlain = (value) => Array.isArray(value) && value.every((inner) => inner === null || typeof inner !== 'object');

export function OutputList({ shown, component, index, visible }) {
  return html`<section aria-label="Outputs"><h3>Outputs</h3>
    ${component.info.map((info, number) => html`<${Info} key=${info.name} ...${{ info, component: component.name, output: shown.output(index, number), visible }} />`)}</section>`;
}

function Info({ info, component, output, visible }) {
  const history = useSignal(false);
  const now = visible.value ? output.now.value : null;
  const value = now?.value;
  const parts = numbers(value);
  const rows = leaves(value ?? null);
  const split = value !== null && typeof value === 'object' && rows.length > 0 && (isPlain(value) ? rows.length > 1 && rows.length <= MAX_PARTS : true);
  const name = `${component}.${info.name}`;
  const drag = (event, path = '') => {
    event.dataTransfer.setData('text/plain', name + path);
    event.dataTransfer.setData('application/x-jmanager-curve', name + path);
    event.dataTransfer.effectAllowed = 'copy';
    event.stopPropagation();
  };
  const plot = () => open('plot', { curves: (parts.length > 0 ? parts.slice(0, 3).map(([path]) => name + path) : [name]) }, words(info.name));
  return html`<div class="info">
    <div class="row" draggable="true" onDragStart=${(event) => drag(event)} title=${`${info.doc}\n${info.type}${info.unit ? `, ${info.unit}` : ''}\nDrag onto a plot.`}>
      <button class="name" aria-expanded=${history.value} aria-label=${`History of ${info.name}`} onClick=${() => { history.value = !history.value; }}>${words(info.name)}</button>
      ${parts.length === 1 && !split ? html`<${Spark} output=${output} path=${parts[0][0]} pick=${numberAt} />` : html`<span></span>`}
      <span class="v" aria-label=${split ? undefined : info.name}>${now === null ? '…' : split ? '' : text(value)}${info.unit && value !== null && value !== undefined && !split ? html` <span class="unit">${info.unit}</span>` : ''}</span>
    </div>
    ${split && rows.slice(0, MAX_ROWS).map(([path, inner]) => html`<div class="row part" draggable="true" onDragStart=${(event) => drag(event, path)}><span class="dim">${path.replace(/^\./, '')}</span>
      ${typeof inner === 'number' ? html`<${Spark} output=${output} path=${path} pick=${numberAt} />` : html`<span></span>`}<span class="v">${text(inner)}${typeof inner === 'number' && html` <span class="unit">${unitOf(info.unit, path)}</span>`}</span></div>`)}
    ${split && rows.length > MAX_ROWS && html`<p class="dim">${rows.length - MAX_ROWS} more</p>`}
    ${history.value && html`<div class="history"><p>${info.doc}</p><${History} output=${output} /><button class="small" disabled=${parts.length === 0} onClick=${plot}>Plot</button></div>`}
  </div>`;
}

/** `m, rad` names the units of lengths and of angles. */
function unitOf(unit, path) {
  if (!unit?.includes(',')) return unit ?? '';
  const [length, angle] = unit.split(',').map((one) => one.trim());
  return /turn|heading|angle|yaw|pitch|pan|down/.test(path) ? angle : length;
}

function History({ output }) {
  void output.version.value;
  const changes = [];
  let last;
  for (let index = (cursor.value === null ? output.times.length : output.count(cursor.value)) - 1; index >= 0 && changes.length < 8; index -= 1) {
    const shown = text(output.values[index]);
    if (shown !== last) changes.push([output.times[index], shown]);
    last = shown;
  }
  return html`<ol>${changes.map(([at, shown]) => html`<li key=${at}><button class="time" onClick=${() => seek(at)}>${time(at)}</button> ${shown}</li>`)}</ol>`;
}
