"""A robot's program for tests: its result is a known function of two parameters, with noise of the seed.

It imports little, so that it starts in a few milliseconds.
"""

import json
import os
import sys
import time

#: Where the objective is least.
OPTIMUM = {"Walk.speed": 0.3, "Walk.gain": 1.5}
PARAMS: list[dict[str, object]] = [
    {"name": "speed", "doc": "Speed.", "unit": "m/s", "kind": "f32", "min": 0.0, "max": 1.0, "default": 0.8},
    {"name": "gain", "doc": "Gain.", "unit": None, "kind": "f32", "min": 0.1, "max": 5.0, "default": 4.0},
    {"name": "steps", "doc": "Steps.", "unit": None, "kind": "u32", "min": 1, "max": 9, "default": 3},
    {"name": "careful", "doc": "Care.", "unit": None, "kind": "bool", "default": False},
]


def loss(settings: dict[str, float]) -> float:
    """Return the objective without noise."""
    x = settings.get("Walk.speed", 0.8) - OPTIMUM["Walk.speed"]
    y = settings.get("Walk.gain", 4.0) - OPTIMUM["Walk.gain"]
    return 10 * x * x + y * y + 1


def refuse(message: str) -> None:
    print(f"error: {message}", file=sys.stderr)
    sys.exit(2)


def settings_of(words: list[str]) -> dict[str, float]:
    known = {f"Walk.{param['name']}": param for param in PARAMS}
    values = {}
    for word in words:
        name, _, text = word.partition("=")
        if text in ("True", "False"):
            refuse(f"`{text}` is no truth value")
        if name not in known:
            refuse(f"there is no parameter `{name}`")
        values[name] = float({"true": "1", "false": "0"}.get(text, text))
    if values.get("Walk.speed", 0) > 0.95:
        refuse("a rule is broken")
    return values


def row(param: dict[str, object], values: dict[str, float]) -> dict[str, object]:
    value = values.get(f"Walk.{param['name']}", param["default"])
    texts = {"component": "Walk", "default": str(param["default"]).lower(), "value": str(value).lower(), "source": None}
    return {**{key: param[key] for key in ("name", "doc", "unit", "kind")}, **texts}


def play(options: dict[str, str], values: dict[str, float]) -> dict[str, object]:
    seed = int(options.get("--seed", "0"))
    once = os.path.join(options.get("--once", "/nowhere"), str(seed))
    if options.get("--crash") == str(seed) or ("--once" in options and not os.path.exists(once)):
        if "--once" in options:
            open(once, "w").close()
        os.abort()
    time.sleep(float(options.get("--slow", "0")))
    noise = (seed * 7919 % 101 / 101 - 0.5) / 10
    falls = int(values.get("Walk.speed", 0.8) < 0.1)
    world = options.get("--world", "flat")
    facts = {"figures": [{"name": "effort", "value": 2.0, "unit": "m"}], "wall_processor": "with FMA"}
    cost = None if values.get("Walk.gain", 4.0) < float(options.get("--none", "0")) else loss(values) + noise
    return {"schema": "test/1", "seed": seed, "world": world, "cost": cost, "falls": falls, "story": [], **facts}


def main(words: list[str]) -> None:
    command = words.pop(0) if words and not words[0].startswith("-") else "play"
    words = [word for word in words if word not in ("--json", "--force")]
    pairs = list(zip(words[::2], words[1::2], strict=True))
    values, options = settings_of([value for name, value in pairs if name == "--set"]), dict(pairs)
    if "--write" in options:
        with open(options["--write"], "w") as file:
            file.write("[Walk]\n" + "\n".join(f"{name[5:]} = {value}" for name, value in values.items()))
    elif command == "graph":
        print(json.dumps({"components": [{"name": "Walk", "params": PARAMS}]}))
    elif command == "params":
        print(json.dumps({"parameters": [row(param, values) for param in PARAMS]}))
    else:
        print(json.dumps(play(options, values)))


if __name__ == "__main__":
    main(sys.argv[1:])
