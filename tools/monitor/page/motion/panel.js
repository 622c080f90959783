// The motion editor: motions of the sources, a timeline of keyframes, and the numbers of the chosen one.

import { html, useEffect, useSignal } from '../lib/dom.js';
import { exact, typedNumber } from '../lib/format.js';
import { jointsOf } from '../lib/frames.js';
import { cursor, hello, session, watch } from '../lib/store.js';
import { curveColour } from '../lib/theme.js';
import { Bar, Empty, Field, Toggle } from '../lib/ui.js';
import { Conflict } from '../vicode/conflict.js';
import { opened, redo, undo } from '../vicode/sources.js';
import { Curves, moved } from './curves.js';
import { Figure } from './figure.js';
import { channel, chosen, draft, form, held, insert, keys, mirror, motions, openMotion, readMotions, remove, row, scaleTime, setSeconds, setValue, shapes, table, take } from './model.js';
import { Trial, reached } from './trial.js';

const nameOf = ({ file, key }) => `${key} · ${file.split('/').slice(-2).join('/')}`;

function List() {
  const search = useSignal('');
  const wanted = search.value.trim().toLowerCase();
  const found = (motions.value ?? []).filter((one) => `${one.key} ${one.file} ${one.form.name}`.toLowerCase().includes(wanted));
  return html`<nav class="motions" aria-label="Motions"><input type="search" placeholder="Search" aria-label="Search motions" value=${search.value} onInput=${(event) => { search.value = event.target.value; }} />
    <ul>${found.map((one) => html`<li key=${one.file + one.key}><button class=${one.file === chosen.value?.file && one.key === chosen.value.key ? 'on' : ''} title=${`${one.file}\n${one.form.name}`} onClick=${() => openMotion(one.file, one.key)}><b>${one.key}</b> <span class="dim">${one.file.split('/').slice(-2).join('/')}</span></button></li>`)}
    ${motions.value && found.length === 0 && html`<li class="dim">${motions.value.length === 0 ? 'No file below the folder has keyframes of this program’s robots.' : 'Nothing is found.'}</li>`}</ul></nav>`;
}

/** One number of the chosen keyframe. */
function Channel({ own, index }) {
  const { values, written } = keys.value[row.value];
  const value = values[index];
  const limits = shapes.value[row.value]?.limits;
  const of = (list) => list?.find(([joint]) => own.moves.includes(joint));
  const [beyond, fast] = [of(limits?.beyond), of(limits?.fast)];
  const drag = (event) => { draft.value = { row: row.value, channel: index, value: Number(event.target.value) }; };
  const drop = async (event) => {
    await setValue(row.value, index, Number(event.target.value));
    draft.value = null;
  };
  const load = Math.max(0, ...(shapes.value[row.value]?.shape.load ?? []).filter(([joint]) => own.moves.includes(joint)).map(([, share]) => share));
  const now = reached(index, row.value);
  const digits = own.step >= 1 ? 0 : own.step >= 0.1 ? 1 : 3;
  return html`<li class=${`channel ${index === channel.value ? 'on' : ''} ${written[index] ? '' : 'rest'}`} onFocusIn=${() => { channel.value = index; }}>
    <label for=${`channel-${index}`} onClick=${() => { channel.value = index; }}><i class="dot" ref=${(dot) => { if (dot) dot.style.background = curveColour(index); }}></i>${own.name}</label>
    <input id=${`channel-${index}`} aria-label=${own.name} type="range" min=${own.min} max=${own.max} step=${own.step} value=${value} disabled=${Boolean(held.value)} onInput=${drag} onChange=${drop} />
    <${Field} value=${edited(value)} label=${`${own.name} in ${own.unit}`} width="number" disabled=${Boolean(held.value)} onCommit=${(text) => { if (Number.isFinite(typedNumber(text))) setValue(row.value, index, typedNumber(text)); }} /><span class="dim">${own.unit}</span>
    ${beyond ? html`<span class="warn" title="The motor stops there">limit ${beyond[2].toFixed(0)}°</span>` : fast ? html`<span class="warn" title="Faster than the motor: the joint arrives late">${fast[1].toFixed(0)} of ${fast[2].toFixed(0)} °/s</span>` : load > 1 ? html`<span class="warn" title="The motor holds this posture for a short time only">load ${(load * 100).toFixed(0)} %</span>` : html`<span class="dim">${now !== undefined && `measured ${now.toFixed(digits)}`}</span>`}
  </li>`;
}

/** A number as it is written in the source, without what the arithmetic of floating-point numbers added. */
const edited = (value) => exact(Number(value.toFixed(6)));

function Numbers() {
  const onlyMoved = useSignal(false);
  const own = form.value;
  const list = onlyMoved.value ? moved() : own.channels.map((_, index) => index);
  const key = keys.value[row.value];
  const { least = 0, beyond = [], fast = [] } = shapes.value[row.value]?.limits ?? {};
  // Joints that no number moves directly.
  const indirect = [...beyond, ...fast].map(([joint]) => joint).filter((joint) => !own.channels.some(({ moves }) => moves.includes(joint)));
  return html`<section class="numbers" aria-label="Keyframe">
    <p class="keyframe"><b>Keyframe ${row.value + 1} of ${keys.value.length}</b>
      <button aria-label="Previous keyframe" disabled=${row.value === 0} onClick=${() => { row.value -= 1; }}>‹</button><button aria-label="Next keyframe" disabled=${row.value >= keys.value.length - 1} onClick=${() => { row.value += 1; }}>›</button>
      ${own.time ? html`<label>takes <${Field} value=${edited(key.seconds)} label="Duration in s" width="number" disabled=${Boolean(held.value)} onCommit=${(text) => { if (typedNumber(text) > 0) setSeconds([[row.value, typedNumber(text)]]); }} /> s</label>` : html`<span class="dim">takes ${key.seconds.toFixed(2)} s by its way</span>`}
      ${least > key.seconds + 0.005 && html`<span class="warn">${own.stretches ? 'is played in' : 'the motors need'} ${least.toFixed(2)} s</span>`}
      ${indirect.length > 0 && html`<span class="warn" title="Faster than their motors, or beyond their ranges">! ${[...new Set(indirect)].join(', ')}</span>`}
      <${Toggle} on=${onlyMoved.value} label="Only what moves" title="Leave out the numbers that no keyframe changes" onChange=${(on) => { onlyMoved.value = on; }} /></p>
    <ul>${list.map((index) => html`<${Channel} key=${index} own=${own.channels[index]} index=${index} />`)}</ul></section>`;
}

function Tools() {
  const shown = session.value;
  const place = jointsOf(shown);
  useEffect(() => (place ? watch({ info: [[...place, 3]] }) : undefined), [shown, shown?.description.value]);
  const own = form.value;
  const disabled = Boolean(held.value) || !keys.value?.length;
  const isFixed = table.value?.array === null;
  const takes = () => {
    const now = shown.output(...place).now.value?.value;
    if (now) take(new Map(now.names.map((name, index) => [name, now.positions[index]])));
  };
  const scale = (text) => { if (Number(text) > 0) scaleTime(Number(text) / 100); };
  return html`<button aria-label="Undo" title="Undo" onClick=${undo}>↶</button><button aria-label="Redo" title="Make it again" onClick=${redo}>↷</button>
    <button disabled=${Boolean(held.value) || isFixed || (keys.value?.length === 0 && !own.row)} title="A copy of this keyframe after it" onClick=${insert}>Insert</button>
    <button disabled=${disabled || isFixed} onClick=${remove}>Delete</button>
    <button disabled=${disabled} title="Exchange left and right in this keyframe" onClick=${() => mirror([row.value])}>Mirror</button>
    <button disabled=${disabled} title="Exchange left and right in the whole motion" onClick=${() => mirror(keys.value.map((_, at) => at))}>Mirror all</button>
    ${own.time && html`<label class="join" title="All durations">Time <${Field} value="100" label="Scale of all durations in %" width="number" disabled=${disabled} onCommit=${scale} /> %</label>`}
    <button disabled=${disabled || !place || own.channels.every(({ moves }) => moves.length === 0)} title="Angles that the robot of the session has measured, at the cursor or now" onClick=${takes}>Take from the robot${cursor.value === null ? '' : ' at the cursor'}</button>`;
}

function stateOf(own) {
  if (own.problem) return html`<b class="error">${own.problem}</b>`;
  return own.deleted ? html`<b class="error">The file was deleted.</b>` : own.readonly ? 'read-only' : own.saved ? 'saved' : 'not saved yet';
}

export function Motion({ visible }) {
  const known = Boolean(session.value?.description.value);
  useEffect(() => { if (hello.value?.source && known) readMotions(); }, [hello.value?.source, known]);
  useEffect(() => { if (keys.value && row.value >= keys.value.length) row.value = Math.max(0, keys.value.length - 1); }, [keys.value]);
  if (!hello.value?.source) return html`<${Empty} what="No folder of sources is open" help="Start the program with --source FOLDER." />`;
  const file = opened.value;
  const isOpen = chosen.value && file?.file === chosen.value.file;
  return html`<${Bar} label="Motion"><b>${chosen.value ? nameOf(chosen.value) : 'Motions'}</b>${isOpen && form.value && table.value && html`<${Tools} />`}<span class="grow"></span>
      ${isOpen && html`<span class="dim" role="status" aria-label="State of the source">${stateOf(file)}</span>`}<button aria-label="Read the folder again" title="Read the folder again" onClick=${readMotions}>↻</button><//>
    <div class="motion"><${List} />
      ${!isOpen ? html`<${Empty} what="No motion is open" help="Choose one in the list: key postures of the robot’s model and of applications." />`
    : file.conflict ? html`<${Conflict} />`
      : !table.value ? html`<${Empty} what="This motion is not in the text any more" help="It may have been renamed or is no Rust at present: see the code, or choose another one." />`
        : html`<div class="editor"><div class="timeline-space"><${Curves} visible=${visible} /></div><${Trial} />
          ${keys.value.length === 0 ? html`<${Empty} what="This motion has no keyframe" help="Insert adds the first one." />` : html`<div class="halves"><${Numbers} /><${Figure} visible=${visible} /></div>`}</div>`}
    </div>`;
}
