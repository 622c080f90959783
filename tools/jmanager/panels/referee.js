// A match as its referee needs it: state, clock, score and penalties, the orders, and the players that answer.

import { html, useEffect, useSignal } from '../lib/dom.js';
import { time, words } from '../lib/format.js';
import { right } from '../lib/places.js';
import { command, session, watch } from '../lib/store.js';
import { Empty } from '../lib/ui.js';
import { initial } from '../panels/component/modulations.js';

/** `MotionInSet` becomes `motion in set`. */
const inWords = (name) => name.replaceAll(/(?<=.)[A-Z]/g, ' $&').toLowerCase();

/** An argument; the page shows the number of a team in place of its side. */
const Field = ({ argument: { name, doc, variants, min, max, unit }, value, set, sides }) => (variants
  ? html`<select aria-label=${words(name)} title=${doc} onChange=${(event) => set(event.target.value)}>${variants.map((one) => html`<option value=${one.name} selected=${one.name === value}>${sides[one.name] ?? inWords(one.name)}</option>`)}</select>`
  : html`<span class="dim">${words(name)}</span><input inputmode="numeric" aria-label=${words(name)} title=${`${doc} ${min} to ${max}`} value=${value} onInput=${(event) => set(Number(event.target.value))} />${unit}`);

function Order({ order, component, number, sides }) {
  const values = useSignal(order.arguments.map(initial));
  const give = (event) => {
    event.preventDefault();
    command('modulate', { component, modulation: number, arguments: values.value });
  };
  return html`<form class="join" onSubmit=${give}><button title=${order.doc} disabled=${!session.value.info.value.can.operate}>${words(order.name)}</button>
    ${order.arguments.map((argument, at) => html`<${Field} ...${{ argument, sides, value: values.value[at], set: (value) => { values.value = values.value.with(at, value); } }} />`)}</form>`;
}

const List = ({ title, lines }) => html`<h3>${title}</h3><ul aria-label=${title}>${lines?.map((line) => html`<li>${line}</li>`)}</ul>${!lines?.length && html`<p class="dim">none</p>`}`;

function Referee({ visible }) {
  const shown = session.value;
  const component = shown?.find('Referee') ?? -1;
  const { info = [], modulations = [] } = shown?.description.value?.components[component] ?? {};
  useEffect(() => (visible.value && component >= 0 ? watch({ info: info.map((_, index) => [component, index, 3]) }) : undefined), [visible.value, component, info]);
  if (component < 0) return html`<${Empty} what="No referee" help="Open the link of a program “player referee --serve”." />`;
  const read = (name) => shown.output(component, info.findIndex((one) => one.name === name)).now.value?.value;
  const [[first, second], score, messages] = ['teams', 'score', 'messages'].map((name) => read(name) ?? ['–', '–']);
  const orders = modulations.flatMap((order, number) => (order.stops ? [] : [[order.arguments.length > 0, html`<${Order} key=${order.name} ...${{ order, component, number, sides: { First: `team ${first}`, Second: `team ${second}` } }} />`]]));
  return html`<article class="tab referee">
    <h2 role="status"><b class=${read('stopped') ? 'warn' : ''}>${read('state') ?? '–'}${read('stopped') && ', stopped'}</b> ${time((read('clock') ?? 0) * 1e6, 0)} · team ${first} <b>${score.join(' : ')}</b> team ${second}</h2>
    <p class="facts">${inWords(read('restart') ?? 'None').replace('none', 'kick-off')} of team ${read('kicking_team') ?? '–'} · messages left ${messages.join(' and ')} · ${read('answering') ?? 0} players answer</p>
    <h3>Orders</h3><div class="join">${orders.map(([takes, order]) => !takes && order)}</div>${orders.map(([takes, order]) => takes && html`<div>${order}</div>`)}
    <p class="dim" role="status">${read('answer') ? `last order: ${read('answer')}` : 'no order yet'}</p>
    <${List} title="Penalties" lines=${read('penalties')} /><${List} title="Players that have answered" lines=${read('players')} /></article>`;
}

export default {
  label: 'referee {Referee.teams[0]}:{Referee.teams[1]}',
  panels: { referee: { title: 'Referee', view: Referee, offered: (shown) => shown.find('Referee') >= 0 } },
  lastPresets: { referee: { title: 'Referee', needs: 'referee', first: 1, panels: (width) => [['referee', {}], ['log', right('referee', width * 0.4)]].slice(0, width < 900 ? 1 : 2) } },
};
