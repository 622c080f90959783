#!/usr/bin/env python3
"""Times of VICODE for a component with 60 states and 200 transitions: the least of 20 runs of the command.

    cargo build --release -p bica-vicode && benches/scripts/edit_speed.py target/release/vicode

Each time includes the start of the process, reading the file, and all checks before and after the edit.
"""
import json, pathlib, subprocess, sys, tempfile, time

STATES, TRANSITIONS, RUNS = 60, 200, 20
LIMIT_MS = 350


def machine():
    text = "use crate::parts::{Ball, Head};\n\n#[component(hz = 30)]\nimpl Large {\n"
    for state in range(STATES):
        initial = "(initial)" if state == 0 else ""
        text += f"    /// What state {state} does.\n    #[state{initial}]\n"
        text += f"    fn state_{state}(&mut self, ball: &Ball, head: &mut Head) {{\n"
        text += "        head.look_at(ball.offset() * 0.5, self.tilt);\n    }\n\n"
    for one in range(TRANSITIONS):
        start, end = one % STATES, one * (1 + one // STATES * 6) % STATES
        end = (end + 1) % STATES if end == start else end
        text += f"    #[transition(state_{start} -> state_{end})]\n    fn go_{one}(&self, ball: &Ball) -> bool {{\n"
        text += f"        ball.is_seen() && self.n > {one}\n    }}\n\n"
    return text + "}\n"


EDITS = {
    "add a state": {"edit": "add_state", "name": "new"},
    "rename a state": {"edit": "rename", "function": "state_30", "to": "renamed"},
    "delete a state": {"edit": "delete", "function": "state_30"},
    "set a body": {"edit": "set_body", "function": "state_7", "body": "self.n = 1;"},
    "add a child": {"edit": "add_child", "function": "state_7", "child": "Net", "kind": "requirement", "import": "crate::parts"},
}


def least(command):
    times = []
    for _ in range(RUNS):
        start = time.perf_counter()
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        times.append((time.perf_counter() - start) * 1000)
    return min(times)


def main(vicode):
    with tempfile.TemporaryDirectory() as folder:
        file, edits = pathlib.Path(folder, "large.rs"), pathlib.Path(folder, "edits.json")
        file.write_text(machine())
        times = {"open": least([vicode, "model", file, "--json"]), "open and draw": least([vicode, "draw", file])}
        for name, edit in EDITS.items():
            edits.write_text(json.dumps([{"component": "Large", **edit}]))
            times["open and " + name] = least([vicode, "apply", file, "--edits", edits, "--dry-run"])
    for name, time_ms in times.items():
        print(f"{name:<26}{time_ms:>8.1f} ms (at most {LIMIT_MS})")
    return int(max(times.values()) > LIMIT_MS)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
