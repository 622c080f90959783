// The drawing as a file: SVG with its colours in it, and PNG; the machine in the languages of Mermaid and Graphviz.

import { notify } from '../lib/store.js';
import { css } from '../lib/theme.js';
import { download } from '../lib/ui.js';
import { stage } from './canvas/stage.js';
import { ask, component, openedFile } from './sources.js';

const WRITTEN = ['fill', 'fill-opacity', 'stroke', 'stroke-width', 'stroke-dasharray', 'stroke-opacity', 'font-size', 'font-weight', 'font-family', 'opacity', 'text-anchor', 'text-decoration', 'paint-order'];
const HIDDEN = '.hit, .handle, .stop, .live, title';

/** The drawing as text: without what only serves the mouse. */
function drawing() {
  const area = stage.covered(90);
  const original = stage.view.svg;
  const clone = original.cloneNode(true);
  const sources = [...original.querySelectorAll('*')];
  [...clone.querySelectorAll('*')].forEach((element, index) => {
    const style = getComputedStyle(sources[index]);
    for (const name of WRITTEN) {
      const value = style.getPropertyValue(name);
      if (value) element.setAttribute(name, value);
    }
  });
  clone.querySelectorAll(`${HIDDEN}, .grid, .band, .sketch`).forEach((element) => element.remove());
  clone.querySelectorAll('[class]').forEach((element) => element.removeAttribute('class'));
  clone.querySelector('[data-layer]').removeAttribute('transform');
  const set = { xmlns: 'http://www.w3.org/2000/svg', viewBox: `${area.x} ${area.y} ${area.width} ${area.height}`, width: area.width, height: area.height };
  for (const [name, value] of Object.entries(set)) clone.setAttribute(name, value);
  const ground = document.createElementNS('http://www.w3.org/2000/svg', 'rect');
  for (const [name, value] of Object.entries({ x: area.x, y: area.y, width: area.width, height: area.height, fill: css('--panel') })) ground.setAttribute(name, value);
  clone.prepend(ground);
  return { text: new XMLSerializer().serializeToString(clone), ...area };
}

export function saveSvg() {
  download(`${component.value}.svg`, new Blob([drawing().text], { type: 'image/svg+xml' }));
}

/** Saves the machine as text: 'mermaid' or 'dot'. */
export async function saveText(format, ending) {
  const answer = await ask('draw_file', { file: openedFile.value, component: component.value, format });
  if (answer) download(`${component.value}.${ending}`, new Blob([answer.text], { type: 'text/plain' }));
}

/** Opens the browser's print dialogue with the drawing alone on a page of its size; “Save as PDF” there writes a file of vectors. */
export async function savePdf() {
  const { text, width, height } = drawing();
  const sheet = Object.assign(new Image(), { className: 'print', src: URL.createObjectURL(new Blob([text], { type: 'image/svg+xml' })) });
  await sheet.decode();
  const size = new CSSStyleSheet();
  size.replaceSync(`@page { size: ${Math.ceil(width)}px ${Math.ceil(height)}px; margin: 0; }`);
  document.adoptedStyleSheets.push(size);
  document.body.append(sheet);
  window.addEventListener('afterprint', () => {
    sheet.remove();
    URL.revokeObjectURL(sheet.src);
    document.adoptedStyleSheets = document.adoptedStyleSheets.filter((one) => one !== size);
  }, { once: true });
  window.print();
}

export async function savePng() {
  const { text, width, height } = drawing();
  const scale = Math.min(2, 8000 / Math.max(width, height));
  const image = new Image();
  const url = URL.createObjectURL(new Blob([text], { type: 'image/svg+xml' }));
  try {
    await new Promise((resolve, reject) => {
      image.onload = resolve;
      image.onerror = () => reject(new Error('the drawing cannot be read as a picture'));
      image.src = url;
    });
    const canvas = new OffscreenCanvas(Math.ceil(width * scale), Math.ceil(height * scale));
    canvas.getContext('2d').drawImage(image, 0, 0, canvas.width, canvas.height);
    download(`${component.value}.png`, await canvas.convertToBlob({ type: 'image/png' }));
  } catch (error) {
    notify('error', String(error.message ?? error), 'save it as SVG');
  } finally {
    URL.revokeObjectURL(url);
  }
}
