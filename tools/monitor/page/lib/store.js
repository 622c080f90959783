// The store: all that panels know. Messages of the server, in messages.js, change it; panels read its signals and call its actions.

import { batch, computed, effect, signal, untracked } from './dom.js';
import { link, request } from './connection.js';

/** The server's first message. */
export const hello = signal(null);
/** All sessions by identifier. */
export const sessions = signal(new Map());
/** Identifier of the session that the panels show. */
export const current = signal(null);
/** The session that the panels show; null if there is none. */
export const session = computed(() => sessions.value.get(current.value) ?? null);
/** Sessions that are shown beside the chosen one: from the identifier to what is added to a time of the chosen one, µs. */
const beside = signal(new Map());
/** The same with their trees: [{of, shift, place}]; `place` chooses the colour. */
export const companions = computed(() => [...beside.value].map(([id, shift], place) => ({ of: sessions.value.get(id), shift, place })).filter(({ of }) => of && of !== session.value && of.description.value));
/** Time that all panels show, µs; null: the newest. */
export const cursor = signal(null);
/** Length of the visible interval of timeline and plots, µs, and its end; null: it ends at the newest time. One that grows has all of a short run. */
export const range = signal({ span: 20e6, end: null, grows: true });
/** Whether a recording is being played on this page. */
export const playing = signal(false);
/** Component of the first component tab. */
export const selected = signal(null);
/** Component under the pointer, in any panel. */
export const hovered = signal(null);
/** Messages for the operator: {id, level, text, help, action}; an action is {label, run}. */
export const notices = signal([]);
/** Parameter changes that can be undone: {session, component, param, before, after}. */
export const undo = signal([]);
/** Those that were undone and can be done again. */
export const redo = signal([]);

let lastNotice = 0;

/** Shows a message for some seconds; one that is shown already is counted. */
export function notify(level, text, help = '', action = null) {
  lastNotice += 1;
  const isSame = (one) => one.level === level && one.text === text && one.help === help;
  const notice = { id: lastNotice, level, text, help, action, count: (notices.value.find(isSame)?.count ?? 0) + 1 };
  notices.value = [...notices.value.filter((one) => !isSame(one)).slice(-4), notice];
  whenSeen(() => setTimeout(() => dismiss(notice.id), level === 'error' ? 12000 : 4000));
}

/** Runs a function now, or when the tab of this page is shown. */
function whenSeen(run) {
  if (!document.hidden) run();
  else document.addEventListener('visibilitychange', () => whenSeen(run), { once: true });
}

export const dismiss = (id) => { notices.value = notices.value.filter((notice) => notice.id !== id); };

/** Sessions whose control this page has asked to end. */
export const leaving = new Set();

/** Requests that change the tree. */
const REQUESTS = new Set(['hold', 'rate', 'set', 'modulate', 'go']);

/** A request by name: panels use indices, the server takes names. */
function named(description, type, { component, modulation, settings, ...rest }) {
  const of = (index) => description.components[index];
  const setting = (one) => ({ component: of(one.component).name, param: of(one.component).params[one.param].name, value: one.value });
  if (type === 'set') return { type, settings: settings.map(setting) };
  const { name, modulations, states } = of(component);
  if (type === 'go') return { type, component: name, state: states[rest.state].name };
  return { type, component: name, ...(type === 'modulate' && { modulation: modulations[modulation].name }), ...rest };
}

/** Sends a request of the current session; an error becomes a notice. Resolves to undefined after an error. */
export async function act(type, fields = {}, done = '') {
  const shown = session.value;
  if (!shown) {
    notify('error', 'no session is open', 'open a world, a robot or a recording first');
    return undefined;
  }
  if (REQUESTS.has(type)) return ask('operate', { session: shown.id, request: named(shown.description.value, type, fields) }, done);
  if (type === 'release' && shown.info.value.control === 'yours') leaving.add(shown.id);
  return ask(type, { session: shown.id, ...fields }, done);
}

/** Sends a request; an error becomes a notice. */
export async function ask(type, fields = {}, done = '') {
  try {
    const result = await request(type, fields);
    if (done) notify('done', done);
    return result ?? null;
  } catch (error) {
    notify('error', error.text ?? String(error), error.help ?? '');
    return undefined;
  }
}

/** Becomes the operator if nobody is; otherwise reports why not. */
export async function operate() {
  const info = session.value?.info.value;
  if (!info) return false;
  switch (info.control) {
    case 'yours': return true;
    case 'free': return (await act('acquire')) !== undefined;
    case 'unavailable':
      notify('error', hello.value?.read_only ? 'this program lets pages only watch' : 'this session cannot be operated',
        hello.value?.read_only ? 'start it without --read-only' : 'open a world or a robot');
      return false;
    default:
      notify('error', 'somebody else operates this robot', 'take control if that is agreed', { label: 'Take control', run: () => act('take', {}, 'control was taken') });
      return false;
  }
}

/** Sends a request that only the operator may send. */
export async function command(type, fields = {}, done = '') {
  return (await operate()) ? act(type, fields, done) : undefined;
}

/** Sets parameters, all or none, and remembers how to undo it. */
export async function setParams(settings) {
  const shown = session.value;
  const before = settings.map(({ component, param }) => ({ component, param, value: shown.params.value[component][param] }));
  const result = await command('set', { settings });
  if (result !== undefined) [undo.value, redo.value] = [[...undo.value.slice(-199), { session: shown.id, before, after: settings }], []];
  return result;
}

/** Takes the last change of a list, and puts it on the other one. */
async function move(from, to, settings, done) {
  const last = from.value.at(-1);
  if (!last) return;
  from.value = from.value.slice(0, -1);
  if ((await command('set', { settings: last[settings] }, done)) !== undefined) to.value = [...to.value, last];
}

export const undoParams = () => move(undo, redo, 'before', 'the last change was undone');
export const redoParams = () => move(redo, undo, 'after', 'the change was made again');

// ---- what the page watches

const wishes = new Set();
let watchTimer = null;

/** Registers what a panel watches: {info: [[component, index]], conditions, images, costs, truth}, `of` the chosen session or another one. Returns how to end it. */
export function watch(wanted, of = null) {
  const wish = { ...wanted, of };
  wishes.add(wish);
  watchSoon();
  return () => {
    wishes.delete(wish);
    watchSoon();
  };
}

const watchSoon = () => { watchTimer ??= setTimeout(sendWatch, 30); };

const wishesOf = (of) => [...wishes].filter((wish) => (wish.of ?? session.value) === of);

function wishedInfo(of) {
  const every = new Map();
  for (const wish of wishesOf(of)) {
    for (const [component, info, rate = 3] of wish.info ?? []) {
      const key = `${component}.${info}`;
      every.set(key, { component, info, every: Math.min(rate, every.get(key)?.every ?? rate) });
    }
  }
  return [...every.values()];
}

/** What was sent last, by session. */
const sent = new Map();
/** Sends what is watched also if it is the same: the server, or the session, is another one. */
export function watchAnew() {
  sent.clear();
  watchSoon();
}

/** What is watched of a session; of one that is not shown, what names it. */
function watched(of) {
  const all = wishesOf(of);
  return {
    info: wishedInfo(of),
    conditions: [...new Set(all.flatMap((wish) => wish.conditions ?? []))],
    images: all.some((wish) => wish.images) ? { max_hz: 30 } : null,
    costs: all.some((wish) => wish.costs),
    truth: all.some((wish) => wish.truth),
  };
}

function sendWatch() {
  watchTimer = null;
  if (link.value !== 'open') return;
  let isNew = false;
  for (const of of sessions.value.values()) {
    const text = JSON.stringify(watched(of));
    if (!of.description.value || (!isShown(of) && !sent.has(of.id) && wishesOf(of).length === 0) || sent.get(of.id) === text) continue;
    sent.set(of.id, text);
    ask('watch', { session: of.id, watch: JSON.parse(text) });
    isNew = true;
  }
  if (isNew) seekSoon();
}

// ---- the cursor

const newestOf = (of) => Math.max(of?.live.value?.time_us ?? 0, of?.info.value.until_us ?? 0);
/** Newest time of the session, µs. */
export const newest = computed(() => newestOf(session.value));

/** Lengths of an interval that grows, µs; a longer run has the last one, up to its newest time. */
const ROUND = [5e6, 10e6, 20e6, 30e6, 60e6];

/** Visible interval: [from, until], µs. */
export const visibleRange = computed(() => {
  const { span, end, grows } = range.value;
  if (end !== null) return [end - span, end];
  const begin = session.value?.info.value.from_us ?? 0;
  const length = grows ? ROUND.find((one) => begin + one * 0.98 >= newest.value) ?? ROUND.at(-1) : span;
  // A session shorter than the interval begins at the left.
  const until = Math.max(newest.value + length * 0.02, begin + length);
  return [until - length, until];
});

let seeking = false;
let seekAgain = false;

/** Shows another time; null: the newest, or the end of a recording. */
export function seek(time) {
  const shown = session.value;
  if (!shown) return;
  const { kind, from_us } = shown.info.value;
  const last = newest.value;
  const at = time === null && kind !== 'recording' ? null : Math.round(Math.min(Math.max(time ?? last, from_us), last));
  batch(() => {
    cursor.value = at;
    const [from, until] = visibleRange.value;
    const span = until - from;
    if (at === null) range.value = { ...range.value, end: null };
    else if (at >= from && at <= until) range.value = { ...range.value, span, end: until };
    // The interval stays within the known time, except for a margin.
    else range.value = { ...range.value, span, end: Math.max(Math.min(at + span / 2, last + span * 0.02), from_us + span * 0.98) };
  });
  if (at === null) {
    playing.value = false;
    batch(() => shownSessions().forEach((of) => of.showNewest()));
  }
  seekSoon();
}

/** Identifier of the request whose image is shown. */
let asked = 0;
export const isAsked = (id) => id === asked;

/** The shown sessions of which a moment of the past is shown, with its time: beside the newest of a robot a recording stands at its time. */
function moments() {
  const all = [{ of: session.value, shift: 0 }, ...companions.value].filter(({ of }) => of && (cursor.value !== null || (of !== session.value && of.info.value.kind === 'recording')));
  const within = (of, time) => Math.round(Math.min(Math.max(time, of.info.value.from_us), newestOf(of)));
  return all.map(({ of, shift }) => [of, of === session.value ? cursor.value : within(of, (cursor.value ?? newest.value) + shift)]);
}

/** Asks for the states at the cursor. While an answer is pending, only the last request is kept. */
async function seekSoon() {
  seekAgain = seeking;
  const all = moments();
  if (seeking || all.length === 0) return;
  seeking = true;
  await Promise.all(all.map(([of, at]) => showAt(of, at)));
  seeking = false;
  if (seekAgain) seekSoon();
}

async function showAt(of, at) {
  of.sought = at;
  try {
    const info = wishedInfo(of).map((wish) => [wish.component, wish.info]);
    const image = wishesOf(of).some((wish) => wish.images);
    const answer = request('at', { session: of.id, time_us: at, info, image });
    if (of === session.value) asked = answer.id;
    const moment = await answer;
    if (moments().some(([one]) => one === of)) batch(() => of.showMoment(moment, info, image));
  } catch (error) {
    if (!seekAgain) notify('error', error.text ?? String(error), error.help ?? '');
  }
}

// A recording beside a robot moves with it; a world that is slower than the chosen one reaches a shown moment later.
effect(() => {
  const at = cursor.value;
  void newest.value;
  const comes = ({ of, shift }) => newestOf(of) > of.sought && of.sought < Math.round(at + shift);
  const late = companions.value.map((one) => at !== null && comes(one));
  if (at === null || late.includes(true)) untracked(seekSoon);
});

/** Moves the cursor by a duration; a step forward from the newest time does nothing. */
export function step(us) {
  const shown = session.value;
  if (!shown) return;
  const at = cursor.value ?? (us < 0 ? shown.live.value?.time_us ?? shown.info.value.until_us : null);
  if (at !== null) seek(at + us);
}

/** Live, or the end of a recording. */
export const isLive = computed(() => cursor.value === null);
/** Length of a cycle, µs. */
export const cycle_us = computed(() => 1e6 / (session.value?.description.value?.cycle_hz || 100));

// ---- sessions

/** Shows the beginning of a recording, once some of it was read. */
export function begin(of) {
  const { kind, from_us, until_us } = of.info.value;
  if (kind !== 'recording' || of.begun || of !== session.value || !of.description.value || until_us === 0) return;
  of.begun = true;
  if (cursor.value === null) seek(of.left ?? from_us);
  of.untouched = range.value;
  if (of.info.value.connection !== 'connecting') whole(of);
}

/** Longest recording that is shown whole when it is opened, µs. */
const WHOLE = 120e6;

export function whole(of) {
  const { from_us, until_us } = of.info.value;
  const span = Math.max(Math.min(until_us - from_us, WHOLE), 1e6);
  range.value = { span, end: from_us + span };
}

/** Shows another session in all panels. */
export function show(id) {
  if (current.value === id) return;
  const [before, next] = [session.value, sessions.value.get(id)];
  if (before) {
    [before.left, before.begun] = [cursor.value, false];
    before.showNewest();
  }
  const shift = beside.value.get(id);
  const others = [...beside.value].filter(([other]) => other !== id).map(([other, more]) => [other, more - shift]);
  batch(() => {
    // Of two sessions side by side the other one is chosen; else nothing stays beside.
    if (shift !== undefined && next.info.value.kind === 'recording') next.left = (cursor.value ?? newest.value) + shift;
    beside.value = new Map(shift === undefined ? [] : [[before.id, -shift], ...others]);
    current.value = id;
    cursor.value = null;
    playing.value = false;
    range.value = { span: 20e6, end: null, grows: true };
    [undo.value, redo.value] = [[], []];
  });
  watchAnew();
  if (next) begin(next);
}

const shownSessions = () => [session.value, ...companions.value.map(({ of }) => of)];
/** Whether a session is chosen, or shown beside the chosen one. */
export const isShown = (of) => of === session.value || beside.value.has(of.id);
/** Whether the newest of a session is shown, and not its past. */
export const isNewest = (of) => cursor.value === null || !isShown(of);

/** What is added to the time of a session for that of another one: two that go on have one present, others one beginning. */
function shiftTo(one, other) {
  const isRecorded = [one, other].some(({ info }) => info.value.kind === 'recording');
  return isRecorded ? other.info.value.from_us - one.info.value.from_us : newestOf(other) - newestOf(one);
}

/** Shows a session beside the chosen one, or not any more. */
export function putBeside(id, on = !beside.value.has(id)) {
  const [next, of] = [new Map(beside.value), sessions.value.get(id)];
  if (on && of && of !== session.value) next.set(id, shiftTo(session.value, of));
  else next.delete(id);
  beside.value = next;
  if (of) of.showNewest();
  watchSoon();
  seekSoon();
}

/** Frames that answer a request, by its identifier. */
export const classified = signal(null);
