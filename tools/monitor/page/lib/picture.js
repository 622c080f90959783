// A picture of a panel: a copy of its elements with their styles, drawn by the browser on a canvas.

import { notify } from './store.js';
import { css } from './theme.js';
import { download } from './ui.js';

/** Writes a panel, {element, title}, as PNG. */
export async function savePicture(panel) {
  if (!panel) return;
  try {
    download(`${panel.title.toLowerCase().replaceAll(/[^\p{L}\p{N}_]+/gu, '-')}.png`, await picture(panel.element));
  } catch (error) {
    notify('error', 'this browser makes no picture of the panel', error?.message ?? 'use a screenshot of the window');
  }
}

async function picture(element) {
  const { clientWidth: width, clientHeight: height } = element;
  const scale = window.devicePixelRatio || 1;
  const image = new Image();
  const markup = new XMLSerializer().serializeToString(copy(element));
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(`<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}"><foreignObject width="100%" height="100%">${markup}</foreignObject></svg>`)}`;
  await image.decode();
  const canvas = Object.assign(document.createElement('canvas'), { width: width * scale, height: height * scale });
  const context = canvas.getContext('2d');
  context.fillStyle = css('--panel');
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.drawImage(image, 0, 0, canvas.width, canvas.height);
  return new Promise((resolve, reject) => { canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('the panel is too large'))), 'image/png'); });
}

/** A copy with the styles as they are computed; canvases are images, and fields have their present values. */
function copy(element) {
  const own = element.localName === 'canvas' ? document.createElement('img') : element.cloneNode(false);
  const style = getComputedStyle(element);
  own.style.cssText = [...style].map((name) => `${name}:${style.getPropertyValue(name)}`).join(';');
  if (element.localName === 'canvas') own.src = element.toDataURL();
  if (element.localName === 'input') own.setAttribute('value', element.value);
  if (element.localName === 'option' && element.selected) own.setAttribute('selected', '');
  // Nothing is scrolled in a picture.
  if (style.overflowY === 'auto' || style.overflowY === 'scroll') own.style.overflow = 'hidden';
  // What lies outside, as a menu that is closed, is not drawn.
  for (const child of element.childNodes) {
    if (child.nodeType === Node.TEXT_NODE) own.append(child.cloneNode());
    else if (child.nodeType === Node.ELEMENT_NODE && getComputedStyle(child).display !== 'none' && child.localName !== 'datalist') own.append(copy(child));
  }
  if (element.scrollTop > 0 && own.firstElementChild) own.firstElementChild.style.marginTop = `${-element.scrollTop}px`;
  return own;
}
