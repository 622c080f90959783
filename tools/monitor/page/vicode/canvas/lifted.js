// What is dragged, in a drawing of its own above the canvas: nothing else is painted while it moves.

const SVG = 'http://www.w3.org/2000/svg';

export class Lifted {
  /** Lifts elements {key: element} of a view. */
  constructor(view, originals) {
    this.view = view;
    this.originals = originals;
    this.svg = document.createElementNS(SVG, 'svg');
    this.svg.setAttribute('class', `${view.svg.getAttribute('class')} lifted`);
    this.svg.setAttribute('aria-hidden', 'true');
    this.svg.setAttribute('width', view.width);
    this.svg.setAttribute('height', view.height);
    const layer = this.svg.appendChild(document.createElementNS(SVG, 'g'));
    this.copies = new Map();
    for (const [key, element] of originals) {
      const copy = element.cloneNode(true);
      copy.removeAttribute('tabindex');
      copy.removeAttribute('role');
      this.copies.set(key, layer.appendChild(copy));
      element.classList.add('away');
    }
    this.follow = () => layer.setAttribute('transform', view.layer.getAttribute('transform'));
    this.follow();
    view.listeners.add(this.follow);
    view.svg.after(this.svg);
  }

  drop() {
    this.view.listeners.delete(this.follow);
    this.svg.remove();
    for (const element of this.originals.values()) element.classList.remove('away');
  }
}
