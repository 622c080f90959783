// Driving by hand: the robot is taken over, its body and head are moved by modulations, and it is given back.

import { html, useEffect, useRef, useSignal } from '../lib/dom.js';
import { niceStep, number, words } from '../lib/format.js';
import { visuals } from '../lib/frames.js';
import { on } from '../lib/listen.js';
import { act, command, notify, operate, session } from '../lib/store.js';
import { Empty } from '../lib/ui.js';

/** Time between two calls while something moves. */
const REPEAT_MS = 100;
/** Change of a value per call while its key is held, as a share of its range. */
const RAMP = 0.06;
const DEAD_ZONE = 0.12;
/** Keys of the arguments: the one that increases and the one that decreases. */
const KEYS = { forward: ['KeyW', 'KeyS'], left: ['KeyQ', 'KeyE'], turn: ['KeyA', 'KeyD'], pan: ['KeyJ', 'KeyL'], tilt: ['KeyK', 'KeyI'] };
/** Axes of a gamepad: number and sign. */
const AXES = { forward: [1, -1], turn: [0, -1], left: [-1, 0], pan: [2, -1], tilt: [3, 1] };
const SHOULDERS = [4, 5];

/** Finds the first modulation that drives and has this argument. */
function find(description, argument) {
  const all = description.components.flatMap(({ name, modulations }, component) => modulations.map((one, number) => ({
    component, number, name, drives: one.drives, arguments: one.arguments, stop: modulations.findIndex((other) => /^(stand|stop)$/.test(other.name) && !other.stops && other.arguments.length === 0),
  })));
  return all.find(({ drives, arguments: given }) => drives && given.some(({ name }) => name === argument)) ?? null;
}

/** What moves the robot: {body, head}; each is null if there is no such modulation. */
export const driven = (description) => ({ body: find(description, 'forward'), head: find(description, 'pan') });

/** Whether an operator can drive the robot of a session. */
export const canDrive = (shown) => shown.info.value.can.operate && Object.values(driven(shown.description.value)).some(Boolean);

/** Components that move the head but not the body: they can be held active while the body is driven. */
function leaders(description, { body, head }) {
  if (!head) return [];
  const moves = ({ links }, part) => part !== null && links.some(({ to, kind }) => kind === 'modulation' && to === part.component);
  return description.components.flatMap((one, component) => (component !== description.root && moves(one, head) && !moves(one, body) ? [component] : []));
}

/**
 * Components whose outputs the map draws, or that place a frame, and that would end with the root: they are held active, so that the map
 * goes on. None of them moves anything.
 */
function drawn({ components, root, ...description }, now, moved) {
  const below = (part, found = new Set()) => {
    for (const { to } of components[part].links) if (!found.has(to)) below(to, found.add(to));
    return found;
  };
  const moves = (part) => [part, ...below(part)].some((one) => components[one].links.some(({ kind }) => kind === 'modulation'));
  const kept = new Set(moved.flatMap((part) => [part, ...below(part)]));
  const all = visuals({ components, ...description }, false).filter(({ component, info }) => now?.[component]?.[0] || info.child);
  const wanted = [...new Set(all.map(({ component }) => component))].filter((one) => one !== root && !kept.has(one) && !moves(one));
  return wanted.filter((one) => !wanted.some((other) => below(other).has(one)));
}

export function Drive({ visible }) {
  const shown = session.value;
  const description = shown?.description.value;
  if (!description) return html`<${Empty} what="Nothing to drive" help="Open a world or a robot first." />`;
  if (!shown.info.value.can.operate) return html`<${Empty} what="This session can only be watched" help=${shown.info.value.kind === 'recording' ? 'A recording is what happened. Open a world or a robot to drive.' : 'The robot, or this program, allows no operator.'} />`;
  const { body, head } = driven(description);
  if (!body && !head) return html`<${Empty} what="This tree cannot be driven here" help="The panel needs a modulation that drives: #[modulation(drives)]. Other modulations are in the component tabs." />`;
  return html`<${Controls} key=${description.hash} ...${{ shown, description, body, head, visible }} />`;
}

function Controls({ shown, description, body, head, visible }) {
  const root = description.root;
  // What is driven is the present, also while the page shows the past.
  const now = shown.live.value?.components;
  const held = (part) => now?.[part?.component]?.[1] === 'active';
  const taken = shown.info.value.control === 'yours' && now?.[root]?.[1] === 'latent';
  const followers = leaders(description, { body, head });
  const leader = followers.find((component) => now?.[component]?.[1] === 'active') ?? -1;
  const follows = leader >= 0;
  const has = (argument) => body?.arguments.some(({ name }) => name === argument);
  const moving = useSignal(false);
  const values = useSignal({ forward: 0, left: 0, turn: 0, pan: 0, tilt: 0 });
  const keys = useRef(new Set());
  const panel = useRef(null);

  const hold = (component, kind) => act('hold', { component, hold: kind });
  const take = async () => {
    if (!(await operate())) return;
    const moved = [body, head].filter(Boolean).map(({ component }) => component);
    const seen = drawn(description, now, moved);
    await hold(root, 'latent');
    for (const component of [...moved, ...seen]) await hold(component, 'active');
    notify('done', `${description.name} is taken over`, 'hold Shift, or the button, to move');
  };
  const give = () => act('release', {}, `${description.name} was given back`);
  const lead = async (chosen) => {
    if (follows) await command('hold', { component: leader, hold: 'tree' });
    if (chosen >= 0) await command('hold', { component: chosen, hold: 'active' });
  };
  const send = (part) => act('modulate', { component: part.component, modulation: part.number, arguments: part.arguments.map(({ name }) => values.value[name]) });
  const stop = () => {
    if (!moving.value) return;
    moving.value = false;
    keys.current.clear();
    values.value = { ...values.value, forward: 0, left: 0, turn: 0 };
    if (body && shown.info.value.control === 'yours') {
      if (body.stop >= 0) act('modulate', { component: body.component, modulation: body.stop, arguments: [] });
      else send(body);
    }
  };
  // What the loop needs, always as of the last rendering.
  const state = useRef({});
  Object.assign(state.current, { taken, body, head, follows, send, stop, values, moving });
  useLoop(state, keys, visible);
  useKeyboard(state, keys, visible, moving, stop, panel);

  const dead = {
    onPointerDown: (event) => { event.currentTarget.setPointerCapture(event.pointerId); moving.value = true; },
    onPointerUp: stop, onPointerCancel: stop, onBlur: stop,
    onKeyDown: (event) => { if ((event.key === ' ' || event.key === 'Enter') && !event.repeat) { moving.value = true; event.preventDefault(); } },
    onKeyUp: (event) => { if (event.key === ' ' || event.key === 'Enter') stop(); },
  };
  return html`<article class="tab drive" ref=${panel}>
    <section aria-label="Take over"><h3>Driven by ${taken ? 'you' : description.name}</h3>
      <p class="dim">${taken ? 'The root is held latent. Your requests end when you give the robot back, or 3 s after this page is closed.' : 'Take over: the root is held latent; what moves the robot, and what the map shows, is held active.'}</p>
      <div class="buttons">${taken ? html`<button class="primary" onClick=${give}>Give back</button>` : html`<button class="primary" onClick=${take}>Take over</button>`}
        ${followers.length > 0 && html`<label>Head moved by <select aria-label="Head moved by" disabled=${!taken} title="A component that is held active" onChange=${(event) => lead(shown.find(event.target.value))}>
          ${[-1, ...followers].map((component) => html`<option selected=${component === leader}>${description.components[component]?.name ?? 'you'}</option>`)}</select></label>`}</div>
    </section>
    ${body && html`<section aria-label="Body"><h3>Body ${held(body) ? '' : html`<span class="dim">not held</span>`}</h3>
      <${Sliders} ...${{ part: body, values, disabled: !taken }} />
      <button class=${`deadman ${moving.value ? 'on' : ''}`} disabled=${!taken} aria-pressed=${moving.value} aria-label="Dead-man's button: hold to move" ...${dead}>${moving.value ? 'Moving — release to stand' : 'Hold to move'}</button></section>`}
    ${head && html`<section aria-label="Head"><h3>Head ${follows ? html`<span class="dim">moved by ${description.components[leader].name}</span>` : ''}</h3>
      <${Sliders} ...${{ part: head, values, disabled: !taken || follows, live: () => send(head) }} /></section>`}
    <section aria-label="Keys of driving"><h3>Keys</h3>
      <p class="dim"><kbd>Shift</kbd> held: may move · <kbd>W</kbd><kbd>S</kbd> forward · <kbd>A</kbd><kbd>D</kbd> turn${has('left') && html` · <kbd>Q</kbd><kbd>E</kbd> sideways`}${head && html` · <kbd>I</kbd><kbd>K</kbd><kbd>J</kbd><kbd>L</kbd> head`}. With a gamepad: hold a shoulder button; left stick body${head && ', right stick head'}. The keys work while this panel has the focus.</p></section>
  </article>`;
}

function Sliders({ part, values, disabled, live }) {
  const set = (name, value) => {
    values.value = { ...values.value, [name]: value };
    live?.();
  };
  return part.arguments.map(({ name, min, max, step, unit, doc }) => html`<div class="row" title=${doc}><label>${words(name)}</label>
    <input type="range" aria-label=${`${part.name} ${name}`} min=${min} max=${max} step=${step ?? niceStep(max - min)} disabled=${disabled} value=${values.value[name]} onInput=${(event) => set(name, Number(event.target.value))} onDblClick=${() => set(name, 0)} />
    <span class="v">${number(values.value[name])} <span class="unit">${unit}</span></span></div>`);
}

/** Ten times a second: keys and gamepad change the values, and what moves is sent. */
function useLoop(state, keys, visible) {
  useEffect(() => {
    const timer = setInterval(() => {
      const { taken, body, head, follows, send, stop, values, moving } = state.current;
      if (!taken) {
        if (moving.value) moving.value = false;
        return;
      }
      const pad = visible.peek() ? [...(navigator.getGamepads?.() ?? [])].find((one) => one?.connected) : null;
      const gamepad = pad && SHOULDERS.some((button) => pad.buttons[button]?.pressed);
      const changed = { ...values.value };
      let headMoves = false;
      for (const part of [body, head]) {
        for (const { name, min, max } of part?.arguments ?? []) {
          const [up, down] = KEYS[name] ?? [];
          const pressed = (keys.current.has(up) ? 1 : 0) - (keys.current.has(down) ? 1 : 0);
          if (pressed) changed[name] += pressed * RAMP * (max - min);
          const [axis, sign] = AXES[name] ?? [-1];
          const tilt = pad && axis >= 0 ? (pad.axes[axis] ?? 0) * sign : 0;
          if (gamepad && part === body) changed[name] = Math.abs(tilt) > DEAD_ZONE ? (tilt > 0 ? tilt * max : -tilt * min) : 0;
          else if (gamepad && Math.abs(tilt) > DEAD_ZONE) changed[name] += tilt * RAMP * (max - min);
          changed[name] = Math.min(max, Math.max(min, changed[name]));
          headMoves ||= part === head && changed[name] !== values.value[name];
        }
      }
      if (Object.keys(changed).some((name) => changed[name] !== values.value[name])) values.value = changed;
      if (gamepad && !moving.value) {
        moving.value = true;
        state.current.byPad = true;
      } else if (!gamepad && state.current.byPad) {
        state.current.byPad = false;
        stop();
      }
      if (moving.value && body) send(body);
      if (headMoves && head && !follows) send(head);
    }, REPEAT_MS);
    return () => clearInterval(timer);
  }, []);
}

/** Shift is the dead-man's key while the panel has the focus. */
function useKeyboard(state, keys, visible, moving, stop, panel) {
  useEffect(() => {
    const all = new Set(Object.values(KEYS).flat());
    const inside = () => visible.peek() && panel.current?.closest('.panel').contains(document.activeElement);
    const down = (event) => {
      if (!state.current.taken || !inside()) return;
      if (event.key === 'Shift' && !event.repeat) moving.value = true;
      if (!all.has(event.code) || event.ctrlKey || event.altKey || event.metaKey) return;
      keys.current.add(event.code);
      event.preventDefault();
      event.stopPropagation();
    };
    const up = (event) => {
      keys.current.delete(event.code);
      if (event.key === 'Shift') stop();
    };
    const gone = () => {
      keys.current.clear();
      stop();
    };
    const ends = [on(window, { keydown: down, keyup: up }, true), on(window, { blur: gone }), on(document, { visibilitychange: gone }), stop];
    return () => ends.forEach((end) => end());
  }, []);
}
