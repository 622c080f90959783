// What is known of one session: a robot, a world or a recording.

import { signal } from './dom.js';

/** Samples that are kept of an output. */
const MAX_SAMPLES = 6000;
const MAX_LINES = 4000;
const MAX_IMAGES = 8;
/** Longest time for which an image waits for its findings, µs. */
const LATE = 250e3;

/** Values of an output over time, and the newest one for the cursor. */
export class Output {
  /** `activity` has the times at which its component became latent, and active, in order. */
  constructor(activity = new Activity()) {
    this.activity = activity;
    this.times = [];
    this.values = [];
    this.now = signal(null);
    this.version = signal(0);
  }

  /** Adds a sample if it is newer. */
  store(time, value) {
    if (this.times.length > 0 && time <= this.times.at(-1)) return;
    this.times.push(time);
    this.values.push(value);
  }

  /** The same; the oldest ones are dropped. */
  add(time, value) {
    this.store(time, value);
    if (this.times.length > MAX_SAMPLES) {
      this.times.splice(0, MAX_SAMPLES / 6);
      this.values.splice(0, MAX_SAMPLES / 6);
    }
  }

  showNewest() {
    this.now.value = this.times.length > 0 ? { time: this.times.at(-1), value: this.values.at(-1) } : null;
  }

  /** Puts older samples in front of those that are known. */
  prepend(samples) {
    const first = this.times[0] ?? Infinity;
    const older = samples.filter(([time]) => time < first);
    if (older.length === 0) return;
    this.times = older.map(([time]) => time).concat(this.times);
    this.values = older.map(([, value]) => value).concat(this.values);
    this.version.value += 1;
  }

  /** Number of the samples that are not later. */
  count(time) {
    return countOf(this.times, time);
  }

  /** The last value that is not later. */
  at(time) {
    return this.values[this.count(time) - 1];
  }

  /** The same; undefined while its component is latent. */
  held(time) {
    return this.activity.isLatent(time) ? undefined : this.at(time);
  }
}

/** When a component became latent, and active, as far as it is known. */
class Activity {
  constructor() {
    [this.ends, this.begins] = [[], []];
  }

  isLatent(time) {
    const last = (times) => times[countOf(times, time) - 1] ?? -1;
    return last(this.ends) > last(this.begins);
  }

  add(ends, begins) {
    const merged = (all, more) => (more.length === 0 ? all : [...new Set([...all, ...more])].sort((a, b) => a - b).slice(-MAX_SAMPLES));
    [this.ends, this.begins] = [merged(this.ends, ends), merged(this.begins, begins)];
  }
}

/** Number of the times that are not later; `times` are in order. */
function countOf(times, time) {
  let [low, high] = [0, times.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) low = middle + 1;
    else high = middle;
  }
  return low;
}

let lastLine = 0;
/** A line with a unique number, by which its element on the page is found again. */
const numbered = (line) => ({ ...line, key: (lastLine += 1) });

export class Session {
  constructor(info) {
    this.id = info.id;
    this.info = signal(info);
    /** What its outputs name it (lib/names.js); empty before they are known. */
    this.label = signal('');
    this.description = signal(null);
    /** Kind of each component, by which it is coloured; none of a tree that is too large to draw. */
    this.kinds = signal([]);
    /** What does not move in the world. */
    this.scenery = signal([]);
    /** Names of the cameras of which images have come. */
    this.cameras = signal([]);
    /** State at the cursor, or the newest: {time_us, cycle, components}. */
    this.moment = signal(null);
    /** The newest state, whatever the cursor shows. */
    this.live = signal(null);
    /** Costs at the cursor, or the newest ones; as truth and image below. */
    this.costs = signal(null);
    this.worst = signal([]);
    this.truth = signal(null);
    this.image = signal(null);
    /** The newest {costs, truth, image}, and conditions by component, whatever the cursor shows. */
    this.newest = { costs: null, truth: null, image: null, conditions: new Map() };
    /** The last images: the newest one waits for what was found in it. */
    this.images = [];
    /** Whether a recording was shown from its beginning. */
    this.begun = false;
    /** Time of the cursor when another session was chosen. */
    this.left = null;
    /** Time of the state that was last asked for; not a number before that. */
    this.sought = NaN;
    /** The interval of a recording that is still being read, until somebody changes it. */
    this.untouched = null;
    this.params = signal([]);
    this.lines = [];
    this.linesVersion = signal(0);
    this.conditions = new Map();
    this.outputs = new Map();
    /** Activity of each component, by its index. */
    this.activities = new Map();
    this.incoming = [];
  }

  /** What the page calls it. A link has the name in `info`. */
  get title() {
    return this.label.value || this.info.value.name;
  }

  describe(description, kinds) {
    this.label.value = '';
    [this.scenery.value, this.cameras.value] = [[], []];
    const components = description.components;
    this.incoming = components.map(() => []);
    components.forEach((component, from) => {
      for (const one of component.links) this.incoming[one.to]?.push({ from, ...one });
    });
    this.lines = [];
    this.linesVersion.value += 1;
    this.worst.value = [];
    this.outputs.clear();
    this.activities.clear();
    this.conditions.clear();
    this.live.value = null;
    this.newest = { costs: null, truth: null, image: null, conditions: new Map() };
    this.showNewest();
    this.params.value = components.map((component) => component.params.map((param) => param.value ?? param.default));
    this.kinds.value = kinds;
    this.description.value = description;
  }

  output(component, index) {
    const key = component * 65536 + index;
    let known = this.outputs.get(key);
    if (!known) this.outputs.set(key, (known = new Output(this.activityOf(component))));
    return known;
  }

  activityOf(component) {
    if (!this.activities.has(component)) this.activities.set(component, new Activity());
    return this.activities.get(component);
  }

  showImage(image, live) {
    if (image.camera && !this.cameras.value.includes(image.camera)) this.cameras.value = [...this.cameras.value, image.camera].sort();
    this.images = live ? [...this.images.slice(1 - MAX_IMAGES), image] : [image];
    this.image.value = image;
  }

  /** Shows the newest of everything. */
  showNewest() {
    const { costs, truth, image, conditions } = this.newest;
    [this.moment.value, this.costs.value, this.truth.value, this.image.value] = [this.live.value, costs, truth, image];
    this.images = image ? [image] : [];
    for (const [component, shown] of this.conditions) shown.value = conditions.get(component) ?? null;
    for (const output of this.outputs.values()) output.showNewest();
  }

  /** Shows a moment of the past: the answer to `at`, with the requested outputs and image. What is not known is empty. */
  showMoment(moment, info, image) {
    const { time_us, truth, costs } = moment;
    this.moment.value = moment;
    this.truth.value = truth && { time_us, truth };
    this.costs.value = costs;
    for (const shown of this.conditions.values()) shown.value = null;
    for (const one of moment.conditions) this.conditions_of(one.component).value = one;
    for (const [component, index] of info) this.output(component, index).now.value = { time: null, value: null };
    for (const [component, index, time, value] of moment.info) this.output(component, index).now.value = { time, value };
    if (image && moment.image === null) [this.images, this.image.value] = [[], null];
  }

  /**
   * The newest image of which all findings, [component, output], are known: components run at their own rates, so those of an
   * image are known when the next one was taken in. `findings_us` of the image is the time of their last values.
   */
  matchedImage(findings) {
    const newest = this.images.at(-1) ?? null;
    const known = Math.min(...findings.map(([component, info]) => this.output(component, info).times.at(-1) ?? 0));
    for (let at = this.images.length - 2; at >= 0; at -= 1) {
      const [image, next] = [this.images[at], this.images[at + 1]];
      // Findings that do not come at all, as of a paused world, are not waited for.
      if (image.time_us < newest.time_us - LATE) break;
      if (next.time_us <= known) {
        image.findings_us = next.time_us - 1;
        return image;
      }
    }
    return newest;
  }

  conditions_of(component) {
    let known = this.conditions.get(component);
    if (!known) this.conditions.set(component, (known = signal(null)));
    return known;
  }

  /** Adds the lines that the server knows to those that came since it was asked; a line that is in both is there once. */
  setLines(lines) {
    const key = ({ time_us, source, component, text }) => JSON.stringify([time_us, source, component, text]);
    const known = new Set(lines.map(key));
    this.lines = [...lines.map(numbered), ...this.lines.filter((line) => !known.has(key(line)))].sort((a, b) => a.time_us - b.time_us);
    this.linesVersion.value += 1;
  }

  addLines(lines) {
    this.lines.push(...lines.map(numbered));
    if (this.lines.length > MAX_LINES) this.lines.splice(0, this.lines.length - MAX_LINES);
    this.linesVersion.value += 1;
  }

  /** Index of a component by its name; -1 if there is none. */
  find(name) {
    return this.description.value?.components.findIndex((component) => component.name === name) ?? -1;
  }

  /** Component and index of an output by names; null if there is none. */
  findInfo(component, name) {
    const index = this.find(component);
    const info = this.description.value?.components[index]?.info.findIndex((one) => one.name === name) ?? -1;
    return info < 0 ? null : [index, info];
  }
}
