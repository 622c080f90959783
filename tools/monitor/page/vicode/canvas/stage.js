// What is drawn where: boxes of states and courses of arrows, and their elements while something is dragged.

import { signal } from '../../lib/dom.js';
import { WIDTH, boxOf, boxRect, bounds, overlap } from './boxes.js';
import { courseOf, lanes, placesOf } from './arrows.js';
import { labelWidth } from './labels.js';
import { Lifted } from './lifted.js';
import { apart, wanted } from './names.js';
import { laidOut } from './notes.js';
import { ALL, NAMES, arrange, isLaidOut, layoutOf } from './rows.js';
import { View } from './view.js';

/** Least width that is kept free for the live text below a name, and the height of both, points. */
const [LIVE, TALL] = [96, 30];

/** The area of a rectangle that others cover, at most about `most`. */
function covered(area, others, most) {
  let sum = 0;
  for (const one of others) {
    if (sum >= most) break;
    if (one.left < area.right && one.right > area.left && one.top < area.bottom && one.bottom > area.top) sum += overlap(area, one);
  }
  return sum;
}
/** Names with the fewest possible places are placed first. */
const rank = ({ any, from, to }) => (any ? 0 : from === to ? 1 : 2);

/** How much larger names are where a drawing is small. */
const SMALLER = 1.6;

/** Number of states above which an automatic drawing begins with names only. */
const FEW = 30;
/** Largest quotient of two shapes of the panel, width by height, for which a drawing stays as it is. */
const SIMILAR = 1.4;
/** Scales from which an automatic drawing shows more, and less. */
const [MORE, LESS] = [1.5, 0.62];

class Stage {
  constructor() {
    this.view = new View();
    this.view.onZoom = (x, y) => this.zoomed(x, y);
    this.view.listeners.add(() => this.placeNames());
    /** How much an automatic drawing shows, and width by height of its panel. */
    this.look = signal({ level: ALL, shape: 1.25 });
    /** The state that stays in its place when more or less is shown: {name, at}. */
    this.anchor = null;
    this.lifted = null;
    this.boxes = new Map();
    this.courses = new Map();
    /** Which names have places of their own, and these by key. */
    Object.assign(this, { named: null, names: new Map() });
    this.clear();
  }

  clear() {
    Object.assign(this, { machine: null, arrows: [], notes: [], lanes: new Map(), elements: new Map(), labels: new Map(), area: null });
    this.boxes.clear();
    this.courses.clear();
  }

  /** Takes a machine, the centres of its states, and its notes. */
  take(machine, positions, notes) {
    const places = new Map(positions.filter((one) => one.component === machine.name).map((one) => [one.state, one]));
    const { level, shape } = this.look.value;
    const isAutomatic = ![...places.values()].some(({ placed }) => placed);
    // Until it is laid out, all stays as it is.
    if (isAutomatic && !isLaidOut(machine, shape)) return;
    this.machine = machine;
    this.arrows = machine.arrows;
    this.lanes = lanes(machine.arrows);
    this.view.isAutomatic = isAutomatic;
    if (isAutomatic) {
      Object.assign(this, layoutOf(machine, level, shape));
      Object.assign(this, laidOut(notes, this.area, true));
      return;
    }
    this.area = null;
    this.boxes = new Map(machine.states.map((state, index) => {
      const { x, y } = places.get(state.name) ?? this.boxes.get(state.name) ?? { x: 110 + (index % 4) * 290, y: 110 + Math.floor(index / 4) * 160 };
      const box = boxOf(state);
      return [state.name, { name: state.name, x, y, width: box.width, height: box.height, box }];
    }));
    this.courses = new Map();
    const all = [...this.boxes.values()];
    for (const arrow of this.arrows) this.courses.set(arrow.key, this.course(arrow, all));
    this.placeLabels(all);
    this.notes = laidOut(notes, bounds(all), false).notes;
  }

  /** What the drawing covers, with a margin. */
  covered(margin) { return bounds([...this.all(), ...this.notes], margin); }

  course(arrow, all) { return courseOf(arrow, this.lanes.get(arrow.key), (name) => this.boxes.get(name), all); }

  /** Puts names where they cover neither boxes nor each other; those that would are left out. */
  placeLabels(all) {
    const taken = all.map(boxRect);
    const names = all.map(boxRect);
    for (const arrow of this.arrows.toSorted((a, b) => rank(a) - rank(b))) {
      const course = this.courses.get(arrow.key);
      const rect = ([x, y], width, height) => {
        const left = course.anchor === 'start' ? x - 4 : x - width / 2;
        return { left, right: left + width, top: y - 9, bottom: y - 9 + height };
      };
      const [name, withLive] = [labelWidth(arrow) * 1.06, Math.max(labelWidth(arrow), LIVE)];
      let least = Infinity;
      for (const [number, place] of placesOf(course).entries()) {
        const hidden = covered(rect(place, name, 18), names, 1);
        const cost = hidden > 0 ? 1e6 + hidden : covered(rect(place, withLive, TALL), taken, least);
        if (cost < least) [least, course.label, course.named, course.crowded] = [cost, place, number, hidden > 0];
        if (cost === 0) break;
      }
      if (course.crowded) continue;
      names.push(rect(course.label, name, 18));
      taken.push(rect(course.label, withLive, TALL));
    }
  }

  /** Finds the elements that a rendering made. */
  collect(layer) {
    const found = (selector) => new Map([...layer.querySelectorAll(selector)].map((element) => [element.dataset.key, element]));
    [this.elements, this.labels, this.named] = [found('[data-key]:not(.label)'), found('.label'), null];
  }

  /** Where only names of states are drawn, places those of arrows that are shown all the same. */
  placeNames() {
    const { view, labels, courses } = this;
    const isSparse = view.small || (view.isAutomatic && this.look.peek().level === NAMES);
    const shown = isSparse ? wanted(this.arrows, labels, courses) : [];
    const named = `${view.small} ${shown.map(({ key }) => key)}`;
    if (named === this.named) return;
    const before = this.names;
    const scale = view.small ? SMALLER : 1;
    [this.named, this.names] = [named, apart(shown, { courses, taken: [...this.all(), ...this.notes].map(boxRect), area: this.area }, scale)];
    for (const key of new Set([...before.keys(), ...this.names.keys()])) {
      const [x, y] = this.names.get(key) ?? courses.get(key)?.label ?? [0, 0];
      labels.get(key)?.classList.toggle('placed', this.names.has(key));
      labels.get(key)?.setAttribute('transform', `translate(${x.toFixed(1)} ${y.toFixed(1)})${this.names.has(key) ? ` scale(${scale})` : ''}`);
    }
  }

  /** What a machine that is opened is drawn with first, so that a large one is drawn once. */
  begin({ states }) {
    if (states.length > FEW) this.look.value = { ...this.look.peek(), level: NAMES };
  }

  /** Shows the whole machine; an automatic drawing shows as much as can be read. */
  fit() {
    const { view, machine } = this;
    if (view.isAutomatic && view.width > 0 && view.height > 0) {
      // A line below the drawing does not change all places.
      const [wanted, now] = [view.width / view.height, this.look.peek().shape];
      const isNear = Math.max(wanted / now, now / wanted) < SIMILAR;
      const shape = isNear ? now : Math.min(Math.max(Math.round(wanted * 10) / 10, 0.1), 50);
      if (!isLaidOut(machine, shape)) {
        arrange(machine, shape).then(() => this.fit(), () => {});
        return this.show();
      }
      const fits = (level) => level === NAMES || (machine.states.length <= FEW && view.scaleFor(laidOut(this.notes, layoutOf(machine, level, shape).area, true).area) >= 1);
      const level = [ALL, ALL + 1, NAMES].find(fits);
      if (level !== this.look.value.level || shape !== this.look.value.shape) {
        [this.anchor, view.whole] = [null, true];
        this.look.value = { level, shape };
        return undefined;
      }
    }
    return this.show();
  }

  /** Shows all; of an automatic drawing of few states as much as can be read. */
  show() { this.view.fit(this.area ?? this.covered(), this.view.isAutomatic && this.machine.states.length <= FEW ? 1 : 0); }

  /** Shows more of an automatic drawing that was enlarged around a point of the window, and less of one that was made smaller. */
  zoomed(x, y) {
    const { level, shape } = this.look.value;
    const next = this.view.k > MORE && level > ALL ? level - 1 : this.view.k < LESS && level < NAMES ? level + 1 : level;
    if (!this.view.isAutomatic || next === level || this.boxes.size === 0) return;
    const away = (box) => Math.hypot(...this.view.place([box.x, box.y]).map((value, axis) => value - [x, y][axis]));
    const box = this.all().reduce((best, one) => (away(one) < away(best) ? one : best));
    this.anchor = { name: box.name, at: this.view.place([box.x, box.y]) };
    this.look.value = { level: next, shape };
  }

  /** After a change of the look: the same state is in the same place, or all is in view. */
  settle() {
    const box = this.anchor && this.boxes.get(this.anchor.name);
    if (box) this.view.put([box.x, box.y], this.anchor.at);
    else if (this.view.whole) this.show();
    this.anchor = null;
  }

  /** The places of all states of an automatic drawing after some were moved, apart enough for whole boxes and the names between them; the view stays. */
  fixed(places) {
    const all = this.all();
    const height = new Map(this.machine.states.map((state) => [state.name, boxOf(state).height]));
    const needed = (a, b) => Math.min((WIDTH + LIVE) / Math.abs(a.x - b.x), ((height.get(a.name) + height.get(b.name)) / 2 + 1.6 * TALL) / Math.abs(a.y - b.y));
    // What was moved may lie on another one.
    const still = all.filter(({ name }) => !places[name]);
    const factor = still.reduce((most, a, at) => still.slice(at + 1).reduce((more, b) => Math.max(more, needed(a, b)), most), 1);
    this.view.k /= factor;
    this.view.apply();
    return Object.fromEntries(all.map(({ name, x, y }) => [name, { x: (places[name]?.x ?? x) * factor, y: (places[name]?.y ?? y) * factor }]));
  }

  /** Lifts states and the arrows that touch them, to drag them. */
  lift(names) {
    const touched = this.arrows.filter(({ from, to }) => names.includes(from) || names.includes(to)).map(({ key }) => key);
    const known = [...touched, ...names.map((name) => `s:${name}`)].filter((key) => this.elements.has(key));
    this.lifted = new Lifted(this.view, new Map(known.map((key) => [key, this.elements.get(key)])));
  }

  /** Ends the lifting. */
  drop() {
    this.lifted?.drop();
    this.lifted = null;
  }

  /** Moves boxes in the drawing only: {name: [x, y]}; back to where their arrows had known courses, if these are given. */
  drag(places, courses = null) {
    const all = [...this.boxes.values()];
    const shown = (key) => this.lifted?.copies.get(key) ?? this.elements.get(key);
    for (const [name, [x, y]] of Object.entries(places)) {
      const box = this.boxes.get(name);
      [box.x, box.y] = [x, y];
      shown(`s:${name}`)?.setAttribute('transform', `translate(${x - box.width / 2} ${y - box.height / 2})`);
    }
    for (const arrow of this.arrows) {
      if (!(arrow.from in places) && !(arrow.to in places)) continue;
      const { named = 0 } = this.courses.get(arrow.key);
      const course = courses?.get(arrow.key) ?? this.course(arrow, all);
      if (!courses) [course.label, course.named] = [placesOf(course)[named], named];
      this.courses.set(arrow.key, course);
      writeArrow(shown(arrow.key), this.labels.get(arrow.key), course);
    }
  }

  all() { return [...this.boxes.values()]; }

  /** The state under a point of the drawing. */
  at([x, y], margin = 0) {
    return this.all().findLast((box) => Math.abs(x - box.x) <= box.width / 2 + margin && Math.abs(y - box.y) <= box.height / 2 + margin) ?? null;
  }

  /** Names of the states within a rectangle of two points. */
  within([ax, ay], [bx, by]) {
    const area = { left: Math.min(ax, bx), right: Math.max(ax, bx), top: Math.min(ay, by), bottom: Math.max(ay, by) };
    return this.all().filter((box) => overlap(area, boxRect(box)) > 0).map(({ name }) => name);
  }

  /** The next state in a direction, 'ArrowLeft' and so on; null if there is none. */
  next(name, key) {
    const from = this.boxes.get(name);
    const [ux, uy] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[key];
    let best = null;
    for (const box of this.all()) {
      const [dx, dy] = [box.x - from.x, box.y - from.y];
      const ahead = dx * ux + dy * uy;
      const aside = Math.abs(dx * uy) + Math.abs(dy * ux);
      const cost = ahead + 2 * aside;
      if (box !== from && ahead > 10 && (!best || cost < best.cost)) best = { name: box.name, cost };
    }
    return best?.name ?? null;
  }
}

function writeArrow(element, name, { d, label, start }) {
  if (!element) return;
  const [hit, line, dot] = element.children;
  hit.setAttribute('d', d);
  line.setAttribute('d', d);
  dot.setAttribute('cx', start[0]);
  dot.setAttribute('cy', start[1]);
  name?.setAttribute('transform', `translate(${label[0].toFixed(1)} ${label[1].toFixed(1)})`);
}

/** The stage of the canvas; there is one canvas on a page. */
export const stage = new Stage();
