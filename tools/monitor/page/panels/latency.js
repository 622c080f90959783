// The chain from sensor values to command against the tree's budget, its shares, and the worst cycles.

import { html, useEffect } from '../lib/dom.js';
import { openComponent } from '../lib/dock.js';
import { duration, number, time } from '../lib/format.js';
import { cursor, seek, session, watch } from '../lib/store.js';
import { Empty } from '../lib/ui.js';

const setWidth = (part) => (element) => {
  if (element) element.style.width = `${Math.min(100, part * 100)}%`;
};

export function Latency({ visible }) {
  const shown = session.value;
  useEffect(() => (visible.value ? watch({ costs: true }) : undefined), [visible.value]);
  const description = shown?.description.value;
  const costs = visible.value ? shown?.costs.value : null;
  if (!shown || !description || !shown.info.value.can.costs) return html`<${Empty} what="No costs" help=${shown ? 'This session does not send the time of its components. A running world or robot does.' : 'Open a world or a robot first.'} />`;
  if (!costs) return html`<${Empty} ...${cursor.value === null ? { what: 'Waiting for the first costs', help: 'They come about twice a second while the robot runs.' } : { what: 'The costs of this moment are not known', help: 'Choose a later one, or press “l” for the newest.' }} />`;
  const budget = (description.budget_ms ?? 200) * 1000;
  const [mean, longest] = costs.chain_us;
  const seconds = costs.window_us / 1e6;
  const shares = costs.components
    .map(([runs, each, worst], index) => ({ index, runs, each, worst, total: runs * each }))
    .filter(({ runs }) => runs > 0)
    .sort((a, b) => b.total - a.total);
  const sum = shares.reduce((total, one) => total + one.total, 0);
  const kinds = shown.kinds.value;
  return html`<div class="latency">
    <section aria-label="Chain"><h3>From sensor values to command</h3>
      <div class="gauge" role="img" aria-label=${`mean ${duration(mean)}, longest ${duration(longest)} of ${number(budget / 1000)} ms`}><i class="longest" ref=${setWidth(longest / budget)}></i><i class="mean" ref=${setWidth(mean / budget)}></i></div>
      <p><b>${duration(mean)}</b> mean · <b class=${longest > budget ? 'warn' : ''}>${duration(longest)}</b> longest · <span class="dim">budget ${number(budget / 1000)} ms</span> · ${((mean * description.cycle_hz) / 1e4).toFixed(1)} % of a core at ${number(description.cycle_hz)} Hz</p>
      <h3>Worst cycles</h3>
      <ol class="worst">${shown.worst.value.slice(0, 10).map(({ time: at, us }) => html`<li key=${at}><button onClick=${() => seek(at)} title="Show this cycle">${time(at, 3)}</button> <b>${duration(us)}</b></li>`)}</ol>
    </section>
    <section aria-label="Shares" class="shares"><h3>Shares of the components</h3>
      <table><thead><tr><th>component</th><th>share</th><th class="n">mean</th><th class="n">longest</th><th class="n">budget</th><th class="n">runs/s</th></tr></thead>
      <tbody>${shares.map(({ index, runs, each, worst, total }) => {
        const component = description.components[index];
        const over = component.budget_us && each > component.budget_us;
        return html`<tr key=${index}><td><button class="name" onClick=${() => openComponent(component.name)}>${component.name}</button></td>
          <td class="bar-cell"><i class=${kinds[index] ?? ''} ref=${setWidth(total / (shares[0].total || 1))}></i><span>${((total / sum) * 100).toFixed(1)} %</span></td>
          <td class=${`n ${over ? 'warn' : ''}`}>${number(each)} µs</td><td class="n">${number(worst)} µs</td><td class="n dim">${component.budget_us ? `${number(component.budget_us)} µs` : ''}</td><td class="n dim">${(runs / seconds).toFixed(0)}</td></tr>`;
      })}</tbody></table></section>
  </div>`;
}
