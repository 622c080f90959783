// The docked panels.

import { createDockview } from '../vendor/dockview.js';
import { Fragment, effect, html, render, signal } from './dom.js';
import { PANELS } from './panels.js';
import { fitted, narrowed } from './places.js';
import { PRESETS } from './presets.js';
import { hello, notify, selected, session } from './store.js';
import { stored } from './stored.js';
import { theme } from './theme.js';
import { replace, watches } from './watches.js';

let api = null;
let lastNumber = 0;

/** Names of the panels that are open. */
export const opened = signal(new Set());
/** Name of the layout that was applied last. */
export const layoutName = signal('overview');

function content({ name }) {
  const element = document.createElement('div');
  element.className = 'panel';
  // A click on text of the panel focuses the panel, so that its keys work.
  element.tabIndex = -1;
  const visible = signal(true);
  return {
    element,
    init({ api: panel, params, title }) {
      const kind = PANELS[name];
      element.setAttribute('role', 'region');
      element.setAttribute('aria-label', title ?? kind?.title ?? name);
      visible.value = panel.isVisible;
      panel.onDidVisibilityChange((event) => { visible.value = event.isVisible; });
      const retitle = (text) => {
        panel.setTitle(text);
        element.setAttribute('aria-label', text);
      };
      const remember = (changed) => panel.updateParameters(changed);
      const view = kind ? html`<${kind.view} visible=${visible} params=${params ?? {}} retitle=${retitle} remember=${remember} />` : html`<p class="empty">This version has no panel “${name}”. Close the tab.</p>`;
      render(view, element);
    },
    dispose: () => render(html`<${Fragment} />`, element),
  };
}

/** Makes the dock in an element. */
export function start(element) {
  api = createDockview(element, {
    createComponent: content,
    theme: { name: 'jmanager', className: 'dockview-theme-jmanager', gap: 5, colorScheme: theme.peek() },
    disableFloatingGroups: false,
    noPanelsOverlay: 'watermark',
    createWatermarkComponent: () => {
      const note = document.createElement('p');
      note.className = 'empty';
      note.textContent = 'No panel is open. Choose a layout or a panel in the menu “View”.';
      return { element: note, init() {} };
    },
  });
  // The cross of a tab is for the mouse, beside the key that closes a panel: a tab contains no other control.
  api.onDidAddPanel(({ view }) => {
    const cross = view.tab.element.querySelector('.dv-default-tab-action');
    for (const name of ['role', 'tabindex']) cross?.removeAttribute(name);
  });
  api.onDidLayoutChange(() => {
    hideLoneTab();
    opened.value = new Set(api.panels.map((panel) => panel.id));
    saveSoon();
  });
  // The list of tabs without room takes some of the room itself, once the tab is there.
  api.onDidActivePanelChange(() => requestAnimationFrame(() => api.activePanel?.view.tab.element.scrollIntoView({ block: 'nearest', inline: 'nearest' })));
  effect(hideLoneTab);
  effect(() => {
    if (watches.value.length > 0 || memory.read()?.watches?.length > 0) saveSoon();
  });
  window.addEventListener('pagehide', save);
}

/** Which panels are in which group, with what they show. */
const arrangement = () => JSON.stringify([api.groups.map(({ panels }) => panels.map(({ id, params }) => [id, params ?? {}])), watches.peek()]);
let presetArrangement = null;

/** Whether the layout is for people who are not engineers: the page then leaves sessions, costs and worlds to its panel. */
export const isPlain = () => Boolean(PRESETS[layoutName.value]?.plain);

/** A plain layout shows no tab while it has one panel only. Other layouts show all tabs, also if they were saved from a plain one. */
function hideLoneTab() {
  const hidden = isPlain() && api.panels.length === 1;
  for (const { header } of api.groups) {
    if (header.hidden !== hidden) header.hidden = hidden;
  }
}

/** Whether the layout is the preset that was applied last, but for sizes. */
export const isPreset = () => Boolean(PRESETS[layoutName.peek()]) && arrangement() === presetArrangement;

/** Opens a panel, or shows it if it is open. */
export function open(name, params, title) {
  const kind = PANELS[name];
  let id = params?.component ? `component:${params.component}` : name;
  if (kind.many) {
    lastNumber += 1;
    while (api.getPanel(`${name}:${lastNumber}`)) lastNumber += 1;
    id = `${name}:${lastNumber}`;
  }
  const known = api.getPanel(id);
  if (known) return known.api.setActive();
  const neighbour = api.getPanel('component') ?? api.getPanel('camera') ?? api.activePanel;
  const beside = kind.many ? api.getPanel('timeline') ?? neighbour : neighbour;
  const position = beside ? { referencePanel: beside.id } : undefined;
  return api.addPanel({ id, component: name, title: title ?? kind.title, params, position });
}

/** Shows a component in the tab that follows the selection, or in a tab of its own. */
export function openComponent(name, own = false) {
  selected.value = name;
  if (own) open('component', { component: name }, name);
  else if (api.getPanel('component')) api.getPanel('component').api.setActive();
  else open('component', undefined, name);
}

/** Shows drawing and code, which need room: in their layout, if they are not shown yet. */
export function openSources() {
  if (opened.value.has('vicode')) open('vicode');
  else preset('designer');
}

export const closeActive = () => api.activePanel?.api.close();
export const maximize = () => {
  if (api.hasMaximizedGroup()) api.exitMaximizedGroup();
  else api.activePanel?.api.maximize();
};

/** The element and the title of the active panel; null if there is none. */
export const active = () => (api.activePanel ? { element: api.activePanel.view.content.element, title: api.activePanel.title } : null);

/** The same of all panels that are visible. */
export const visiblePanels = () => api.panels.filter((panel) => panel.api.isVisible).map((panel) => ({ element: panel.view.content.element, title: panel.title }));

/** Moves the focus to the next panel in order. */
export function focusNext(by) {
  const panels = api.panels.filter((panel) => panel.api.isVisible);
  if (panels.length === 0) return;
  const index = panels.indexOf(api.activePanel);
  const panel = panels[(index + by + panels.length) % panels.length];
  panel.api.setActive();
  const inside = panel.view.content.element;
  (inside.querySelector('button, input, select, [tabindex="0"]') ?? inside).focus?.();
}

/** Whether the shown session has something for a panel of a layout; all of them before its tree is known. */
function isOffered(id) {
  const [shown, [kind, component]] = [session.peek(), id.split(':')];
  if (!shown?.description.peek()) return true;
  return kind === 'component' && component ? shown.find(component) >= 0 : PANELS[kind].offered?.(shown) ?? true;
}

/** The panels of a preset: all, and those that are offered. */
function panelsOf(name) {
  const { clientWidth: width, clientHeight: height } = document.documentElement;
  const all = PRESETS[name].panels(width, height, { hasSource: hello.peek()?.source ?? true, shown: session.peek() });
  const offered = fitted(all, isOffered);
  return [all, width < 900 && offered.length > 0 ? narrowed(offered) : offered];
}

/** The presets of which the needed panel is offered: [name, preset, number of its key]. */
export const presets = () => Object.entries(PRESETS).map(([name, one], index) => [name, one, index + 1]).filter(([, { needs }]) => !needs || isOffered(needs));

/** Applies a preset again if the shown session lacks something for it. */
export function refit(name) {
  const [all, offered] = panelsOf(name);
  if (offered.length < all.length) preset(name);
}

/** Applies a preset by name. */
export function preset(name) {
  const [, offered] = panelsOf(name);
  const lacks = `this session has nothing for the layout “${PRESETS[name].title}”`;
  if (!presets().some(([known]) => known === name)) return notify('error', lacks, 'choose another one in the menu “View”');
  api.clear();
  for (const [id, where] of offered) {
    const [kind, argument] = id.split(':');
    const params = kind === 'component' && argument ? { component: argument } : where.params;
    const title = kind === 'component' && argument ? argument : where.title ?? PANELS[kind].title;
    const { beside, direction, size, inactive } = where;
    api.addPanel({
      id,
      component: kind,
      title,
      params,
      inactive,
      position: beside ? { referencePanel: beside, direction } : undefined,
      ...(direction === 'right' || direction === 'left' ? { initialWidth: size } : { initialHeight: size }),
    });
  }
  layoutName.value = name;
  presetArrangement = arrangement();
  return undefined;
}

/** An address of this page: of a session, others beside it, a moment, µs, and a layout, if they are given. */
export function address({ session, beside = [], time = null, layout: shown }) {
  const parts = new URLSearchParams();
  if (session) parts.set('session', session);
  for (const name of beside) parts.append('beside', name);
  if (time !== null) parts.set('t', (time / 1e6).toFixed(3));
  if (shown) parts.set('layout', shown);
  return `${location.pathname}${parts.size > 0 ? `#${parts}` : ''}`;
}

/** The layout with its watches as data, and back. */
export const layout = () => ({ ...api.toJSON(), watches: watches.peek() });

export function applyLayout(data, name) {
  const before = api.toJSON();
  try {
    api.fromJSON(data);
    replace(data.watches);
    layoutName.value = name;
    return true;
  } catch {
    api.fromJSON(before);
    return false;
  }
}

const memory = stored('localStorage', 'jmanager-layout');
let saving = null;

const saveSoon = () => { saving ??= setTimeout(save, 500); };

function save() {
  clearTimeout(saving);
  saving = null;
  const tree = session.peek()?.description.peek()?.name ?? memory.read()?.tree;
  memory.write({ ...layout(), name: layoutName.peek(), tree });
}

/** Restores the layout of the last visit, which stays plain; returns the name of the tree that it showed, null without one. */
export function restore() {
  const data = memory.read();
  return data !== null && applyLayout(data, PRESETS[data.name]?.plain ? data.name : 'last') ? data.tree ?? '' : null;
}

/** The preset of a first visit with a number of sessions of which the trees are known; undefined if no extension has one. */
export const firstPreset = (known) => presets().findLast(([, { first }]) => first <= known)?.[0];
