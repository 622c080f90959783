// Log and story, with filters and notes.

import { html, useEffect, useRef, useSignal } from '../lib/dom.js';
import { time } from '../lib/format.js';
import { cursor, seek, session } from '../lib/store.js';
import { Bar, Empty, Toggle, download } from '../lib/ui.js';

const SOURCES = { robot: 'Robot', world: 'World', operator: 'Operator', note: 'Notes', monitor: 'Monitor' };
const LEVELS = ['', 'debug', 'info', 'warning', 'error'];
/** Lines that are shown at once. */
const LIMIT = 500;

export function Log({ visible }) {
  const shown = session.value;
  const hidden = useSignal(new Set());
  const level = useSignal(2);
  const text = useSignal('');
  const follow = useSignal(true);
  const list = useRef(null);
  const version = shown && visible.value ? shown.linesVersion.value : 0;
  useEffect(() => {
    if (follow.value && cursor.value === null && list.current) list.current.scrollTop = list.current.scrollHeight;
  }, [version, follow.value]);
  if (!shown) return html`<${Empty} what="No session is open" help="Lines of the robot, the world and the operator appear here." />`;
  const toggle = (source) => {
    const next = new Set(hidden.value);
    if (!next.delete(source)) next.add(source);
    hidden.value = next;
  };
  const wanted = text.value.toLowerCase();
  const lines = shown.lines.filter((line) => !hidden.value.has(line.source) && line.level >= level.value && line.text.toLowerCase().includes(wanted)).slice(-LIMIT);
  const save = () => download('log.txt', new Blob([lines.map((line) => `${time(line.time_us, 3)}\t${LEVELS[line.level]}\t${line.source}\t${line.text}`).join('\n')], { type: 'text/plain' }));
  return html`<${Bar} label="Log">
      <input type="search" placeholder="Filter" aria-label="Filter lines" value=${text.value} onInput=${(event) => { text.value = event.target.value; }} />
      ${Object.entries(SOURCES).map(([source, name]) => html`<${Toggle} on=${!hidden.value.has(source)} label=${name} onChange=${() => toggle(source)} />`)}
      <select aria-label="Lowest level" onChange=${(event) => { level.value = Number(event.target.value); }}>${[1, 2, 3, 4].map((one) => html`<option value=${one} selected=${one === level.value}>${LEVELS[one]}</option>`)}</select>
      <span class="grow"></span>
      <${Toggle} on=${follow.value} label="Follow" title="Stay at the newest line" onChange=${(on) => { follow.value = on; }} />
      <button onClick=${save} disabled=${lines.length === 0}>Save</button>
    <//>
    ${lines.length === 0
      ? html`<${Empty} what=${shown.lines.length ? 'No line passes the filters' : 'No line yet'} help=${shown.lines.length ? 'Turn more kinds on, or clear the text.' : 'Transitions, events of the world, requests and notes appear here. Add a note in the timeline.'} />`
      : html`<ol class="log" ref=${list} aria-label="Log lines">${lines.map((line) => html`<li key=${line.key} class=${`level${line.level} ${line.source} ${cursor.value !== null && line.time_us > cursor.value ? 'later' : ''}`}>
            <button class="time" title="Show this moment" onClick=${() => seek(line.time_us)}>${time(line.time_us)}</button><span class="kind">${SOURCES[line.source]}</span>
            <span class="text">${line.text}</span></li>`)}</ol>`}`;
}
