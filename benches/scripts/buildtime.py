#!/usr/bin/env python3
"""Measures compile times: `python3 benches/scripts/buildtime.py`.

- From a changed component to the end of its unit tests, and of its test in the whole tree: minimum of five changes.
- A clean release build of the facade.
- Debug builds of trees of 50 to 250 components, and of 255 state machines with 8 states each.

Fails if a time is above its limit. Other programs on the machine lengthen the wall-clock time, but hardly the processor time, so the
shorter of the two is compared with the limit.
"""

import shutil
import sys

from waiting import ROOT, report, run

COMPONENT = ROOT / "player/src/behaviour/face_ball.rs"
INSERTION_POINT = "head.look_at("
UNIT_TESTS = "cargo test --quiet --package bica-player --lib face_ball".split()
TREE_TEST = "cargo test --quiet --package bica-tests --test activation face_ball_runs".split()
RATES = ["", "(hz = 50)", "(hz = 20)", "(hz = 10)", "(hz = 5)"]
SIZES = [50, 100, 200, 250]
MACHINES, STATES = 255, 8
# Largest time per component in the largest tree, as a multiple of that in the smallest. It is above 1 because of the checks of the
# graph, which compare components with links.
GROWTH = 1.5


def after_changes(test):
    """Returns the shortest time of five runs of the test, each after a change of the component."""
    before = COMPONENT.read_text()
    if INSERTION_POINT not in before:
        sys.exit(f"{COMPONENT} has no `{INSERTION_POINT}` to change")
    times = []
    for number in range(5):
        run(*test)
        statement = f"core::hint::black_box({number});\n        {INSERTION_POINT}"
        try:
            COMPONENT.write_text(before.replace(INSERTION_POINT, statement, 1))
            times.append(run(*test))
        finally:
            COMPONENT.write_text(before)
    return min(times)


def facade():
    folder = ROOT / "target/buildtime"
    shutil.rmtree(folder, ignore_errors=True)
    run("cargo", "fetch", "--quiet")
    return run("cargo", "build", "--quiet", "--release", "--package", "bica", "--target-dir", str(folder))


def build(source):
    """Returns the time of the debug build of a program outside the workspace."""
    folder = ROOT / "target/buildtime-tree"
    (folder / "src").mkdir(parents=True, exist_ok=True)
    manifest = '[package]\nname = "tree"\nedition = "2024"\n\n[workspace]\n\n[dependencies]\n'
    (folder / "Cargo.toml").write_text(f'{manifest}bica = {{ path = "{ROOT}" }}\n')
    shutil.copy(ROOT / "Cargo.lock", folder)
    (folder / "src/main.rs").write_text(source)
    return run("cargo", "build", "--quiet", folder=folder)


def tree(components, bodies):
    names = ", ".join(f"C{number}" for number in range(components))
    tree = f"activation_tree! {{ struct Large {{ root: C0, cycle_hz: 100, components: [{names}] }} }}"
    main = "fn main() { let mut tree = Box::new(Large::new()); tree.tick(Instant::from_millis(0)); }"
    return "\n".join(["use bica::prelude::*;", *bodies, tree, main, ""])


def component(number, components):
    """Each component requires the two that follow, and every third one modulates the third that follows."""
    reads = range(number + 1, min(number + 3, components))
    writes = [number + 3] if number % 3 == 0 and number + 3 < components else []
    links = "".join([f", c{c}: &C{c}" for c in reads] + [f", c{c}: &mut C{c}" for c in writes])
    code = "".join([f" self.0 += c{c}.0;" for c in reads] + [f" c{c}.0 += 1;" for c in writes])
    return (
        f"struct C{number}(u32);\n#[component{RATES[number % 5]}]\nimpl C{number} {{ const fn new() -> Self {{ Self(0) }}"
        f" fn step(&mut self{links}) {{ self.0 /= 2;{code} }} }}"
    )


def machine(number, machines):
    """Each state of a machine modulates another of the machines that follow."""
    parts = []
    for state in range(STATES):
        child, kind = number + 1 + state, "state(initial)" if state == 0 else "state"
        link = f", _: &mut C{child}" if child < machines else ""
        parts.append(f"#[{kind}] fn s{state}(&mut self{link}) {{ self.0 += 1; }}")
        parts.append(f"#[transition(s{state} -> s{(state + 1) % STATES})] fn t{state}(&self) -> bool {{ self.0 % {state + 2} == 0 }}")
    body = "\n".join(parts)
    return f"struct C{number}(u32);\n#[component]\nimpl C{number} {{ const fn new() -> Self {{ Self(0) }}\n{body} }}"


def growth():
    """Prints the processor time per component of each size; returns the ratio of the largest tree to the smallest."""

    def least(size):
        source = tree(size, [component(number, size) for number in range(size)])
        return min((build(f"// {size}, {turn}\nfn main() {{}}\n"), build(source)[1])[1] for turn in range(3))

    one = least(1)
    each = {size: 1e3 * (least(size) - one) / size for size in SIZES}
    for size, time in each.items():
        print(f"{f'debug build of a tree of {size} components, per component':<70}{time:>14.1f} ms")
    return each[SIZES[-1]] / each[SIZES[0]]


def machines(number):
    return build(tree(number, [machine(place, number) for place in range(number)]))


def main():
    rows = [
        ("a change to a component, until its unit tests have run", after_changes(UNIT_TESTS), 1.5),
        ("the same, until its test in the whole tree has run", after_changes(TREE_TEST), 1.5),
        ("a clean `cargo build --release` of the facade", facade(), 60),
    ]
    machines(1)
    rows.append((f"a tree of {MACHINES} machines with {STATES} states each", machines(MACHINES), 40))
    late, ratio = report(rows), growth()
    if ratio > GROWTH:
        late.append(f"growth per component of {ratio:.2f}, limit {GROWTH}")
    if late:
        sys.exit("above its limit: " + "; ".join(late))


if __name__ == "__main__":
    main()
