// The store: all that panels know. Messages of the server change it; panels read its signals and call its actions.

import { batch, computed, signal } from './dom.js';
import { listen, link, request } from './connection.js';
import { Session } from './session.js';

const PROTOCOL = 1;

/** The server's first message. */
export const hello = signal(null);
/** All sessions by identifier. */
export const sessions = signal(new Map());
/** Identifier of the session that the panels show. */
export const current = signal(null);
/** The session that the panels show; null if there is none. */
export const session = computed(() => sessions.value.get(current.value) ?? null);
/** Time that all panels show, µs; null: the newest. */
export const cursor = signal(null);
/** Length of the visible interval of timeline and plots, µs, and its end; null: it ends at the newest time. */
export const range = signal({ span: 20e6, end: null });
/** Whether a recording is being played on this page. */
export const playing = signal(false);
/** Component of the first component tab. */
export const selected = signal(null);
/** Component under the pointer, in any panel. */
export const hovered = signal(null);
/** Messages for the operator: {id, level, text, help}. */
export const notices = signal([]);
/** Parameter changes that can be undone: {session, component, param, before, after}. */
export const undo = signal([]);

let lastNotice = 0;

/** Shows a message for some seconds; one that is shown already is counted. */
export function notify(level, text, help = '') {
  lastNotice += 1;
  const isSame = (one) => one.level === level && one.text === text && one.help === help;
  const notice = { id: lastNotice, level, text, help, count: (notices.value.find(isSame)?.count ?? 0) + 1 };
  notices.value = [...notices.value.filter((one) => !isSame(one)).slice(-4), notice];
  setTimeout(() => dismiss(notice.id), level === 'error' ? 12000 : 4000);
}

export const dismiss = (id) => { notices.value = notices.value.filter((notice) => notice.id !== id); };

/** Sessions whose control this page has asked to end. */
const leaving = new Set();

/** Requests that change the tree. */
const REQUESTS = new Set(['hold', 'rate', 'set', 'modulate']);

/** A request by name: panels use indices, the server takes names. */
function named(description, type, { component, modulation, settings, ...rest }) {
  const of = (index) => description.components[index];
  const setting = (one) => ({ component: of(one.component).name, param: of(one.component).params[one.param].name, value: one.value });
  if (type === 'set') return { type, settings: settings.map(setting) };
  const { name, modulations } = of(component);
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
  if ((type === 'release' || type === 'restart') && shown.info.value.control === 'yours') leaving.add(shown.id);
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
      notify('error', 'somebody else operates this robot', 'press “Take control” if that is agreed');
      return false;
  }
}

/** Why this page's control of a session has ended. */
const ENDS = { other_page: 'another page has taken control', other_monitor: 'another monitor has taken control', free: 'the log says why; holds, rates and modulations have ended' };

/** Reports who operates now. The server first ends this page's control, and then gives it to another page. */
function controlEnded({ id, info }) {
  if (leaving.delete(id)) return;
  setTimeout(() => {
    if (info.value.control !== 'yours') notify('error', `you no longer operate ${info.value.name}`, ENDS[info.value.control]);
  }, 500);
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
  if (result !== undefined) undo.value = [...undo.value.slice(-199), { session: shown.id, before, after: settings }];
  return result;
}

export async function undoParams() {
  const last = undo.value.at(-1);
  if (!last) return;
  undo.value = undo.value.slice(0, -1);
  await command('set', { settings: last.before }, 'the last change was undone');
}

// ---- what the page watches

const wishes = new Set();
let watchTimer = null;

/** Registers what a panel watches: {info: [[component, index]], conditions, images, costs, truth}. Returns how to end it. */
export function watch(wish) {
  wishes.add(wish);
  watchSoon();
  return () => {
    wishes.delete(wish);
    watchSoon();
  };
}

const watchSoon = () => { watchTimer ??= setTimeout(sendWatch, 30); };

function wishedInfo() {
  const every = new Map();
  for (const wish of wishes) {
    for (const [component, info, rate = 3] of wish.info ?? []) {
      const key = `${component}.${info}`;
      every.set(key, { component, info, every: Math.min(rate, every.get(key)?.every ?? rate) });
    }
  }
  return [...every.values()];
}

let lastWatch = '';
/** Sends what is watched also if it is the same: the server, or the session, is another one. */
function watchAnew() {
  lastWatch = '';
  watchSoon();
}

function sendWatch() {
  watchTimer = null;
  const shown = session.value;
  if (!shown?.description.value || link.value !== 'open') return;
  const all = [...wishes];
  const message = {
    session: shown.id,
    watch: {
      info: wishedInfo(),
      conditions: [...new Set(all.flatMap((wish) => wish.conditions ?? []))],
      images: all.some((wish) => wish.images) ? { max_hz: 30 } : null,
      costs: all.some((wish) => wish.costs),
      truth: all.some((wish) => wish.truth),
    },
  };
  const text = JSON.stringify(message);
  if (text === lastWatch) return;
  lastWatch = text;
  ask('watch', message);
  if (cursor.value !== null) seekSoon();
}

// ---- the cursor

let seeking = false;
let seekAgain = false;

/** Shows another time; null: the newest, or the end of a recording. */
export function seek(time) {
  const shown = session.value;
  if (!shown) return;
  const { kind, from_us, until_us } = shown.info.value;
  const newest = Math.max(until_us, shown.live.value?.time_us ?? 0);
  const at = time === null && kind !== 'recording' ? null : Math.round(Math.min(Math.max(time ?? newest, from_us), newest));
  batch(() => {
    cursor.value = at;
    const { span, end } = range.value;
    if (at === null) range.value = { span, end: null };
    // The interval stays within the known time, except for a margin.
    else if (end === null || at > end || at < end - span) range.value = { span, end: Math.max(Math.min(at + span / 2, newest + span * 0.02), from_us + span * 0.98) };
  });
  if (at === null) {
    playing.value = false;
    batch(() => shown.showNewest());
  } else seekSoon();
}

/** Identifier of the request whose image is shown. */
let asked = 0;

/** Asks for the state at the cursor. While an answer is pending, only the last request is kept. */
async function seekSoon() {
  if (seeking) {
    seekAgain = true;
    return;
  }
  const shown = session.value;
  const at = cursor.value;
  if (!shown || at === null) return;
  seeking = true;
  try {
    const info = wishedInfo().map((wish) => [wish.component, wish.info]);
    const image = [...wishes].some((wish) => wish.images);
    const answer = request('at', { session: shown.id, time_us: at, info, image });
    asked = answer.id;
    const moment = await answer;
    if (cursor.value !== null && shown === session.value) batch(() => shown.showMoment(moment, info, image));
  } catch (error) {
    if (!seekAgain) notify('error', error.text ?? String(error), error.help ?? '');
  }
  seeking = false;
  if (seekAgain) {
    seekAgain = false;
    seekSoon();
  }
}

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

// ---- messages

/** Reads the whole log: this page does not know yet when it ends. */
async function readLines(of) {
  try {
    of.setLines(await request('lines', { session: of.id, from_us: 0, until_us: Number.MAX_SAFE_INTEGER, limit: 2000 }));
  } catch {
    // New lines are sent in any case.
  }
}

const sessionOf = (id) => sessions.value.get(id);

/** Closed sessions; messages about them may still arrive. */
const gone = new Set();

function showSession(info) {
  if (gone.has(info.id)) return;
  const known = sessionOf(info.id);
  if (known) {
    const before = known.info.value;
    known.info.value = info;
    // A restarted game has no past.
    if (known === session.value && info.kind !== 'recording' && cursor.value > info.until_us && info.until_us < before.until_us) seek(null);
    if (before.control === 'yours' && info.control !== 'yours' && info.control !== 'unavailable') controlEnded(known);
    // The server knows all lines of a recording when it has read it.
    if (info.kind === 'recording' && before.connection === 'connecting' && info.connection !== 'connecting') {
      readLines(known);
      if (known.untouched === range.value) whole(known);
    }
    begin(known);
    return;
  }
  sessions.value = new Map(sessions.value).set(info.id, new Session(info));
  if (current.value === null || !sessions.value.has(current.value)) show(info.id);
}

/** Shows the beginning of a recording, once some of it was read. */
function begin(of) {
  const { kind, from_us, until_us } = of.info.value;
  if (kind !== 'recording' || of.begun || of !== session.value || !of.description.value || until_us === 0) return;
  of.begun = true;
  if (cursor.value === null) seek(of.left ?? from_us);
  of.untouched = range.value;
  if (of.info.value.connection !== 'connecting') whole(of);
}

/** Longest recording that is shown whole when it is opened, µs. */
const WHOLE = 120e6;

function whole(of) {
  const { from_us, until_us } = of.info.value;
  const span = Math.max(Math.min(until_us - from_us, WHOLE), 1e6);
  range.value = { span, end: from_us + span };
}

/** Shows another session in all panels. */
export function show(id) {
  if (current.value === id) return;
  const [before, next] = [session.value, sessionOf(id)];
  if (before) {
    [before.left, before.begun] = [cursor.value, false];
    before.showNewest();
  }
  batch(() => {
    current.value = id;
    cursor.value = null;
    playing.value = false;
    range.value = { span: range.value.span, end: null };
    undo.value = [];
  });
  watchAnew();
  if (next) begin(next);
}

/** Whether the newest of a session is shown, and not its past. */
const isNewest = (of) => cursor.value === null || of !== session.value;

const HANDLERS = {
  hello(message) {
    if (message.protocol !== PROTOCOL) return location.reload();
    const before = current.value;
    gone.clear();
    batch(() => {
      hello.value = message;
      const ids = new Set(message.sessions.map((info) => info.id));
      sessions.value = new Map([...sessions.value].filter(([id]) => ids.has(id)));
      message.sessions.forEach(showSession);
      if (!ids.has(before)) show(message.sessions[0]?.id ?? null);
    });
    watchAnew();
    return undefined;
  },
  session: (message) => showSession(message.session),
  closed(message) {
    gone.add(message.session);
    const rest = new Map(sessions.value);
    rest.delete(message.session);
    batch(() => {
      sessions.value = rest;
      if (current.value === message.session) show(rest.keys().next().value ?? null);
    });
  },
  described(message, of) {
    of.describe(message.description, message.drawing);
    readLines(of);
    if (of !== session.value) return;
    watchAnew();
    begin(of);
  },
  update(message, of) {
    of.live.value = message;
    if (isNewest(of)) of.moment.value = message;
  },
  info(message, of) {
    const changed = new Set();
    for (const [component, index, time, value] of message.samples) {
      const information = of.info_of(component, index);
      information.add(time, value);
      changed.add(information);
    }
    for (const information of changed) {
      if (isNewest(of)) information.showNewest();
      information.version.value += 1;
    }
  },
  conditions(message, of) {
    of.newest.conditions.set(message.component, message);
    if (isNewest(of)) of.conditions_of(message.component).value = message;
  },
  costs(message, of) {
    of.newest.costs = message;
    if (isNewest(of)) of.costs.value = message;
    const worst = [...of.worst.value, { time: message.worst_us, us: message.chain_us[1] }];
    of.worst.value = worst.sort((a, b) => b.us - a.us).slice(0, 20);
  },
  scenery(message, of) {
    of.scenery.value = message.scenery;
  },
  truth(message, of) {
    of.newest.truth = message;
    if (isNewest(of)) of.truth.value = message;
  },
  params(message, of) { of.params.value = of.params.value.with(message.component, message.values); },
  log: (message, of) => of.addLines(message.lines),
};

listen((message, frame) => {
  if (frame) return image(frame);
  const handler = HANDLERS[message.type];
  if (!handler) return undefined;
  const of = message.session?.id ?? message.session;
  if (message.type === 'hello' || message.type === 'session' || message.type === 'closed') return handler(message);
  return sessionOf(of) && batch(() => handler(message, sessionOf(of)));
});

/** Frames that answer a request, by its identifier. */
export const classified = signal(null);

function image(frame) {
  const view = new DataView(frame);
  const begin = 32 + view.getUint8(1);
  const head = {
    kind: view.getUint8(0),
    camera: new TextDecoder().decode(new Uint8Array(frame, 32, begin - 32)),
    session: view.getUint32(4, true),
    number: view.getUint32(8, true),
    width: view.getUint16(12, true),
    height: view.getUint16(14, true),
    time_us: Number(view.getBigUint64(16, true)),
    id: view.getUint32(24, true),
  };
  const of = sessionOf(head.session);
  if (!of) return;
  const shown = { ...head, pixels: new Uint8Array(frame, begin) };
  if (head.kind === 2) classified.value = shown;
  else if (head.id === 0) {
    of.newest.image = shown;
    if (isNewest(of)) of.showImage(shown, true);
  } else if (head.id === asked && !isNewest(of)) of.showImage(shown, false);
}

// ---- control: the lease ends 3 s after the last message of a page that froze or was closed

setInterval(() => {
  for (const one of sessions.value.values()) {
    if (one.info.value.control === 'yours') request('keep', { session: one.id }).catch(() => {});
  }
}, 500);
