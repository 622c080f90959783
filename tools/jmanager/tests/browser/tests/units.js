// Values that functions of the page must have. Returns those that they do not have, as texts.

const at = (name) => import(`${typeof base === 'undefined' ? '' : base}/lib/${name}.js`);
const wrong = [];
const same = (found, wanted) => {
  const text = (value) => JSON.stringify(value, (_, one) => (typeof one === 'bigint' ? `${one}n` : one === undefined ? 'undefined' : one));
  if (text(found) !== text(wanted)) wrong.push(`${text(found)} is not ${text(wanted)}`);
};

async function texts() {
  const { exact, number, ticks, time, typedNumber, duration } = await at('format');
  same([0.0004, 0.00043219, 12.3456, 1234.5, 1e-9, -0.1, 1764250000123456789n].map(number), ['0.0004', '0.0004322', '12.35', '1235', '1e-9', '-0.1', '1764250000123456789']);
  same([0.0004, 0.12345679, 1e-9, 1e21].map(exact).map(typedNumber), [0.0004, 0.12345679, 1e-9, 1e21]);
  same(['0,5', '−3', ' 7 ', '9007199254740993', '', '0x10', '1 000'].map(typedNumber), [0.5, -3, 7, 9007199254740993n, null, null, null]);
  same([[1000.0001, 1000.0002], [0, 0.25], [-5e-10, 0], [1.5e18, 2e18], [-20, 400]].map(ticks), [['1000.0001', '1000.0002'], ['0', '0.25'], ['-5e-10', '0'], ['1.5e18', '2e18'], ['-20', '400']]);
  const { written } = await at('../panels/map/labels');
  same([[6, 820 * 600], [6, 458 * 334], [4, 380 * 277]].map(([count, area]) => written(Array(count).fill({ full: '5-1', short: '1' }), area)[0].text), ['5-1', '1', '1']);
  same([duration(0), time(62.5e6), time(1764250005.25e6, 1).replace(/^\d\d:\d\d/, '')], ['0 s', '1:02.50', ':45.3']);
}

async function expressions() {
  const { expression } = await at('expression');
  const value = (text, ...values) => expression(text, ['Filter<3>', 'Größe']).begin()(0, values);
  same([value('1 + 2 * 3 ^ 2 > 18'), value('Filter<3>.value<3', 2), value('Größe.höhe[1].änderung / 2', 3), value('hypot(a.x, a.y)', 3, 4)], [1, 1, 1.5, 5]);
  same(expression('Filter<3>.value - höhe.x', ['Filter<3>']).names, ['Filter<3>.value', 'höhe.x']);
  same([value('a.t - b.t', 1764250000123456789n, 1764250000123456788n), value('a.t > 5', 9007199254740993n), value('a.t == 9007199254740993', 9007199254740993n), value('a.t * 0.5', 2n ** 60n)], [1n, 1, 1, 2 ** 59]);
  for (const text of ['1 §', 'f(1', 'a.x b.x', '']) {
    try {
      expression(text);
      wrong.push(`“${text}” is an expression`);
    } catch { /* as it should be */ }
  }
}

/** Of a component that was latent from 5.5 s to 8 s. */
async function curves() {
  const { Session } = await at('session');
  const { resolve, samples, valueNow } = await at('curves');
  const of = new Session({ id: 1 });
  of.describe({ components: [{ name: 'Filter<3>', links: [], params: [{ name: 'verstärkung', default: 0.5 }], info: [{ name: 'höhe', unit: 'm' }, { name: 'stamp', unit: 'ns' }] }] }, []);
  for (let second = 0; second < 10; second += 1) {
    if (second > 5 && second < 8) continue;
    of.output(0, 0).add(second * 1e6, second * 2);
    of.output(0, 1).add(second * 1e6, 1764250000123456789n + BigInt(second));
  }
  of.activityOf(0).add([5.5e6], [8e6]);
  of.showNewest();
  const column = (name) => [...samples(of, resolve(of, name), [4e6, 8e6])];
  same(column('Filter<3>.höhe'), [[4e6, 8], [5e6, 10], [5.5e6, null], [8e6, 16]]);
  same(column('Filter<3>.höhe * Filter<3>.verstärkung')[0], [4e6, 4]);
  same(column('Filter<3>.stamp')[0][1], 1764250000123456793n);
  same(valueNow(of, resolve(of, 'rate(Filter<3>.höhe)')), 2);
  same(resolve(of, 'Filter<3>.ho\u0308he').name, 'Filter<3>.höhe');
  const { statistics } = await at('span');
  same(statistics(new Map(column('Filter<3>.höhe')), [4e6, 9e6]), { min: 8, max: 16, mean: 11.6, deviation: 3.666060555964672, change: 8 });
  same(statistics(new Map(column('Filter<3>.stamp')), [4e6, 8e6]).min, 1764250000123456793n);
  const { threshold } = await at('watches');
  same(threshold('Filter<3>.höhe > 4e-4 for 1 s'), { name: 'Filter<3>.höhe', limit: 0.0004 });
}

async function exactNumbers() {
  const [{ parsed, written }, { baseOf }] = [await at('connection'), await at('../panels/plot')];
  same(parsed('{"seed":{"$int":"18446744073709551615"},"text":"9007199254740993"}'), { seed: 18446744073709551615n, text: '9007199254740993' });
  same([written({ seed: 2n ** 60n, text: '7' }), parsed(written([0.1]))], ['{"seed":1152921504606846976,"text":"7"}', [0.1]]);
  const bases = [[1764250000123456789n, 1764250000123456793n], [5, 18446744073709551615n], [1e9 + 0.25, 1e9 + 0.5], [0.1, 0.2], [null, undefined]];
  same(bases.map((column) => baseOf([column])), [1764250000123456780n, 0, 1e9, 0, 0]);
}

/** What a tab in the background goes on with, and what waits for its return. */
async function background() {
  const [{ pulse }, { notices, notify }] = [await at('pulse'), await at('store')];
  await new Promise((done) => { const end = pulse(() => { end(); done(); }); });
  let timers = 0;
  const { setTimeout } = window;
  window.setTimeout = () => { timers += 1; };
  Object.defineProperty(document, 'hidden', { value: true, configurable: true });
  notify('done', 'unseen');
  const before = timers;
  delete document.hidden;
  document.dispatchEvent(new Event('visibilitychange'));
  window.setTimeout = setTimeout;
  same([before, timers, notices.value.some(({ text }) => text === 'unseen')], [0, 1, true]);
}

/** Enter that ends a conversion of an input method reaches no control. */
async function composing() {
  const field = document.body.appendChild(document.createElement('input'));
  const heard = [];
  field.addEventListener('keydown', ({ key }) => heard.push(key));
  for (const more of [{ isComposing: true }, { keyCode: 229 }, {}]) field.dispatchEvent(new KeyboardEvent('keydown', { key: 'Enter', bubbles: true, ...more }));
  field.remove();
  same(heard, ['Enter']);
}

async function keys() {
  const { namesOf } = await at('keys');
  const names = (key, code, held = '') => namesOf({ key, code, shiftKey: held.includes('S'), ctrlKey: held.includes('C'), altKey: held.includes('A') });
  same([names('[', 'Digit8', 'CA')[1], names('[', 'Digit5', 'A')[1]], ['[', '[']);
  same([names('&', 'Digit1'), names('é', 'Digit2'), names('1', 'Digit1', 'S'), names('!', 'Digit1', 'S')], [['&', '1'], ['é', '2'], ['1'], ['!']]);
  same([names('л', 'KeyK', 'C'), names('k', 'KeyK', 'C'), names('ArrowLeft', 'ArrowLeft', 'S')], [['Ctrl+л', 'Ctrl+k'], ['Ctrl+k'], ['Shift+ArrowLeft']]);
}

return Promise.all([texts, expressions, curves, exactNumbers, keys, background, composing].map((test) => test())).then(() => wrong);
