// Messages of the server: they change the store.

import { batch } from './dom.js';
import { listen, request } from './connection.js';
import { pulse } from './pulse.js';
import { Session } from './session.js';
import { begin, classified, current, cursor, hello, isAsked, isNewest, isShown, leaving, notify, range, seek, session, sessions, show, watchAnew, whole } from './store.js';

const PROTOCOL = 1;

/** Why this page's control of a session has ended. */
const ENDS = { other_page: 'another page has taken control', other_monitor: 'another monitor has taken control', free: 'the log says why; holds, rates and modulations have ended' };

/** Reports who operates now. The server first ends this page's control, and then gives it to another page. */
function controlEnded({ id, info, title }) {
  if (leaving.delete(id)) return;
  setTimeout(() => {
    if (info.value.control !== 'yours') notify('error', `you no longer operate ${title}`, ENDS[info.value.control]);
  }, 500);
}

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
    of.describe(message.description, message.kinds);
    readLines(of);
    if (!isShown(of)) return;
    watchAnew();
    begin(of);
  },
  update(message, of) {
    for (const [component, time, active] of message.changes) of.activityOf(component).add(active ? [] : [time], active ? [time] : []);
    of.live.value = message;
    if (isNewest(of)) of.moment.value = message;
  },
  info(message, of) {
    const changed = new Set();
    for (const [component, index, time, value] of message.samples) {
      const output = of.output(component, index);
      output.add(time, value);
      changed.add(output);
    }
    for (const output of changed) {
      if (isNewest(of)) output.showNewest();
      output.version.value += 1;
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
  } else if (isAsked(head.id) && !isNewest(of)) of.showImage(shown, false);
}

// ---- control: the lease ends 3 s after the last message of a page that froze or was closed

pulse(() => {
  for (const one of sessions.value.values()) {
    if (one.info.value.control === 'yours') request('keep', { session: one.id }).catch(() => {});
  }
});
