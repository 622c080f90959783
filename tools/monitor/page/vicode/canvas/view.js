// Pan and zoom of the canvas: a transformation that is written to the drawing directly, without a new rendering.

const [SMALLEST, LARGEST] = [0.08, 3];
/** Scale below which only names are drawn, larger. */
const SMALL = 0.42;

export class View {
  constructor() {
    /** Points of the window = points of the drawing × k + (x, y). */
    Object.assign(this, { x: 0, y: 0, k: 1, svg: null, layer: null, width: 0, height: 0, listeners: new Set() });
    /** Whether the whole machine is kept in view. */
    this.whole = true;
    /** Whether nobody has placed a state. */
    this.isAutomatic = false;
    /** Called after a zoom around a point of the window. */
    this.onZoom = () => {};
  }

  attach(svg, layer) {
    this.svg = svg;
    this.layer = layer;
    [this.width, this.height] = [0, 0];
    // Measured without the drawing, which would be laid out at another scale for that.
    svg.style.display = 'none';
    this.resize();
    svg.style.display = '';
    this.apply();
  }

  /**
   * Takes the size of what holds the drawing; returns whether it is another one. The drawing gets it in points: one with a size in per
   * cent is laid out anew, with all its texts, whenever something beside it changes.
   */
  resize() {
    const { clientWidth, clientHeight } = this.svg.parentElement;
    if (clientWidth === this.width && clientHeight === this.height) return false;
    [this.width, this.height] = [clientWidth, clientHeight];
    this.svg.setAttribute('width', clientWidth);
    this.svg.setAttribute('height', clientHeight);
    return true;
  }

  apply() {
    this.layer?.setAttribute('transform', `translate(${this.x.toFixed(2)} ${this.y.toFixed(2)}) scale(${this.k.toFixed(4)})`);
    this.svg?.classList.toggle('small', this.small);
    for (const listener of this.listeners) listener();
  }

  get small() {
    return this.k < SMALL && !this.isAutomatic;
  }

  /** The point of the drawing under the pointer. */
  point({ clientX, clientY }) {
    const { left, top } = this.svg.getBoundingClientRect();
    return [(clientX - left - this.x) / this.k, (clientY - top - this.y) / this.k];
  }

  /** The point of the window, relative to the canvas, of a point of the drawing. */
  place([x, y]) { return [x * this.k + this.x, y * this.k + this.y]; }

  pan(dx, dy) {
    this.whole = false;
    this.x += dx;
    this.y += dy;
    this.apply();
  }

  /** Zooms around a point of the window, relative to the canvas; else around its middle. */
  zoom(factor, x = this.width / 2, y = this.height / 2) {
    this.whole = false;
    // A machine that was fitted may be drawn smaller.
    const k = Math.min(Math.max(this.k * factor, Math.min(SMALLEST, this.k)), LARGEST);
    this.x = x - (x - this.x) * (k / this.k);
    this.y = y - (y - this.y) * (k / this.k);
    this.k = k;
    this.apply();
    this.onZoom(x, y);
  }

  /** The scale at which an area fits, not larger than it is drawn. */
  scaleFor({ width, height }, largest = 1.15) { return Math.min(this.width / width, this.height / height, largest); }

  /** Shows a point of the drawing at a point of the window, at its own size. */
  put([x, y], [atX, atY]) {
    [this.k, this.x, this.y] = [1, atX - x, atY - y];
    this.apply();
  }

  /** Shows an area, at least at a scale: then its upper left part. */
  fit(all, least = 0) {
    const { width, height } = this;
    if (!width || !height) return;
    this.k = Math.max(this.scaleFor(all), least);
    this.x = Math.max(0, (width - all.width * this.k) / 2) - all.x * this.k;
    this.y = Math.max(0, (height - all.height * this.k) / 2) - all.y * this.k;
    this.whole = true;
    this.apply();
  }

  /** Moves a box into view if it is not. */
  reveal({ x, y, height }) {
    const [px, py] = this.place([x, y]);
    const margin = 70;
    const { width, height: tall } = this;
    const dx = px < margin * 1.6 ? margin * 1.6 - px : px > width - margin * 1.6 ? width - margin * 1.6 - px : 0;
    const half = (height / 2) * this.k + 20;
    const dy = py < half ? half - py : py > tall - half ? tall - half - py : 0;
    if (dx || dy) this.pan(dx, dy);
  }

  /** Centres a point of the drawing. */
  centre(x, y) {
    this.whole = false;
    this.x = this.width / 2 - x * this.k;
    this.y = this.height / 2 - y * this.k;
    this.apply();
  }
}
