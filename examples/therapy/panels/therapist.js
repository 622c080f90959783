// The therapist's page: what the robot does, in words for people who are not engineers, with large buttons.

import { html, useEffect, useRef, useSignal } from '../lib/dom.js';
import { playOrPause } from '../lib/playback.js';
import { pulse } from '../lib/pulse.js';
import { act, ask, command, playing, session, show, watch } from '../lib/store.js';
import { Empty } from '../lib/ui.js';

const HOLD_MS = 2000;
const OUTPUTS = [['Session', 'at'], ['Session', 'ease'], ['Guard', 'hottest'], ['Guard', 'battery'], ['Guard', 'trouble'], ['Sound', 'volume'], ['Motors', 'targets'], ['ExerciseCheck', 'counts'], ['ExerciseCheck', 'examples'], ['ExerciseCheck', 'attempts'], ['Session', 'waited'], ['Session', 'limit'], ['Mover', 'held']];
const STATES = {
  ready: ['Ready', 'The robot stands and waits. Press “Start” when everyone is seated.'],
  running: ['Running', 'the robot shows, the person follows'],
  exercising: ['Running', 'the robot shows, and watches the person'],
  paused: ['Paused', 'The arms are down, the robot is silent. It waits for you.'],
  stopped: ['STOPPED', 'The robot stands still and is silent.'],
  finished: ['Finished', 'The session is over. The robot stands and is silent.'],
};
const TROUBLES = { Fallen: 'The robot has fallen. Put it on its feet.', Hot: 'A joint is hot. Let the robot rest until it is cool.', PageLost: 'The robot missed this page for some seconds.' };
const REASONS = { too_low: 'a little too low', leaning: 'leaning', wrong_direction: 'in another direction', too_fast: 'too fast', not_seen: 'not seen well enough', unsure: 'not seen well enough' };

const sheet = new CSSStyleSheet();
sheet.replaceSync(`
.therapist { display: grid; grid-template-rows: auto auto minmax(0, 1fr) auto auto; gap: 9px; height: 100%; padding: 10px; font-size: 18px; overflow: auto; }
.therapist h2 { font-size: 22px; } .therapist .head, .therapist .mood, .therapist .keys { display: flex; gap: 10px 16px; align-items: center; flex-wrap: wrap; }
.therapist .mood { border: 3px solid var(--control); border-radius: 12px; padding: 8px 16px; background: color-mix(in srgb, var(--control) 14%, var(--panel)); } .therapist .mood b { font-size: 24px; }
.therapist .go { --control: var(--ok); } .therapist .wait { --control: var(--machine); } .therapist .halt { --control: var(--error); } .therapist .halt b { font-size: clamp(40px, 8cqw, 64px); line-height: 1; color: var(--error); }
.therapist .middle { display: grid; grid-template-columns: minmax(0, 1fr) minmax(220px, 30%); gap: 10px; min-height: 0; } .therapist .card { border: 1px solid var(--line); border-radius: 12px; padding: 12px 16px; overflow: auto; background: var(--raised); }
.therapist .card h3 { font-size: 24px; line-height: 1.2; } .therapist .card p { margin: 6px 0; } .therapist .told { display: grid; grid-template-columns: minmax(0, 1fr) minmax(130px, 20cqw); gap: 12px; } .therapist .card li { display: flex; gap: 10px; margin: 8px 0; } .therapist .passed { display: flex; gap: 12px; align-items: center; font-weight: 600; } .therapist .passed { white-space: nowrap; } .therapist progress { width: 240px; min-width: 60px; height: 20px; accent-color: var(--control); }
.therapist .attempts { display: block; width: 100%; max-width: 620px; fill: var(--dim); stroke: none; } .therapist .attempts text { font-size: 19px; font-weight: 700; text-anchor: middle; } .therapist .attempts path, .therapist .attempts circle { fill: none; stroke: var(--dim); stroke-width: 2; stroke-dasharray: 7 5; } .therapist .attempts circle { stroke-dasharray: none; }
.therapist .kind0 rect { fill: var(--ok); } .therapist .kind1 rect, .therapist .kind2 rect { fill: var(--warn); } .therapist .kind3 rect { fill: none; stroke: var(--dim); stroke-width: 2; stroke-dasharray: 4; } .therapist .last { padding: 6px 12px; border-radius: 8px; background: color-mix(in srgb, var(--warn) 16%, var(--panel)); }
.therapist .figure { width: 100%; height: 100%; max-height: 50cqh; position: sticky; top: 0; place-self: center; fill: none; stroke: var(--dim); stroke-linecap: round; } .therapist .big { font-size: 40px; font-weight: 700; }
.therapist button, .therapist select { min-height: 48px; min-width: 48px; font-size: 18px; font-weight: 600; border-radius: 10px; padding: 4px 14px; border-width: 2px; white-space: normal; }
.therapist select { white-space: nowrap; } .therapist .parts { display: flex; flex-direction: column; gap: 6px; } .therapist .parts button { text-align: left; font-weight: 500; flex-shrink: 0; } .therapist .parts button.now { border-color: var(--control); background: var(--selection); font-weight: 700; }
.therapist .keys button { min-height: 72px; } .therapist .main { min-width: 150px; font-size: 22px; } .therapist .start { background: #11703f; color: #fff; } .therapist .pause { border-color: var(--machine); color: var(--machine); }
.therapist .held { position: relative; overflow: hidden; border-color: var(--ok); color: var(--ok); } .therapist .held i { position: absolute; left: 0; bottom: 0; height: 8px; width: 0; background: var(--ok); } .therapist .held.on i { width: 100%; transition: width ${HOLD_MS}ms linear; }
@container (max-width: 700px) or (max-height: 520px) { .therapist { display: flex; flex-direction: column; padding: 6px; } .therapist > * { flex: none; } .therapist .head { order: 1; } .therapist .mood { padding: 4px 12px; } .therapist .halt b { font-size: 30px; } .therapist .middle, .therapist .told { grid-template-columns: minmax(0, 1fr); } .therapist .figure { height: 130px; } .therapist .keys { position: sticky; bottom: 0; background: var(--panel); flex-wrap: nowrap; overflow-x: auto; scrollbar-width: none; } .therapist .keys > * { flex: none; } .therapist .keys .main { order: -1; } .therapist .parts { max-height: 260px; } .therapist .keys button { min-height: 48px; } }`);
document.adoptedStyleSheets = [...document.adoptedStyleSheets, sheet];

const spoken = (text) => text.replaceAll('_', ' ');
/** What a wait is for; one without an entry is for a time. */
const AWAITED = { speech: 'the speech to end', movement: 'the movement to end', music: 'the music to end', walk: 'the walk to end', all: 'everything to end', press: 'a press', touch: 'a touch' };
const quoted = (text) => text?.match(/"(.*)"/)?.[1];
const fileName = (file) => file.split('/').at(-1).replace(/\.session$/, '');

/** What a command of the session language does, in words. */
function inWords({ does, says }) {
  const [word, name, , count] = does.split(/\s+/);
  switch (word) {
    case 'exercise': return `Exercise: ${spoken(name)}, ${count} times`;
    case 'movement': return `Shows: ${spoken(name)}`;
    case 'walk': case 'turn': return `Walks: ${does}`;
    case 'music': return 'Music';
    case 'say': return `Says: “${quoted(says) ?? 'a recording'}”`;
    default: return 'Waits for a touch or a button';
  }
}

function Therapist({ visible }) {
  const shown = session.value;
  const description = shown?.description.value;
  const script = useSignal(null);
  const machine = shown?.find('Session') ?? -1;
  const recorded = shown?.info.value.kind === 'recording';
  const read = (component, name) => {
    const at = shown.findInfo(component, name);
    return at && shown.output(...at).now.value?.value;
  };
  const call = (component, name, values = []) => {
    const index = shown.find(component);
    const modulation = description.components[index].modulations.findIndex((one) => one.name === name);
    return command('modulate', { component: index, modulation, arguments: values });
  };
  useEffect(() => {
    if (!visible.value || machine < 0) return undefined;
    return watch({ info: OUTPUTS.map(([component, name]) => [...shown.findInfo(component, name), 10]) });
  }, [visible.value, description]);
  useEffect(() => {
    script.value = null;
    // What this program plays is not what a recording has.
    if (machine >= 0 && !recorded) ask('extension', { session: shown.id, name: 'therapist', message: { type: 'read' } }).then((found) => { script.value = found; });
  }, [description]);
  const state = machine < 0 ? null : description.components[machine].states[(recorded ? shown.moment : shown.live).value?.components[machine]?.[2]]?.name ?? 'ready';
  // Whoever operates a session must be missed if the page is lost.
  const operates = shown?.info.value.control === 'yours' && !['ready', 'finished', null].includes(state);
  useEffect(() => {
    if (!operates) return undefined;
    // The end of control ends this effect only later: until then a call would take control again.
    const tell = (name) => session.peek()?.info.peek().control === 'yours' && call('Guard', name);
    const here = () => tell('page_is_here');
    here();
    const end = pulse(here);
    return () => {
      end();
      tell('page_closes');
    };
  }, [operates]);

  const at = shown?.description.value && machine >= 0 ? read('Session', 'at') ?? 0 : 0;
  const parts = script.value?.parts ?? [];
  const now = Math.max(0, parts.findLastIndex(({ step }) => step <= at));
  const list = useRef(null);
  useEffect(() => {
    const one = list.current?.querySelector('.now');
    if (one) list.current.scrollTop = one.offsetTop - list.current.offsetTop - 60;
  }, [now, script.value]);

  if (machine < 0) return html`<${Absent} info=${shown?.info.value} />`;
  const open = async (chosen) => {
    const file = chosen.value;
    chosen.value = script.value.file;
    const about = { session: shown.id, name: 'therapist' };
    if (!await ask('extension', { ...about, message: { type: 'check', file } })) return;
    const world = shown.info.value.name.split(/[ ,]/)[0];
    const opened = await ask('open', { source: { kind: 'world', world, seed: shown.info.value.seed ?? 0, options: { ...script.value?.options, session: file } } });
    if (!opened) return;
    await ask('extension', { ...about, session: opened.session, message: { type: 'chose', file } });
    show(opened.session);
    ask('close', { session: shown.id });
  };
  const part = parts[now];
  const trouble = read('Guard', 'trouble');
  const counts = read('ExerciseCheck', 'counts');
  const waited = read('Session', 'waited') ?? 0;
  const limit = read('Session', 'limit') ?? 0;
  const hold = Number(/hold (\S+)/.exec(part?.does)?.[1] ?? 0);
  const line = script.value?.steps[at];
  const ease = Math.round((read('Session', 'ease') ?? 1) * 100);
  const examples = read('ExerciseCheck', 'examples') ?? 0;
  const wanted = Math.max(1, Math.floor((/reps (\d+)/.exec(part?.does)?.[1] ?? 1) * ease / 100));
  const volume = Math.round((read('Sound', 'volume') ?? 0.6) * 10);
  const hottest = read('Guard', 'hottest');
  const battery = Math.round((read('Guard', 'battery') ?? 0) * 100);
  const [yes, no] = [html`<span class="yes">✓</span>`, html`<span class="warn">⚠</span>`];
  const [title, what] = STATES[state === 'waiting' ? 'running' : state];
  const runs = ['running', 'waiting', 'exercising'].includes(state);
  const over = state === 'ready' || state === 'finished';
  const progress = part && !recorded ? `Part ${now + 1} of ${parts.length}: ${what}` : what;
  const lines = parts.length === 1 ? 'The session can be played.' : `All ${parts.length} parts of the session can be played.`;
  // A robot that missed the page goes on only after it has heard of it again.
  const goOn = async () => {
    await call('Guard', 'page_is_here');
    call('Session', 'go_on');
  };
  const key = (label, name, off, kind = '') => html`<button class=${kind} disabled=${off} onClick=${() => call('Session', name)}>${label}</button>`;
  const level = (label, to) => html`<button aria-label=${label} disabled=${to < 0 || to > 10} onClick=${() => call('Sound', 'set_volume', [to / 10])}>${label === 'Louder' ? '+' : '−'}</button>`;
  return html`<div class="therapist">
    <div class="head"><h2>${recorded ? 'Recording' : script.value?.title || 'Session'}</h2><span class="grow"></span>
      <span>Battery ${battery} %</span><span>${hottest > 60 ? 'Joints warm' : 'Joints cool'}, ${Math.round(hottest ?? 0)} °C</span></div>
    <div role="status" class=${`mood ${state === 'stopped' ? 'halt' : runs ? 'go' : state === 'paused' ? 'wait' : ''}`}><b>${title}</b>
      <span>${recorded ? html`<strong>A recording:</strong> it shows what was, and nothing here reaches a robot.` : runs ? progress : what}${state === 'stopped' && !recorded && html`<br /><strong>It will not start again by itself.</strong>`}</span></div>
    <div class="middle"><section class="card told" aria-label="Now" tabindex="0"><div>
      ${recorded ? html`<h3>${shown.info.value.name}</h3>` : state === 'stopped' ? html`<h3>Before you go on, look</h3><p>Is the person well? Is nobody within reach of the arms? Does the robot stand firmly?</p>` : html`<h3>${part ? inWords(part) : 'This session has no parts'}</h3>`}
      ${part?.says && !part.does.startsWith('say') && html`<p>It says: “${quoted(part.says)}”</p>`}
      ${state !== 'stopped' && /arms_open/.test(part?.does) && html`<p class="dim">The robot’s arms end a little below the height of the shoulders: please show the full height yourself.</p>`}
      ${state === 'ready' && script.value && html`<ul aria-label="Checked before the start"><li>${yes}${lines}</li><li>${read('Guard', 'battery') > 0.3 ? yes : no}Battery ${battery} %</li><li>${hottest < 60 ? yes : no}The hottest joint has ${Math.round(hottest ?? 0)} °C</li><li>${no}<span><strong>Please look:</strong> is one arm’s length free around the robot?</span></li></ul>`}
      ${trouble && html`<p class="warn"><strong>${TROUBLES[trouble]}</strong></p>`}
      ${state === 'exercising' && examples < 3 && html`<p>The robot learns from three correct repetitions: <strong>${examples} of 3</strong></p>`}
      ${state === 'exercising' && hold > 0 && html`<${Bar} label="Hold" value=${Math.min(read('Mover', 'held') ?? 0, hold)} most=${hold} />`}
      ${counts && counts.repetitions > 0 && html`<p><span class="big">${counts.repetitions}</span>${recorded ? '' : ` of ${wanted}`} done: ${counts.correct} correct, ${counts.incorrect} not correct, ${counts.cannot_tell} not seen well enough</p>`}
      <${Attempts} attempts=${(read('ExerciseCheck', 'attempts') ?? []).filter((one) => one)} left=${recorded ? 0 : wanted - (counts?.repetitions ?? 0)} />
      ${ease < 100 && html`<p class="dim">Easier: ${ease} % of tempo and repetitions</p>`}
      ${runs && limit > 0 && html`<${Wait} ...${{ line: script.value?.lines[line - 1] ?? '', waited, limit }} />`}</div>
      <${Figure} targets=${read('Motors', 'targets')} /></section>
      ${!recorded && html`<section class="card parts" aria-label="Parts of this session" ref=${list}>
        <select aria-label="Open a session" onChange=${(event) => open(event.target)}>${(script.value?.files ?? []).map((file) => html`<option value=${file} selected=${file === script.value.file}>Open: ${fileName(file)}</option>`)}</select>
        ${parts.map((one, index) => html`<button key=${one.step} class=${index === now ? 'now' : ''} disabled=${state === 'finished'} title="Go to this part" onClick=${() => call('Session', 'go_to', [one.step])}>${index + 1}. ${inWords(one)}</button>`)}</section>`}</div>
    ${recorded ? html`<div class="keys"><button class="main" onClick=${playOrPause}>${playing.value ? '❚❚ Pause the recording' : '▶ Play the recording'}</button></div>` : html`<div class="keys">
      ${key('◀ Back', 'previous', over)}
      ${state === 'ready' ? key('▶ Start', 'start', false, 'main start') : state === 'paused' ? html`<button class="main start" onClick=${goOn}>▶ Go on</button>` : state === 'stopped' ? html`<${Held} done=${goOn} />`
    : state === 'finished' ? html`<button class="main start" onClick=${() => act('restart', { seed: null })}>Once more</button>` : key('❚❚ Pause', 'pause', !runs, 'main pause')}
      ${key('Next ▶', 'next', over)}${key('Repeat', 'repeat', over)}${key('Easier', 'easier', ease <= 40)}${key('Harder', 'harder', ease >= 100)}
      <span class="join" role="group" aria-label="Volume">Volume ${volume} ${level('Quieter', volume - 1)}${level('Louder', volume + 1)}</span></div>
    <p class="dim">STOP is not an emergency switch. In danger: hold the robot. The bumpers of its feet stop it, too.</p>`}</div>`;
}

/** Why there is no session, and what can be done. */
function Absent({ info }) {
  if (info?.connection === 'connecting') return html`<${Empty} what="The robot is being prepared" help="One moment, please." />`;
  if (info?.kind !== 'world') return html`<${Empty} what="There is no session here" help="Start the program again in its terminal: therapy play FILE --page" />`;
  return html`<div class="therapist"><${Empty} what="This session cannot be played" help=${info.note} />
    <div class="keys"><button class="main" onClick=${() => act('restart', { seed: null })}>Try again</button></div></div>`;
}

/** Indices of the pitch of the right and the left shoulder; their rolls follow. */
const SHOULDERS = [18, 2];

/** The robot from the front, with its upper arms as they are. */
function Figure({ targets }) {
  const arms = SHOULDERS.map((at, index) => {
    const [pitch, roll] = targets?.slice(at, at + 2) ?? [Math.PI / 2, 0];
    const [x, y] = [46 + 58 * index, 58];
    return `M${x} ${y}L${(x + 46 * Math.sin(roll)).toFixed(1)} ${(y + 46 * Math.cos(roll) * Math.sin(pitch)).toFixed(1)}`;
  });
  return html`<svg class="figure" viewBox="-10 0 170 172" aria-hidden="true"><g stroke-width="4"><rect x="55" y="6" width="40" height="34" rx="15" /><rect x="53" y="45" width="44" height="56" rx="14" /><circle cx="75" cy="64" r="6" /><path d="M67 22h1M83 22h1" /></g><path stroke-width="12" d="${arms.join('')}M64 106V150M86 106V150M56 161H70M80 161H94" /></svg>`;
}

/** What the robot waits for. Only a wait for a time has a known end; else the limit is no countdown. */
function Wait({ line, waited, limit }) {
  const [word, what, name] = line.split(/\s+/);
  if (word === 'wait' && !AWAITED[what]) return html`<${Bar} label="Waits" value=${Math.min(waited, limit)} most=${limit} />`;
  const where = word === 'wait' && /^(press|touch)$/.test(what) ? ` of ${spoken(name)}` : '';
  return html`<p class="dim">${word === 'wait' && `Waits for ${AWAITED[what]}${where}. `}Goes on after ${limit} s at the latest.</p>`;
}

/** How much of a time has passed. */
const Bar = ({ label, value, most }) => html`<p class="passed"><progress aria-label=${label} value=${value} max=${most}></progress>${label}: ${Math.floor(value)} of ${most} s</p>`;

const holds = (reasons, name) => reasons[name] === true || reasons.includes?.(name);
const MARKS = [['✓', 'correct'], ['↓', 'too low'], ['!', 'not correct'], ['?', 'not seen well enough']];

/** The newest repetitions: how high the arm came, against what is enough, and what was wrong with the last one. */
function Attempts({ attempts, left }) {
  if (attempts.length === 0) return null;
  const wrong = ({ reasons }) => Object.keys(REASONS).filter((name) => holds(reasons, name));
  const kind = (one) => {
    const found = wrong(one);
    return found.length === 0 ? 0 : ['not_seen', 'unsure'].some((name) => found.includes(name)) ? 3 : found.includes('too_low') ? 1 : 2;
  };
  const last = attempts.at(-1);
  const tops = Math.max(last.goal, ...attempts.map(({ peak }) => peak)) / 84;
  const bar = (one, index) => {
    const [height, [sign, meaning]] = [Math.max(4, one.peak / tops), MARKS[kind(one)]];
    return html`<g class="kind${kind(one)}"><title>${meaning}</title><rect x=${10 + 40 * index} y=${92 - height} width="28" height=${height} rx="4" /><text x=${24 + 40 * index} y="114">${sign}</text></g>`;
  };
  const goal = 92 - last.goal / tops;
  return html`<svg class="attempts" viewBox="0 0 470 118" role="img" aria-label="How high the arm came, the newest last">${attempts.map(bar)}
    ${Array.from({ length: Math.max(0, Math.min(left, 10 - attempts.length)) }, (_, index) => html`<circle cx=${24 + 40 * (attempts.length + index)} cy="108" r="7" />`)}
    <path d="M0 ${goal}H408M0 92H408" /><text x="440" y=${goal + 6}>goal</text></svg>
    ${kind(last) > 0 && html`<p class="last">The last one: <strong>${[...new Set(wrong(last).map((name) => REASONS[name]))].join(', ')}</strong>.</p>`}`;
}

/** A button that must be held for two seconds. */
function Held({ done }) {
  const timer = useRef(null);
  const on = useSignal(false);
  const end = () => {
    clearTimeout(timer.current);
    [timer.current, on.value] = [null, false];
  };
  const begin = (event) => {
    if (timer.current !== null || (event.type === 'keydown' && ![' ', 'Enter'].includes(event.key))) return;
    event.preventDefault();
    on.value = true;
    timer.current = setTimeout(() => {
      end();
      done();
    }, HOLD_MS);
  };
  useEffect(() => end, []);
  return html`<button class=${`main held ${on.value ? 'on' : ''}`} onPointerDown=${begin} onPointerUp=${end} onPointerLeave=${end} onKeyDown=${begin} onKeyUp=${end} onBlur=${end}>Hold 2 s to go on<i></i></button>`;
}

const offered = (shown) => shown.find('Session') >= 0 && shown.find('ExerciseCheck') >= 0;

export default {
  panels: { therapist: { title: 'Session', view: Therapist, offered } },
  presets: { therapist: { title: 'Therapist', needs: 'therapist', first: 0, plain: true, panels: () => [['therapist', {}]] } },
};
