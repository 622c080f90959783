// Recordings: keep what was recorded, open, compare, run again.

import { html, useEffect, useSignal } from '../lib/dom.js';
import { bytes, duration, sentence, time } from '../lib/format.js';
import { playOrPause } from '../lib/playback.js';
import { act, ask, hello, playing, putBeside, seek, session, sessions, show } from '../lib/store.js';
import { Empty, TooLong, excess } from '../lib/ui.js';

/** The local date and time, as a file is named. */
const stamp = (now = new Date()) => new Date(now - now.getTimezoneOffset() * 60e3).toISOString().slice(0, 19).replace('T', ' ').replaceAll(':', '-');

export function Recordings({ visible }) {
  const list = useSignal(null);
  const read = async () => { list.value = (await ask('recordings')) ?? []; };
  useEffect(() => {
    if (visible.value) read();
  }, [visible.value]);
  const shown = session.value;
  const several = [...sessions.value.values()].filter((one) => one.info.value.kind === 'recording').length > 1;
  // Above what changes while a run goes on: a button that moves is not pressed.
  return html`<article class="tab">${several && html`<${Compare} />`}
    ${shown && html`<${Current} ...${{ shown, read }} />`}
    <section aria-label="Recordings"><h3>Kept recordings <button class="small" onClick=${read}>Refresh</button></h3>
      ${list.value === null ? html`<p class="dim">Reading the folder…</p>` : list.value.length === 0
        ? html`<${Empty} what="No recording is kept" help="Keep the last minutes above, or start the program with --recordings FOLDER." />`
        : html`<ul class="recordings">${list.value.map((one) => html`<li><button class="name" onClick=${() => open(one.name)} title="Open in a new session">${one.name}</button>
          <span class="dim">${one.seconds ? `${duration(one.seconds * 1e6)} · ` : ''}${bytes(one.bytes)}</span></li>`)}</ul>`}
    </section>
    ${!several && html`<${Compare} />`}
  </article>`;
}

async function open(name) {
  // An open recording is shown, and not opened a second time.
  const known = [...sessions.value.values()].find(({ info }) => info.value.kind === 'recording' && info.value.name === name);
  if (known) return show(known.id);
  const opened = await ask('open', { source: { kind: 'recording', name } });
  if (opened) show(opened.session);
}

function Current({ shown, read }) {
  const info = shown.info.value;
  const name = useSignal(null);
  if (info.kind === 'recording') return html`<${Replay} ...${{ shown, info }} />`;
  const keep = async (event) => {
    event.preventDefault();
    const kept = await act('keep_recording', { name: name.value ?? stamp() });
    if (kept === undefined) return;
    name.value = null;
    await ask('note', { session: shown.id, text: `recording kept: ${kept.path}` });
    read();
  };
  return html`<section aria-label="This session"><h3>This session</h3>
    <p>${info.recording.on ? html`The last ${duration(Math.max(0, info.until_us - info.recording.from_us))} are recorded, ${bytes(info.recording.bytes)}.` : html`<span class="warn">It is not recorded.</span>`}
      ${info.recording.file && html` It is written to <b>${info.recording.file}</b>.`} <span class=${info.recording.on && info.recording.note ? 'warn' : 'dim'}>${info.recording.note}</span></p>
    ${info.kind === 'robot' && html`<p class="dim">The recording has what the robot sent, and images of the times when a camera panel was open. It can be viewed, but not run again; for that, record on the robot (player play --record).</p>`}
    <form class="join" onSubmit=${keep}><input aria-label="Name of the recording" placeholder=${stamp()} value=${name.value ?? ''} onInput=${(event) => { name.value = event.target.value || null; }} />
      <button disabled=${!info.recording.on || excess(name.value ?? '', hello.value.limits.name) > 0}>Keep recording</button><${TooLong} text=${name.value ?? ''} max=${hello.value.limits.name} /></form></section>`;
}

function Replay({ shown, info }) {
  const description = shown.description.value;
  const settings = useSignal([]);
  const path = useSignal('');
  const value = useSignal('');
  const all = description?.components.flatMap((component) => component.params.map((param) => ({ name: `${component.name}.${param.name}`, component: component.name, param: param.name }))) ?? [];
  const add = () => {
    const chosen = all.find((one) => one.name === path.value);
    if (!chosen) return;
    settings.value = [...settings.value.filter((one) => one.name !== chosen.name), { ...chosen, value: value.value.trim() }];
    [path.value, value.value] = ['', ''];
  };
  const again = async () => {
    const opened = await act('run_again', { settings: settings.value.map(({ component, param, value: to }) => ({ component, param, value: to })) });
    if (opened) show(opened.session);
  };
  return html`<section aria-label="Replay"><h3>${info.name}</h3>
    <p>${duration(info.until_us - info.from_us)}, from ${time(info.from_us)} to ${time(info.until_us)}. <b>${info.result}</b> <span class="dim">${info.note}</span></p>
    <div class="buttons"><button onClick=${() => seek(info.from_us)} aria-label="To the beginning">|◂</button><button class="wide" onClick=${playOrPause}>${playing.value ? 'Pause' : 'Play'}</button><button onClick=${() => seek(info.until_us)} aria-label="To the end">▸|</button></div>
    ${info.can.run_again && html`<h3>Run again</h3><p class="dim">Runs the code of this program again on the recorded inputs. Add parameters to change their values.</p>
      <div class="join"><input list="params-of-run" aria-label="Parameter" placeholder="Component.name" value=${path.value} onInput=${(event) => { path.value = event.target.value; }} />
        <datalist id="params-of-run">${all.map((one) => html`<option value=${one.name}></option>`)}</datalist>
        <input class="short" aria-label="Value" placeholder="0.9" value=${value.value} onInput=${(event) => { value.value = event.target.value; }} onKeyDown=${(event) => event.key === 'Enter' && add()} /><button onClick=${add}>Add</button></div>
      <ul class="recordings">${settings.value.map((one) => html`<li>${one.name} = ${String(one.value)} <button class="small" aria-label=${`Remove ${one.name}`} onClick=${() => { settings.value = settings.value.filter((other) => other !== one); }}>×</button></li>`)}</ul>
      <button onClick=${again}>Run again</button>`}
  </section>`;
}

/** Decisions that are listed. */
const DECISIONS = 200;

function Compare() {
  const recordings = [...sessions.value.values()].filter((one) => one.info.value.kind === 'recording');
  const chosen = useSignal([null, null]);
  const result = useSignal(null);
  const busy = useSignal(false);
  if (recordings.length < 2) return html`<section aria-label="Compare"><h3>Compare</h3><p class="dim">Open two recordings to find the first difference between them.</p></section>`;
  const ids = recordings.map(({ id }) => id);
  // The two that were opened last, unless others are chosen.
  const [one, other] = ids.slice(-2).map((id, at) => (ids.includes(chosen.value[at]) ? chosen.value[at] : id));
  const unread = recordings.find(({ id, info }) => (id === one || id === other) && info.value.connection === 'connecting');
  const title = one === other ? 'Choose two recordings' : unread ? `${unread.title} is still being read or run again` : '';
  const pick = (at, label) => html`<select aria-label=${label} onChange=${(event) => { [chosen.value, result.value] = [[one, other].with(at, Number(event.target.value)), null]; }}>
    ${recordings.map((of) => html`<option value=${of.id} selected=${of.id === [one, other][at]}>${of.title}</option>`)}</select>`;
  const compare = async () => {
    busy.value = true;
    result.value = (await ask('compare', { session: one, other })) ?? null;
    busy.value = false;
  };
  /** Shows both at a time of the first. */
  const go = (time_us) => {
    show(one);
    putBeside(other, true);
    seek(time_us);
  };
  const { equal, copies, cycle, text, time_us: first, decisions = [] } = result.value ?? {};
  return html`<section aria-label="Compare"><h3>Compare</h3><div class="join">${pick(0, 'First recording')}${pick(1, 'Second recording')}<button disabled=${title !== '' || busy.value} title=${title} onClick=${compare}>${busy.value ? 'Comparing…' : 'Compare'}</button></div>
    <p class="dim">${title || 'States the first difference, and the decisions that differ'}.</p>
    ${result.value && (equal ? html`<p class="yes">${copies ? 'They are copies of one recording.' : 'They are equal.'}</p>` : html`<p><b class="warn">First difference</b> in cycle ${cycle}: ${sentence(text)} <button class="small" onClick=${() => go(first)}>Show both</button></p>
      ${decisions.length > 0 && html`<table class="stats" aria-label="Decisions that differ"><thead><tr><th>Time</th><th>Component</th><th>${recordings.find(({ id }) => id === one).title}</th><th>${recordings.find(({ id }) => id === other).title}</th></tr></thead>
        <tbody>${decisions.slice(0, DECISIONS).map(({ t_ms: at, component, recorded, repeated }) => html`<tr><td><button class="time" aria-label=${`Show both at ${time(at * 1000)}`} onClick=${() => go(at * 1000 + 999)}>${time(at * 1000)}</button></td><td>${component}</td><td>${recorded}</td><td>${repeated}</td></tr>`)}</tbody></table>`}`)}</section>`;
}
