// The chosen span: its length, how the shown component spent it, and what can be done with it.

import { html, useSignal } from '../../lib/dom.js';
import { showRange } from '../../lib/axis.js';
import { duration, time } from '../../lib/format.js';
import { SPEEDS, looping, playSpan, speed } from '../../lib/playback.js';
import { visiblePanels } from '../../lib/dock.js';
import { film, filming, isDrawn } from '../../lib/film.js';
import { noteOf, span, sharesOf, table } from '../../lib/span.js';
import { act, hello, playing, selected, session } from '../../lib/store.js';
import { Bar, Toggle, download } from '../../lib/ui.js';
import { askForm } from '../../vicode/ask.js';

/** States that are named. */
const NAMED = 4;

export const Speed = () => html`<select aria-label="Playback speed" title="Speed of playback" onChange=${(event) => { speed.value = Number(event.target.value); }}>
  ${SPEEDS.map((one) => html`<option value=${one} selected=${one === speed.value}>${one}×</option>`)}</select>`;

export function SpanBar({ rows }) {
  const busy = useSignal(false);
  if (!span.value) return null;
  const [begin, end] = span.value;
  const shown = session.value;
  const { root, components } = shown.description.value;
  const index = Math.max(selected.value ? shown.find(selected.value) : -1, -1);
  const component = index < 0 ? root : index;
  const { shares, transitions } = sharesOf(rows.find((row) => row.component === component), components[component], span.value);
  const csv = async () => {
    busy.value = true;
    const text = await table(shown, span.value).catch(() => undefined);
    busy.value = false;
    if (text) download(`span-${(begin / 1e6).toFixed(2)}-${(end / 1e6).toFixed(2)}.csv`, new Blob([text], { type: 'text/csv' }));
  };
  const keep = async () => {
    const asked = await askForm({ title: 'Keep the span as a recording', submit: 'Keep', fields: [{ name: 'name', label: 'Name of the recording', max: hello.value.limits.name, value: `${shown.title} ${(begin / 1e6).toFixed(1)}-${(end / 1e6).toFixed(1)} s`.replace('.mcap', '').replaceAll(/[/:\\]/g, '-') }] });
    if (asked?.name.trim()) await act('keep_span', { name: asked.name.trim(), from_us: begin, until_us: end }, `the span is kept as “${asked.name.trim()}”; Recordings opens it`);
  };
  // A note of the span has its times, from which the timeline draws it.
  const annotate = async () => {
    const asked = await askForm({ title: 'Annotate the span', submit: 'Annotate', fields: [{ name: 'text', label: 'Text', value: '', max: hello.value.limits.note - noteOf(span.value, '').length }] });
    if (asked?.text.trim()) await act('note', { text: noteOf(span.value, asked.text.trim()) }, 'the span is annotated in the timeline, the log and the recording');
  };
  const record = async () => {
    const panels = visiblePanels().filter(isDrawn);
    const asked = await askForm({ title: 'Film of a panel', hint: `The span is played at ${speed.value}×; leave the panel visible meanwhile.`, submit: 'Film', fields: [{ name: 'panel', label: 'Panel', kind: 'select', value: '0', options: panels.map(({ title }, number) => [String(number), title]) }] });
    if (asked) film(panels[Number(asked.panel)]);
  };
  return html`<${Bar} label="Span"><b>${time(begin)} – ${time(end)}</b> <span>${duration(end - begin)}</span>
    <button class=${playing.value ? 'on' : ''} onClick=${playSpan}>${playing.value ? 'Pause' : 'Play span'}</button><${Toggle} on=${looping.value} label="Loop" title="Begin again at the end" onChange=${(on) => { looping.value = on; }} /><${Speed} />
    <button onClick=${() => showRange(begin, end)}>Zoom</button><button disabled=${busy.value} title="All numbers of all outputs in the span" onClick=${csv}>CSV</button><button title="Keep the span as a recording" onClick=${keep}>Recording…</button>
    ${filming.value ? html`<button class="on" onClick=${filming.value}>End the film</button>` : html`<button title="Play the span and save what a panel shows as a film" onClick=${record}>Film…</button>`}<button title="A note of the span" onClick=${annotate}>Annotate…</button>
    <span class="dim place">${components[component].name}: ${shares.slice(0, NAMED).map(([name, share]) => `${name} ${(share * 100).toFixed(0)} %`).join(', ') || 'latent'} · ${transitions} transition${transitions === 1 ? '' : 's'}</span>
    <span class="grow"></span><button aria-label="Choose no span" onClick=${() => { span.value = null; }}>×</button><//>`;
}
