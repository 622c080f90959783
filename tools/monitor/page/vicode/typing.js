// The editor's text and the server's: one change is on its way at a time, and changes of others are put under those that are not there yet.
// What is typed while an undo waits for its answer is sent after it.

import { Annotation, ChangeSet } from '../vendor/codemirror.js';
import { Lines, endOf, plain } from './lines.js';
import { Offsets, spliced } from './offsets.js';
import { locked, opened, refuse, replace, setTyping } from './sources.js';

/** Marks what the server changed. */
export const remote = Annotation.define();

const SEND_MS = 40;

/** The changes that the server does not have, the oldest first: without an answer yet, to be sent next, and to be sent after an undo. */
const PARTS = ['sent', 'waiting', 'later'];

/** Two changes, the second after the first, as one; either may be missing. */
const both = (first, second) => (first && second ? first.compose(second) : first ?? second);

/** The changes of splices, as the editor counts. */
function changesOf(text, lists) {
  let [now, all] = [text, null];
  for (const list of lists) {
    const [offsets, lines] = [new Offsets(now), new Lines(now)];
    const at = (byte) => lines.toEditor(offsets.index(byte));
    const one = ChangeSet.of(list.map(({ span, text: put }) => ({ from: at(span[0]), to: at(span[1]), insert: plain(put) })), lines.short);
    all = all ? all.compose(one) : one;
    now = spliced(now, [list]);
  }
  return all;
}

/** The change from one text to another: what differs between their common begin and end. */
export function difference(before, after) {
  const most = Math.min(before.length, after.length);
  let first = 0;
  while (first < most && before[first] === after[first]) first += 1;
  let last = 0;
  while (last < most - first && before.at(-1 - last) === after.at(-1 - last)) last += 1;
  return ChangeSet.of({ from: first, to: before.length - last, insert: after.slice(first, after.length - last) }, before.length);
}

export class Typing {
  constructor(view) {
    this.view = view;
    [this.sent, this.waiting, this.later] = [null, null, null];
    this.held = null;
    this.timer = null;
    this.idle = [];
  }

  /** A change that was typed. */
  local(changes) {
    if (this.held) {
      this.later = both(this.later, changes);
      return;
    }
    this.waiting = both(this.waiting, changes);
    this.timer ??= setTimeout(() => this.send(), SEND_MS);
  }

  /** Sends nothing that is typed from now on until the returned function is called. */
  hold() {
    const { promise, resolve } = Promise.withResolvers();
    this.held = promise;
    return () => {
      this.held = null;
      [this.waiting, this.later] = [both(this.waiting, this.later), null];
      this.next();
      resolve();
    };
  }

  /** Whether the server does not have all that was typed. */
  get isBehind() {
    return PARTS.some((name) => this[name]);
  }

  /** A change of the server: an answer to what was sent, or somebody else's. */
  received({ message, before, text }) {
    const base = before ?? this.base;
    this.base = text;
    const expected = this.sent && this.expected;
    if (expected === plain(text)) {
      this.sent = null;
      this.next();
      return;
    }
    let changes = message.splices ? changesOf(base, message.splices) : difference(plain(base), plain(text));
    if (!changes) return;
    for (const name of PARTS) {
      if (!this[name]) continue;
      const own = this[name];
      this[name] = own.map(changes);
      changes = changes.map(own, true);
    }
    this.view.dispatch({ changes, annotations: remote.of(true), scrollIntoView: false });
  }

  /** A place of the server's text in the editor's text. */
  place(index) {
    let at = index;
    for (const name of PARTS) if (this[name]) at = this[name].mapPos(Math.min(at, this[name].length));
    return at;
  }

  async send() {
    clearTimeout(this.timer);
    this.timer = null;
    if (this.sent || !this.waiting) return this.next();
    if (locked.value) return this.giveUp(locked.value);
    const { file, version, text } = opened.value;
    const [offsets, lines, end] = [new Offsets(text), new Lines(text), endOf(text)];
    const edits = [];
    this.waiting.iterChanges((from, to, _from, _to, put) => {
      const span = [from, to].map((at) => offsets.byte(lines.toText(at)));
      edits.unshift({ edit: 'replace', span, text: put.sliceString(0, put.length, end) });
    });
    this.expected = this.waiting.apply(this.view.state.toText(plain(text))).toString();
    [this.sent, this.waiting] = [this.waiting, null];
    setTyping(true);
    try {
      await replace(file, version, edits);
    } catch (error) {
      this.refused(error);
    }
    setTyping(false);
  }

  /** Another change came first, and what was sent lies above it now; or the change is not possible. */
  refused(error) {
    if (!this.sent) return;
    [this.sent, this.waiting] = [null, both(this.sent, this.waiting)];
    if (error.stale) this.timer ??= setTimeout(() => this.send(), SEND_MS);
    else this.giveUp(error.text, error.help);
  }

  giveUp(text, help = '') {
    [this.sent, this.waiting, this.later] = [null, null, null];
    refuse(text ?? 'the change was refused', help);
    const now = this.view.state.doc.toString();
    this.view.dispatch({ changes: difference(now, plain(opened.value.text)), annotations: remote.of(true) });
    this.next();
  }

  next() {
    if (this.waiting) this.timer ??= setTimeout(() => this.send(), 0);
    else if (!this.sent) this.idle.splice(0).forEach((done) => done());
  }

  /** Resolves when the server has all that was typed before a hold. */
  settled() {
    if (!this.sent && !this.waiting) return Promise.resolve();
    return new Promise((resolve) => {
      this.idle.push(resolve);
      this.send();
    });
  }

  /** Resolves when the server has all that was typed. */
  async emptied() {
    await this.held;
    await this.settled();
  }
}
