// Watches: conditions over outputs and parameters. One fires when its condition has held for its time, and again after the condition has
// ended. A value holds until the next one: what is stored, and what is received, has the same alerts.

import { computed, effect, signal, untracked } from './dom.js';
import { request } from './connection.js';
import { resolve } from './curves.js';
import { numberAt, typedNumber } from './format.js';
import { Output } from './session.js';
import { act, cycle_us, newest, seek, session, watch as wish } from './store.js';

/** All watches: {text, pause}: the condition with its time, as `Walk.speed > 0.2 for 1 s`, and whether a simulated world is paused. */
export const watches = signal([]);
/** What they have found in the shown session, by their texts: {spans, fired, curve, error}, times in µs. */
export const findings = signal(new Map());
/** The watch that fired last: {text, time, paused}; null if none did, or if that was dismissed. */
export const alarm = signal(null);
/** A text that a panel offers to watch. */
export const draft = signal('');

const MOST = 50;
/** Most spans, and most alerts, of a watch. */
const KEPT = 2000;
/** Samples in an answer of the server. */
const POINTS = 20000;
const UNITS = { ms: 1e3, s: 1e6, min: 60e6 };

/** A text as its condition and its time, µs. */
export function parts(text) {
  const [, condition, amount, unit] = text.match(/^(.*?)(?:\s+for\s+(\d+(?:\.\d+)?)\s*(ms|s|min))?\s*$/);
  return { condition: condition.trim(), hold_us: amount ? Number(amount) * UNITS[unit] : 0 };
}

/** The output and the number that a condition compares: {name, limit}; null for another condition. */
export function threshold(text) {
  const [, name, limit] = parts(text).condition.match(/^(\S.*?)\s*[<>]=?\s*([-+]?[\d.][-+.\de]*)$/i) ?? [];
  const value = limit ? typedNumber(limit) : NaN;
  return Number.isNaN(value) ? null : { name: name.normalize('NFC'), limit: value };
}

/** Adds a watch, or replaces another one. Throws an error that says what is wrong with its condition. */
export function keep(shown, text, pause, before = null) {
  resolve(shown, parts(text).condition);
  const one = { text, pause };
  const rest = watches.value.filter((other) => other.text !== text || other.text === before);
  watches.value = rest.some((other) => other.text === before) ? rest.map((other) => (other.text === before ? one : other)) : [...rest, one].slice(-MOST);
}

export const remove = (text) => { watches.value = watches.value.filter((one) => one.text !== text); };

/** Takes the watches of a layout, which may be anybody's file. */
export function replace(list) {
  const valid = (one) => typeof one?.text === 'string' && one.text.length <= 500;
  if (Array.isArray(list)) watches.value = list.filter(valid).slice(0, MOST).map(({ text, pause }) => ({ text, pause: pause === true }));
}

/** A watch on its way through the samples of a session. */
class Course {
  constructor(shown, text) {
    const { condition, hold_us } = parts(text);
    this.curve = resolve(shown, condition);
    [this.hold, this.evaluate] = [hold_us, this.curve.begin()];
    [this.last, this.known] = [-1, this.curve.inputs.map(() => null)];
    /** Intervals in which the condition holds; the last one may go on: its end is null. */
    this.spans = [];
    this.fired = [];
    this.armed = true;
  }

  /** Reads the samples of the inputs after the last one, up to a time. Returns whether the condition changed, or the watch fired. */
  go(sources, now) {
    const before = this.spans.length + this.fired.length + Number(this.isOn());
    const times = new Set(sources.flatMap((one) => one.times.slice(one.count(this.last))));
    for (const time of [...times].sort((a, b) => a - b)) this.step(time, sources);
    this.advance(now);
    return before !== this.spans.length + this.fired.length + Number(this.isOn());
  }

  isOn() {
    return this.spans.at(-1)?.[1] === null;
  }

  step(time, sources) {
    this.advance(time);
    this.last = time;
    this.curve.inputs.forEach(({ path }, index) => { this.known[index] = numberAt(sources[index].at(time), path) ?? this.known[index]; });
    const holds = !this.known.includes(null) && Boolean(this.evaluate(time / 1e6, this.known));
    if (holds === this.isOn()) return;
    if (holds) this.spans = [...this.spans.slice(-KEPT), [time, null]];
    else {
      this.spans.at(-1)[1] = time;
      this.armed = true;
    }
    this.advance(time);
  }

  /** Fires if the condition has held long enough at a time. */
  advance(time) {
    if (!this.isOn() || !this.armed || time - this.spans.at(-1)[0] < this.hold) return;
    this.armed = false;
    this.fired = [...this.fired.slice(-KEPT), this.spans.at(-1)[0] + this.hold];
  }
}

/** Reads the memory of a session for a course, in parts that are not thinned. */
async function readPast(shown, { inputs }) {
  const { from_us: from, until_us: until } = shown.info.peek();
  const part = Math.floor(POINTS * cycle_us.peek());
  const sources = inputs.map(() => new Output());
  for (const [index, { place }] of inputs.entries()) {
    for (let begin = from; begin <= until; begin += part) {
      const samples = await request('series', { session: shown.id, component: place[0], info: place[1], from_us: begin, until_us: begin + part - 1, points: POINTS });
      for (const [time, value] of samples) sources[index].store(time, value);
    }
  }
  return sources;
}

/** Follows a watch in a session; returns how to end it. */
function follow(shown, { text, pause }) {
  const show = (found) => { findings.value = new Map(findings.peek()).set(text, found); };
  let course;
  try {
    course = new Course(shown, text);
  } catch ({ message }) {
    show({ spans: [], fired: [], error: message });
    return () => {};
  }
  const publish = () => show({ spans: course.spans, fired: course.fired, curve: course.curve });
  publish();
  let [ended, stop] = [false, () => {}];
  const places = course.curve.inputs.map(({ place }) => place);
  const begin = async () => {
    const isLive = shown.info.peek().kind !== 'recording';
    try {
      const past = await readPast(shown, course.curve);
      if (ended) return;
      course.go(past, newest.peek());
    } catch {
      // What comes from now on is watched in any case.
    }
    publish();
    if (!isLive || ended) return;
    stop = effect(() => {
      for (const place of places) void shown.output(...place).version.value;
      const now = shown.live.value?.time_us ?? 0;
      const before = course.fired.length;
      if (!course.go(places.map((place) => shown.output(...place)), now)) return;
      setTimeout(publish);
      if (course.fired.length > before) setTimeout(() => raise(shown, { text, pause }, course.fired.at(-1)));
    });
  };
  begin();
  const unwatch = wish({ info: places.map((place) => [...place, 1]) });
  return () => {
    ended = true;
    stop();
    unwatch();
  };
}

/** Reports that a watch fired now. A simulated world is paused, and the page shows that moment. */
async function raise(shown, { text, pause }, time) {
  const { can, paused } = shown.info.peek();
  alarm.value = { session: shown.id, text, time, paused: false };
  if (!pause || !can.pause) return;
  if (!paused && (await act('pause')) === undefined) return;
  if (shown !== session.peek()) return;
  alarm.value = { session: shown.id, text, time, paused: true };
  seek(time);
}

/** Lets a paused world go on, and shows the newest. */
export function goOn() {
  alarm.value = null;
  act('resume');
  seek(null);
}

/** The description of the shown session; null while a recording is being read, which has no past yet. */
const described = computed(() => {
  const { kind, connection } = session.value?.info.value ?? {};
  return kind === 'recording' && connection === 'connecting' ? null : session.value?.description.value ?? null;
});

effect(() => {
  const list = described.value ? watches.value : [];
  return untracked(() => {
    [findings.value, alarm.value] = [new Map(), null];
    const ends = list.map((one) => follow(session.value, one));
    return () => ends.forEach((end) => end());
  });
});
