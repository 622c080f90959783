//! The geometry of drawings: no name covers a name or a box, no line runs through a box, and all can be read.

use jmanager_browser::{Page, Server, repository};
use serde_json::{Value, json};

use crate::designing::small_crate;
use crate::glance::{SMALL, show_in};
use crate::open_in;

/// Faults on the screen: `boxes`, `lines` and `names` are selectors.
const FAULTS: &str = r"
const [root, boxes, lines, names] = arguments;
const svg = document.querySelector(root);
if (!svg) return ['nothing is drawn'];
const faults = [];
const shown = (selector) => [...svg.querySelectorAll(selector)].filter((one) => one.getClientRects().length > 0);
const placed = (selector) => shown(selector).map((one) => ({ name: one.parentElement.ariaLabel ?? one.parentElement.textContent,
  ...one.getBoundingClientRect().toJSON() }));
const [all, labels] = [placed(boxes), placed(names)];
const around = svg.getBoundingClientRect();
for (const a of [...all, ...labels]) if (a.left < around.left || a.right > around.right || a.top < around.top ||
  a.bottom > around.bottom) faults.push(`${a.name} is outside`);
const covers = (a, others) => others.filter((b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom)
  .forEach((b) => faults.push(`${a.name} covers ${b.name}`));
all.forEach((a, at) => covers(a, all.slice(at + 1)));
labels.forEach((a, at) => covers(a, [...labels.slice(at + 1), ...all]));
for (const line of svg.querySelectorAll(lines)) {
  const [length, matrix] = [line.getTotalLength(), line.getScreenCTM()];
  for (let at = 0; at < length; at += 2) {
    const { x, y } = line.getPointAtLength(at).matrixTransform(matrix);
    const hit = all.find((box) => x > box.left + 1.5 && x < box.right - 1.5 && y > box.top + 1.5 && y < box.bottom - 1.5);
    if (hit) { faults.push(`a line crosses ${hit.name}`); break; }
  }
}
for (const one of shown('text, tspan')) {
  const size = Number.parseFloat(getComputedStyle(one).fontSize) * one.getScreenCTM().a;
  if (one.textContent && size < 10.99) faults.push(`${one.textContent} is ${size.toFixed(1)} px`);
}
return faults;
";

/// Boxes, lines and names of the designer's drawing.
const MACHINE: [&str; 4] = ["svg.machine", ".box > .body", ".arrow > .line", ".label > .ground"];

/// Lays out generated machines with 5 to 200 states, for a range of their numbers, and lists the faults.
const GENERATED: &str = r"
return import('/vicode/canvas/rows.js').then(({ arrange, layoutOf, ALL, CONDITIONS, NAMES }) => import('/vicode/canvas/labels.js')
  .then(async ({ labelWidth }) => {
let seed = 1; const random = (n) => { seed = (seed * 1103515245 + 12345) % 2147483648; return seed % n; };
const WORDS = ['look', 'ball', 'goal', 'approach', 'kick', 'wait', 'turn', 'search', 'far', 'lost', 'reached', 'penalized', 'again'];
const word = () => Array.from({ length: 1 + random(3) }, () => WORDS[random(WORDS.length)]).join('_');
const machine = (count) => {
  const states = Array.from({ length: count }, (_, at) => ({ name: `${word()}_${at}`, docs: random(2) ? 'Some words on it.' : '',
    asks: at % 5 ? [] : ['age of Marker'],
    initial: at === 0, last: false, hooks: random(6) ? [] : [{ role: 'entry', name: word() }],
    children: Array.from({ length: random(4) }, () => ({ child: word(), kind: 'requirement' })) }));
  const arrows = [];
  const add = (name, from, to, any) => arrows.push({ key: `t:${name}:${arrows.length}:${from}`, name, owner: name, from, to, any,
    after_ms: random(5) ? null : 1500, after: null, when: null, times: null });
  for (let at = 0; at < count * 2 + random(count); at += 1) add(word(), states[random(count)].name, states[random(count)].name, false);
  for (let at = 0; at < random(3); at += 1) add(word(), '*', states[random(count)].name, true);
  const to = states[random(count)].name; for (const { name } of states.filter(() => random(3) === 0)) add('sent_off', name, to, false);
  return { states, arrows };
};
const hit = (a, b, by = 0) => a.left < b.right - by && b.left < a.right - by && a.top < b.bottom - by && b.top < a.bottom - by;
const rect = (x, y, w, h) => ({ left: x - w / 2, right: x + w / 2, top: y - h / 2, bottom: y + h / 2 });
const path = document.createElementNS('http://www.w3.org/2000/svg', 'path');
const faults = []; 
const [from, until] = arguments;
for (let number = from; number < until; number += 1) {
  const count = 5 + Math.round(195 * (number / 300) ** 2);
  const own = machine(count);
  const shape = 0.8 + random(12) / 10;
  await arrange(own, shape);
  for (const level of [ALL, CONDITIONS, NAMES]) {
    const { boxes, courses, area } = layoutOf(own, level, shape);
    const all = [...boxes.values()].map((box) => ({ name: box.name, ...rect(box.x, box.y, box.width, box.height) }));
    const labels = level === NAMES ? [] : own.arrows.filter(({ key }) => courses.get(key).owner === key).map((arrow) => ({
      name: arrow.name, ...rect(...courses.get(arrow.key).label, labelWidth(arrow), 16) }));
    const say = (text) => faults.push(`machine ${number} of ${count} states, level ${level}: ${text}`);
    const inside = { left: area.x, right: area.x + area.width, top: area.y, bottom: area.y + area.height };
    for (const one of [...all, ...labels]) if (one.left < inside.left || one.right > inside.right || one.top < inside.top ||
      one.bottom > inside.bottom) say(`${one.name} is outside`);
    all.forEach((a, at) => all.slice(at + 1).forEach((b) => hit(a, b) && say(`${a.name} covers ${b.name}`)));
    labels.forEach((a, at) => { labels.slice(at + 1).forEach((b) => hit(a, b) && say(`the name ${a.name} covers ${b.name}`));
      all.forEach((b) => hit(a, b) && say(`the name ${a.name} covers the state ${b.name}`)); });
    for (const [key, d] of [...courses].flatMap(([key, course]) => course.d.split('M').slice(1).map((d) => [key, d]))) {
      const points = [...d.matchAll(/(-?[\d.]+) (-?[\d.]+)/g)].map(([, x, y]) => [Number(x), Number(y)]);
      points.slice(1).forEach(([x, y], at) => { const [px, py] = points[at];
        const part = { left: Math.min(x, px), right: Math.max(x, px), top: Math.min(y, py), bottom: Math.max(y, py) };
        all.forEach((box) => part.left < box.right - 0.5 && part.right > box.left + 0.5 && part.top < box.bottom - 0.5 &&
          part.bottom > box.top + 0.5 && say(`${key} crosses ${box.name}`)); });
    }
  }
}
return faults.slice(0, 8);
}));
";

/// Chooses every fourth state of the machine in turn, while only names of states are drawn. Returns the faults, the number of shown names
/// of transitions that touch a chosen state, and the number of all of them.
const CHOSEN: &str = r"
const [faults, ...selectors] = arguments;
const find = new Function(faults);
const frame = () => new Promise((done) => requestAnimationFrame(done));
const names = ['/vicode/sources.js', '/vicode/canvas/stage.js', '/vicode/canvas/rows.js'];
return Promise.all(names.map((one) => import(one))).then(async ([{ machine, selection }, { stage }, { NAMES }]) => {
  const found = [];
  let [shown, all] = [0, 0];
  stage.look.value = { ...stage.look.value, level: NAMES };
  for (const { key, name } of machine.value.states.filter((_, at) => at % 4 === 0)) {
    selection.value = [key];
    await frame().then(frame);
    // The size of letters follows from that of the window.
    found.push(...find(...selectors).filter((fault) => !fault.endsWith('px')).map((fault) => `${name} is chosen: ${fault}`));
    const labels = [...document.querySelectorAll('.machine.names .label.near')];
    shown += labels.filter((one) => one.getClientRects().length > 0).length;
    all += new Set(labels.map(({ dataset }) => stage.courses.get(dataset.key).owner)).size;
  }
  return { found, shown, all };
});
";

/// Returns the source of a machine with `states` states and `transitions` transitions.
pub(crate) fn large(states: usize, transitions: usize) -> String {
    let mut text =
        "use bica::prelude::*;\n\n#[derive(Debug)]\npub struct Large;\n\n#[component(hz = 30)]\nimpl Large {\n"
            .to_owned();
    for state in 0..states {
        let kind = if state == 0 { "(initial)" } else { "" };
        text +=
            &format!("    /// Part {state} of the work.\n    #[state{kind}]\n    fn state_{state}(&mut self) {{}}\n\n");
    }
    for transition in 0..transitions {
        let from = transition % states;
        let to = (from + 1 + transition / states * 3) % states;
        text += &format!(
            "    #[transition(state_{from} -> state_{to})]\n    fn change_{transition}(&self) -> bool {{\n        false\n    }}\n\n"
        );
    }
    text.truncate(text.len() - 1);
    text + "}\n"
}

/// Returns the faults of a drawing on the page. A drawing that the server has not laid out yet has three seconds until it has none.
pub(crate) async fn faults(page: &Page, root: &str, boxes: &str, lines: &str, names: &str) -> Value {
    let find = || page.run_with(FAULTS, vec![json!(root), json!(boxes), json!(lines), json!(names)]);
    let mut found = find().await;
    for _ in 0..20 {
        if found == json!([]) {
            break;
        }
        tokio::time::sleep(std::time::Duration::from_millis(150)).await;
        found = find().await;
    }
    found
}

#[tokio::test]
async fn generated_machines_are_laid_out_without_a_fault() {
    let server = Server::start("generated", &[]);
    let page = open_in(&server, SMALL).await;
    for from in (0..300).step_by(10) {
        assert_eq!(page.run_with(GENERATED, vec![json!(from), json!(from + 10)]).await, json!([]));
    }
    page.close().await;
}

#[tokio::test]
async fn the_machines_of_the_repository_can_be_read_at_fit() {
    let server = Server::start("readable", &["--source", &repository("")]);
    let page = open_in(&server, SMALL).await;
    show_in(&page, SMALL).await;
    page.press("6").await;
    // The files of failing compiler tests are no valid machines.
    let list = "return import('/vicode/sources.js').then(({ list }) => list.value?.filter(({ file }) => !file.includes('/fail/'))\
        .flatMap(({ file, components = [] }) => components.filter(({ machine }) => machine).map(({ key }) => [file, key])))";
    let machines = page.until("the sources are read", list).await;
    let machines = machines.as_array().expect("a list");
    assert!(machines.len() > 20, "{machines:?}");
    for one in machines {
        let open =
            "const [file, key] = arguments[0]; return import('/vicode/sources.js').then(({ open }) => open(file, key))";
        page.run_with(open, vec![one.clone()]).await;
        let shown = format!(
            "return String([document.querySelector('.bar .file')?.title, \
            document.querySelector('svg.machine')?.ariaLabel?.replace('States of ', '')]) === String({one})"
        );
        page.until(&format!("the machine {one}"), &shown).await;
        // How much is shown is chosen after that.
        page.rests().await;
        let [root, boxes, lines, names] = MACHINE;
        let found = faults(&page, root, boxes, lines, names).await;
        if found != json!([]) {
            page.screenshot("geometry").await;
        }
        assert_eq!(found, json!([]), "{one}");
    }
    page.close().await;
}

#[tokio::test]
async fn names_of_a_chosen_state_cover_nothing() {
    let source = small_crate("chosen");
    let text = large(60, 200).replace("(state_3 ->", "(* ->").replace("(state_5 -> state_6)", "(state_5 -> state_5)");
    source.write("src/large.rs", &text);
    let server = Server::with_sources("chosen", &source);
    let page = open_in(&server, SMALL).await;
    page.press("6").await;
    page.click("button", "Large", "Sources").await;
    page.counts("svg.machine.names .box", "=== 60").await;
    let arguments = [&[FAULTS][..], &MACHINE].concat().into_iter().map(|one| json!(one)).collect();
    let chosen = page.run_with(CHOSEN, arguments).await;
    page.screenshot("chosen").await;
    assert_eq!(chosen["found"], json!([]));
    let [shown, all] = ["shown", "all"].map(|one| chosen[one].as_u64().expect("a number"));
    assert!(shown * 10 >= all * 9, "{shown} of {all} names have room");
    let (x, y) = page.find("button", "State state_21", "").await.middle().await;
    page.drag((x, y), (x + 4.0, y + 4.0)).await;
    page.lacks("svg.machine.names").await;
    for _ in 0..8 {
        page.click("button", "Zoom in", "").await;
    }
    let [root, boxes, _, names] = MACHINE;
    let found = faults(&page, root, boxes, "none", names).await;
    page.screenshot("placed").await;
    let covers: Vec<_> =
        found.as_array().expect("faults").iter().filter(|one| one.to_string().contains(" covers ")).collect();
    assert!(covers.is_empty(), "{covers:?}");
    let left_out = "return document.querySelectorAll('.label.crowded').length";
    let left_out = page.run(left_out).await.as_u64().expect("a number");
    assert!(left_out < 40, "{left_out} names have no room");
    page.close().await;
}
